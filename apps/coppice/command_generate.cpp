// coppice generate: a procedural scene as a file.

#include "coppice/io/save_mesh.h"

#include "command.h"
#include "interrupts.h"
#include "options.h"
#include "scenes/procedural.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace coppice::app {

namespace {

struct GenerateOptions {
    std::string kind;
    std::uint32_t triangle_count = 100'000;
    std::uint64_t seed = 1;
    std::string out;
};

std::vector<std::string_view> kind_names() {
    std::vector<std::string_view> names;
    for (const lab::ProceduralScene& scene : lab::procedural_registry()) {
        names.push_back(scene.name);
    }
    return names;
}

void generate(const GenerateOptions& options, Output& output) {
    const std::vector<std::string_view> names = kind_names();
    if (options.kind.empty()) {
        throw UsageError(
            fmt::format("generate: no KIND is given; there are: {}", fmt::join(names, ", ")));
    }
    require_name("KIND", options.kind, names);
    if (options.out.empty()) {
        throw UsageError("--out: no file is given; example: --out terrain.obj");
    }
    const TriangleMesh mesh =
        lab::make_procedural(options.kind, options.triangle_count, options.seed);
    {
        const DeferInterrupts whole_file;
        save_mesh(mesh.view(), options.out);
    }
    output.print(fmt::format("written: {} ({} triangles, {} vertices)\n", options.out,
                             mesh.triangles.size(), mesh.vertices.size()));
}

}  // namespace

Command add_generate(CLI::App& program) {
    CLI::App* parser = program.add_subcommand("generate", "Write a procedural scene to a file");
    parser->allow_extras();
    const auto options = std::make_shared<GenerateOptions>();
    parser->add_option("KIND", options->kind)->type_name("");
    add_whole(*parser, {"--triangles", "N", "About so many triangles", "100000"},
              options->triangle_count, 1, lab::max_procedural_triangles);
    add_whole(*parser, {"--seed", "N", "Same seed, same scene", "1"}, options->seed, 0,
              std::numeric_limits<std::int64_t>::max());
    add_text(*parser, {"-o,--out", "FILE", "The file to write: .obj or .ply", ""}, options->out);
    std::string kinds = "Kinds:\n";
    for (const lab::ProceduralScene& scene : lab::procedural_registry()) {
        kinds += fmt::format("  {:<10} {}\n", scene.name, scene.summary);
    }
    parser->footer(kinds +
                   "\nExamples:\n"
                   "  coppice generate terrain --triangles 1000000 -o terrain.ply\n"
                   "  coppice generate city --seed 7 --out city.obj");
    return {parser, [options](Output& output) {
                wipe_line_on_interrupt();
                generate(*options, output);
            }};
}

}  // namespace coppice::app
