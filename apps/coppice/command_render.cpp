// coppice render: a picture of a scene, traced with a tree of any method.

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/io/write_file.h"
#include "coppice/store/tree_file.h"

#include "command.h"
#include "interrupts.h"
#include "options.h"
#include "render/develop.h"
#include "render/encode_image.h"
#include "render/heat_map.h"
#include "render/render_report.h"
#include "render_arguments.h"
#include "rows/output_folder.h"
#include "scenes/load_triangles.h"
#include "scenes/room_view.h"
#include "scenes/scene_names.h"
#include "text/json_text.h"
#include "text/progress_line.h"
#include "tracers/memory_limit.h"
#include "tree_arguments.h"
#include "view_arguments.h"
#include "watched_build.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <variant>

namespace coppice::app {

namespace {

void check_output(const std::string& out) {
    const DeferInterrupts no_trace;
    lab::check_file_writable(out);
}

void write_image(const std::string& out, const render::Image& image, render::Display display,
                 const render::DevelopOptions& options) {
    const auto encode = [&] {
        const render::ImageFormat format = *render::format_of(out);
        if (format == render::ImageFormat::exr) return render::encode_exr(image);
        if (format == render::ImageFormat::pfm) return render::encode_pfm(image);
        return render::encode_png(render::develop(image, display, options));
    };
    const std::string contents = encode();
    const DeferInterrupts whole_file;
    write_file(out, contents);
}

double aspect_of(const render::RenderOptions& options) {
    return static_cast<double>(options.width) / options.height;
}

/// Throws Error(invalid_argument) if the camera that is asked for sees nothing.
void check_camera(const RenderRequest& request, const TriangleMesh& mesh) {
    const auto& [eye, look_at, up, fov] = request.camera;
    if (!eye && !look_at && !up) return;
    static_cast<void>(render::CameraRays(
        render::frame_points(mesh.vertices, request.camera, aspect_of(request.options)),
        request.options.width, request.options.height));
}

/// The camera and the lights for what a scene holds; tells the report of both.
render::Lighting set_up(const RenderRequest& request, const TriangleMesh& mesh,
                        const lab::TracedTree& tracer, render::Emitters emitters,
                        render::RenderReport& report) {
    const lab::ChosenCamera chosen =
        lab::choose_camera(mesh.view(), tracer, request.camera, aspect_of(request.options));
    report.camera = chosen.camera;
    report.is_camera_chosen = !request.camera.eye;
    report.is_camera_inside = chosen.is_inside;
    report.is_lamp_chosen = request.lamp_wish == LampWish::automatic;
    report.sky = request.sky;
    const bool has_lamp =
        request.lamp_wish == LampWish::given || (report.is_lamp_chosen && emitters.is_empty());
    if (has_lamp) {
        report.lamp = request.lamp;
        if (report.is_lamp_chosen) {
            report.lamp->position = render::place_light(report.camera, bounds_of(mesh.vertices));
        }
    }
    report.emitter_count = emitters.count();
    return {report.lamp, {request.sky, report.camera.up}, std::move(emitters)};
}

/// A tenth of the box's diagonal.
double default_ao_distance(const Aabb& box) {
    const double diagonal =
        std::hypot(box.extent(Axis::x), box.extent(Axis::y), box.extent(Axis::z));
    return std::max(0.1 * diagonal, double{std::numeric_limits<float>::min()});
}

/// A tree built for the mesh, or loaded; tells the report which and how long it took.
lab::TracedTree make_tree(const RenderRequest& request, TriangleMeshView mesh,
                          render::RenderReport& report, lab::ProgressLine& progress) {
    if (request.tree.empty()) {
        const Method& method = find_method(request.build.method);
        report.tree = method.tree();
        lab::AnyBuild built;
        watch_build(progress, report.scene + ": building",
                    lab::limit_memory(request.build.memory_limit_bytes, mesh),
                    [&](const BuildControl& control) {
                        built = lab::build_tree(mesh, options_of(request.build), control);
                    });
        report.build = std::move(built.report);
        report.build.method = method.name;
        return {mesh, std::move(built.tree)};
    }
    progress.show(report.scene + ": loading its tree");
    const Timer timer;
    SavedTree saved = load_tree(request.tree, fingerprint_of(mesh));
    report.tree = std::holds_alternative<KdTree>(saved.tree) ? TreeKind::kd : TreeKind::bvh8;
    report.tree_file = request.tree;
    report.build.method = saved.origin.method;
    lab::TracedTree tracer(mesh, std::move(saved.tree));
    report.tree_load_seconds = timer.seconds();
    return tracer;
}

/// Loads, builds and traces; the report has all but where the image is.
render::RenderResult render_scene(const RenderRequest& request, render::RenderReport& report,
                                  lab::ProgressLine& progress) {
    progress.show(report.scene + ": loading");
    LoadReport loaded;
    MeshAttributes attributes;
    const TriangleMesh mesh = lab::load_triangles(request.scenes.front(), &loaded, &attributes);
    report.load_seconds = loaded.load_seconds;
    report.triangle_count = mesh.view().size();
    report.warnings = attributes.warnings;

    report.integrator_options = request.integrator_options;
    if (report.integrator_options.ao_distance == 0.0) {
        report.integrator_options.ao_distance = default_ao_distance(bounds_of(mesh.vertices));
    }
    check_camera(request, mesh);  // before the build
    const auto tracer = make_tree(request, mesh.view(), report, progress);
    const render::Lighting lighting =
        set_up(request, mesh, tracer, render::Emitters(mesh.view(), attributes), report);
    const render::View view{&tracer, mesh.view(), &attributes, &lighting};
    const auto integrator =
        render::find_integrator(request.integrator).make(report.integrator_options);
    const CatchInterrupts interrupts;
    render::RenderObserver observer;
    observer.on_progress = [&](double share, double seconds) {
        progress.show(lab::bar_text(report.scene + ": rendering", share),
                      seconds * (1.0 - share) / std::max(share, 1e-6));
    };
    observer.is_stopped = [&] { return interrupts.caught(); };
    return render::render(view, report.camera, *integrator, request.options, observer);
}

void tell(const render::RenderReport& report, bool as_json, Output& output) {
    if (as_json) {
        output.print(lab::json_text(nlohmann::json(report)));
        return;
    }
    output.print(render::render_text(report) + fmt::format("written: {}\n", report.output));
}

void run_request(const RenderRequest& request, Output& output) {
    check_output(request.out);
    render::RenderReport report;
    report.scene = lab::scene_names(std::array{std::filesystem::path(request.scenes.front())})[0];
    report.file = request.scenes.front();
    report.integrator = request.integrator;
    report.options = request.options;
    const int available = hardware_thread_count();
    report.threads =
        request.options.threads > 0 ? std::min(request.options.threads, available) : available;

    lab::ProgressLine progress(stderr);
    const render::RenderResult result = render_scene(request, report, progress);
    progress.show(report.scene + ": writing");
    report.rays = result.rays;
    report.pixel_count = result.pixel_count;
    report.trace_seconds = result.seconds;
    report.output = request.out;
    const auto& integrator = render::find_integrator(request.integrator);
    render::DevelopOptions develop = request.develop;
    if (integrator.display == render::Display::cost) {
        if (develop.cost_scale == 0.0) develop.cost_scale = render::fitting_scale(result.image);
        report.cost_scale = develop.cost_scale;
    }
    write_image(request.out, result.image, integrator.display, develop);
    progress.clear();
    for (const std::string& warning : report.warnings) {
        print_message("warning: " + warning);
    }
    note_preset(report.build);
    note_vain_options(report.build.notes, report.build.method, report.build.primitive_count);
    tell(report, request.as_json, output);
    if (result.is_complete()) return;
    const double share =
        static_cast<double>(result.pixel_count) / static_cast<double>(result.image.pixels.size());
    throw Interrupted(
        fmt::format("interrupted: {:.1f} % of the pixels are done and written to {}, the rest is 0",
                    100.0 * share, request.out));
}

}  // namespace

Command add_render(CLI::App& program) {
    CLI::App* parser = program.add_subcommand("render", "Make a picture of a scene");
    parser->allow_extras();
    const auto request = std::make_shared<RenderRequest>();
    add_scenes(*parser, request->scenes)->type_name("");
    add_image(*parser, *request);
    add_camera(*parser, request->camera);
    add_light(*parser, *request);
    add_method(*parser, request->build, "Same seed, same image and sample");
    add_tree(*parser, request->tree);
    add_switch(*parser, "--json", "Print JSON instead of text",
               [request] { request->as_json = true; });
    parser->footer(
        "Examples:\n"
        "  coppice render scenes/dragon.obj -o dragon.png\n"
        "  coppice render scenes/dragon.obj -o dragon.exr --integrator path --spp 64 --size "
        "1920x1080\n"
        "  coppice render scenes/dragon.obj -o near.png --eye=-0.1,0.2,0.4 --look-at=0,0.1,0 --fov "
        "30\n"
        "  coppice build scenes/dragon.obj -o dragon.cpk\n"
        "  coppice render scenes/dragon.obj -o dragon.png --tree dragon.cpk\n"
        "The camera that is chosen is printed as options, to go on from.");
    return {parser, [parser, request](Output& output) {
                check_request(*parser, *request);
                check_tree_arguments(*parser, request->tree, request->scenes);
                refuse_vain_options(*parser, request->build, {.seeds_more = true});
                refuse_vain_image_options(*parser, *request);
                request->options.seed = request->build.seed;
                request->options.threads = request->build.threads;
                wipe_line_on_interrupt();
                run_request(*request, output);
            }};
}

}  // namespace coppice::app
