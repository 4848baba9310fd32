#include "experiment_arguments.h"

#include "coppice/base/named.h"
#include "coppice/builders/split_finder.h"
#include "coppice/sample/sampler.h"

#include "build_arguments.h"
#include "experiment/builders.h"
#include "experiment/protocol.h"
#include "options.h"
#include "tracers/contestant.h"
#include "view_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace coppice::app {

namespace {

void add_methods(CLI::App& parser, lab::ExperimentOptions& options) {
    const std::vector<lab::MethodEntry> entries = lab::experiment_methods();
    const auto names = names_in(std::span<const lab::MethodEntry>(entries));
    const auto read = [&options, names](const std::vector<std::string>& texts) {
        options.methods = parse_list("--methods", texts, "exact,binned,fast");
        for (const std::string& name : options.methods) {
            if (name.starts_with("embree") && lab::peer_registry().empty()) {
                throw UsageError(
                    "--methods: this program was built without Embree; install libembree-dev and "
                    "build it again");
            }
            require_name("--methods", name, names);
        }
    };
    add_list_option(
        parser, {"--methods", "LIST", listing("Builders as further rows", names), "none"}, read);
}

void add_samplers(CLI::App& parser, ExperimentRequest& request) {
    const auto names = names_in(sampler_registry());
    add_names(parser,
              {"--samplers", "LIST", listing("How samples are drawn, by each of these", names),
               "uniform; a method's own"},
              request.options.samplers, names);
    add_name(parser, {"--sampler", "NAME", "The same with one sampler", ""}, request.sampler,
             names);
}

void add_rays(CLI::App& parser, lab::ExperimentOptions& options) {
    const auto kinds = lab::ray_kind_registry();
    add_ray_kinds(
        parser,
        {"--rays", "LIST",
         listing("Trace trees of triangles: all, or kinds of rays", names_in(kinds)), "none"},
        kinds, options.rays);
    add_whole(parser, {"--size", "N", "N x N rays of each kind: the pixels of an image", "256"},
              options.size, 1, lab::ExperimentOptions::max_size);
    add_camera(parser, options.camera);
}

void add_what_to_run(CLI::App& parser, ExperimentRequest& request) {
    lab::ExperimentOptions& options = request.options;
    add_list_option(
        parser,
        {"--primitives", "LIST", "Trees over points, triangles or both", "points,triangles"},
        [&options](const std::vector<std::string>& texts) {
            const auto registry = lab::primitive_kind_registry();
            options.primitives.clear();
            for (const std::string& name : parse_list("--primitives", texts, "points,triangles")) {
                require_name("--primitives", name, names_in(registry));
                options.primitives.push_back(find_named(registry, name, "kind of primitive").kind);
            }
        });
    add_names(parser,
              {"--protocols", "LIST", "How a tree is made from its sample", "fixed,scaled,grown"},
              options.protocols, names_in(lab::protocol_registry()));
    add_methods(parser, options);
    add_list_option(parser,
                    {"--rates", "LIST", "Sample sizes in percent of the primitives, in (0, 100]",
                     "100,50,40,30,20,10,5,4,3,2,1"},
                    [&options](const std::vector<std::string>& texts) {
                        options.percents = parse_percents("--rates", texts);
                    });
    add_whole(parser, {"--seeds", "N", "Repeat all with the seeds 1 to N", "1"}, options.seed_count,
              1, lab::ExperimentOptions::max_seed_count);
    add_percentage(parser,
                   {"--tolerance", "PERCENT",
                    "What a recommended sample's tree may cost more than the full one", "2"},
                   request.tolerance_percent);
    add_switch(parser, "--no-pictures",
               "Leave pictures and tree inspector out of the report: quicker",
               [&options] { options.report_parts = lab::ReportParts::numbers; });
}

void add_how_to_build(CLI::App& parser, KdOptions& build) {
    add_name(parser,
             {"--split", "RULE",
              listing("Where nodes are split", names_in(split_finder_registry())), "sah"},
             build.split.rule, names_in(split_finder_registry()));
    add_costs(parser, build.cost);
    add_whole(parser, {"--max-depth", "N", "No leaf is deeper, 0 to 60", "50"},
              build.split.max_depth, 0, 60);
    add_whole(parser, {"--max-leaf", "N", "No node of so few sampled primitives is split", "32"},
              build.split.max_leaf, 1, std::numeric_limits<std::uint32_t>::max());
    add_whole(parser,
              {"--bad-refines", "N", "The N-th split on a path that does not pay is refused", "3"},
              build.split.bad_refines, 1, std::numeric_limits<int>::max());
    add_switch(parser, "--no-clip", "Cut boxes at planes instead of triangles (no perfect splits)",
               [&build] { build.split.clipping = Clipping::bounding_box; });
    add_threads(parser, build.threads);
}

}  // namespace

void add_experiment_arguments(CLI::App& parser, ExperimentRequest& request) {
    add_scenes(parser, request.scenes);
    add_what_to_run(parser, request);
    add_samplers(parser, request);
    add_rays(parser, request.options);
    add_how_to_build(parser, request.options.build);
    add_memory_limit(parser, request.options.memory_limit_bytes,
                     "Leave trees out that would take more with the scene: 512M, 2G");
    add_text(parser,
             {"--out", "DIR",
              "Folder for results.csv, results.json, report.html and experiment.json\n"
              "[default: out/SCENE; for several scenes out/SCENE-and-N-more]",
              ""},
             request.out);
    add_text(parser,
             {"--resume", "DIR", "Go on with the experiment in a folder that was cut short", ""},
             request.resume);
    add_text(parser,
             {"--replay", "FILE",
              "Run again what an experiment.json says, on the very same scenes;\n"
              "results go to the folder of that run with -replay behind it",
              ""},
             request.replay);
}

void finish_options(ExperimentRequest& request) {
    lab::ExperimentOptions& options = request.options;
    if (!request.sampler.empty()) {
        if (!options.samplers.empty()) {
            throw UsageError(
                "--sampler: --samplers is given as well; give all names to --samplers");
        }
        options.samplers = {request.sampler};
    }
    options.tolerance = request.tolerance_percent / 100.0;
    options.scenes.assign(request.scenes.begin(), request.scenes.end());
}

void refuse_vain_options(const CLI::App& parser, const lab::ExperimentOptions& options) {
    refuse_vain(parser, "--size", options.rays.empty(),
                "no rays are traced; name some with --rays");
    refuse_vain_view(parser, options.rays);
    const bool is_points = options.primitives == std::vector{lab::PrimitiveKind::points};
    refuse_vain(parser, "--no-clip", is_points, "points are not cut");
    const bool is_sampled = std::any_of(options.percents.begin(), options.percents.end(),
                                        [](double percent) { return percent < 100.0; });
    for (const char* const name : {"--sampler", "--samplers"}) {
        refuse_vain(parser, name, !is_sampled, "a sample of 100 % is all; add some to --rates");
    }
}

void refuse_other_options(const CLI::App& parser, const std::vector<std::string>& allowed,
                          const std::string& why) {
    for (const CLI::Option* option : parser.get_options({})) {
        const std::string name = option->get_name();
        const bool is_allowed = std::find(allowed.begin(), allowed.end(), name) != allowed.end();
        if (option->count() == 0 || is_allowed || name == "--out") continue;
        throw UsageError(fmt::format("{}: {}", name, why));
    }
}

}  // namespace coppice::app
