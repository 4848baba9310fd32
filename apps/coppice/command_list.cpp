// coppice list: the names that options take, from their registries.

#include "coppice/builders/method.h"
#include "coppice/builders/split_finder.h"
#include "coppice/sample/sampler.h"

#include "command.h"
#include "experiment/experiment_options.h"
#include "experiment/protocol.h"
#include "options.h"
#include "render/integrator.h"
#include "scenes/procedural.h"
#include "scenes/ray_sets.h"
#include "tracers/contestant.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace coppice::app {

namespace {

struct Section {
    std::string key;    ///< in the JSON
    std::string title;  ///< in the text, with the option that takes the names
    std::vector<std::pair<std::string, std::string>> entries;  ///< name, summary
};

template <typename Entry>
Section make_section(std::string key, std::string title, std::span<const Entry> registry) {
    Section section{std::move(key), std::move(title), {}};
    for (const Entry& entry : registry) {
        section.entries.emplace_back(entry.name, entry.summary);
    }
    return section;
}

std::vector<Section> all_sections() {
    return {
        make_section("primitives", "Primitives (--primitives)", lab::primitive_kind_registry()),
        make_section("protocols", "Protocols (--protocols)", lab::protocol_registry()),
        make_section("methods", "Methods (--method, --methods)", method_registry()),
        make_section("integrators", "Integrators (coppice render)", render::integrator_registry()),
        make_section("peers", "Peers (coppice bench; coppice experiment --methods)",
                     lab::peer_registry()),
        make_section("rays", "Rays (coppice trace, experiment; coppice bench: the first three)",
                     lab::ray_kind_registry()),
        make_section("splits", "SplitCandidate rules (--split)", split_finder_registry()),
        make_section("samplers", "Samplers (--sampler, --samplers)", sampler_registry()),
        make_section("procedural_scenes", "Procedural scenes (coppice generate)",
                     lab::procedural_registry())};
}

std::string sections_text() {
    std::string text;
    for (const Section& section : all_sections()) {
        if (section.entries.empty()) continue;  // peers, without Embree
        if (!text.empty()) text += '\n';
        text += section.title + ":\n";
        for (const auto& [name, summary] : section.entries) {
            text += fmt::format("  {:<13} {}\n", name, summary);
        }
    }
    return text;
}

std::string sections_json() {
    nlohmann::ordered_json json;
    for (const Section& section : all_sections()) {
        json[section.key] = nlohmann::ordered_json::array();
        for (const auto& [name, summary] : section.entries) {
            json[section.key].push_back({{"name", name}, {"summary", summary}});
        }
    }
    return json.dump(2) + '\n';
}

}  // namespace

Command add_list(CLI::App& program) {
    CLI::App* parser = program.add_subcommand(
        "list", "Show the names of methods, split rules, samplers and protocols");
    parser->allow_extras();
    const auto as_json = std::make_shared<bool>(false);
    add_switch(*parser, "--json", "Print JSON instead of text", [as_json] { *as_json = true; });
    parser->footer(
        "Examples:\n"
        "  coppice list\n"
        "  coppice list --json");
    return {parser, [as_json](Output& output) {
                output.print(*as_json ? sections_json() : sections_text());
            }};
}

}  // namespace coppice::app
