// coppice render: a picture of a scene, traced with a tree of any method.

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"
#include "coppice/io/load_mesh.h"
#include "coppice/io/write_file.h"
#include "coppice/store/tree_file.h"

#include "build_arguments.h"
#include "command.h"
#include "interrupts.h"
#include "options.h"
#include "render/develop.h"
#include "render/encode_image.h"
#include "render/heat_map.h"
#include "render/render_report.h"
#include "rows/output_folder.h"
#include "scenes/room_view.h"
#include "scenes/scene_names.h"
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

constexpr double infinity = std::numeric_limits<double>::max();

/// Where the lamp is to be.
enum class LampWish { automatic, none, given };

/// The options as the parser fills them in.
struct RenderRequest {
    std::vector<std::string> scenes;
    std::string out;
    std::string integrator{"whitted"};
    render::IntegratorOptions integrator_options{.ao_distance = 0.0};  // 0: by the scene's size
    render::RenderOptions options;
    render::CameraWish camera;
    LampWish lamp_wish = LampWish::automatic;
    render::Lamp lamp;
    std::optional<Vec3f> sky;
    render::DevelopOptions develop{.cost_scale = 0.0};  // 0: by the image
    MethodRequest build;
    std::string tree;
    bool as_json = false;
};

void add_image(CLI::App& parser, RenderRequest& request) {
    add_text(parser, {"-o,--out", "FILE", "The image to write: .png, .exr or .pfm", ""},
             request.out);
    add_name(parser,
             {"--integrator", "NAME",
              listing("What is shown", names_in(render::integrator_registry())), "whitted"},
             request.integrator, names_in(render::integrator_registry()));
    const auto read_size = [&options = request.options](const std::string& given) {
        const PixelSize size = parse_size("--size", given, render::RenderOptions::max_size);
        options.width = size.width;
        options.height = size.height;
    };
    parser.add_option_function<std::string>("--size", read_size, "Pixels of the image")
        ->type_name("WxH")
        ->default_str("1280x720");
    add_whole(parser, {"--spp", "N", "Samples per pixel", "16"}, request.options.samples, 1,
              render::RenderOptions::max_samples);
    add_number(parser, {"--exposure", "STOPS", "Brighter by so many factors of 2 (.png)", "0"},
               request.develop.exposure, {-100.0, 100.0, "a number in [-100, 100]"});
    add_number(parser,
               {"--cost-scale", "N", "Steps at the end of the heat map (cost, .png)", "100"},
               request.develop.cost_scale, {0.0, infinity, "a finite number > 0", false});
    parser.get_option("--cost-scale")->default_str("by the image");
}

void add_light(CLI::App& parser, RenderRequest& request) {
    const auto read_lamp = [&request](const std::string& given) {
        if (given == "auto" || given == "none") {
            request.lamp_wish = given == "auto" ? LampWish::automatic : LampWish::none;
            return;
        }
        request.lamp_wish = LampWish::given;
        request.lamp.position = parse_vector("--light", given);
    };
    parser
        .add_option_function<std::string>("--light", read_lamp,
                                          "Where the lamp is: X,Y,Z, none, or auto: near the\n"
                                          "camera, unless the scene has light of its own")
        ->type_name("WHERE")
        ->default_str("auto");
    add_number(parser, {"--light-radius", "R", "Size of the lamp: softness of its shadows", "0"},
               request.lamp.radius, {0.0, infinity, "a finite number >= 0"});
    const auto read_sky = [&request](const std::string& given) {
        const Vec3f color = parse_vector("--sky", given);
        if (std::min({color.x, color.y, color.z}) < 0.0F) {
            throw UsageError(
                fmt::format("--sky: '{}' has a negative number; example: --sky 1,1,1", given));
        }
        request.sky = color;
    };
    parser.add_option_function<std::string>("--sky", read_sky, "Light from where no surface is")
        ->type_name("R,G,B")
        ->default_str("blue, white at the top_tree");
    add_whole(parser, {"--max-depth", "N", "Reflections and bounces in a row at most", "8"},
              request.integrator_options.max_depth, 0, 1000);
    add_number(parser, {"--ao-distance", "D", "What is further away does not occlude (ao)", "0.5"},
               request.integrator_options.ao_distance,
               {0.0, infinity, "a finite number > 0", false});
    parser.get_option("--ao-distance")->default_str("a tenth of the scene");
}

/// What is given for another integrator or another kind of file.
void refuse_vain_image_options(const CLI::App& parser, const RenderRequest& request) {
    const render::IntegratorEntry& integrator = render::find_integrator(request.integrator);
    const auto format = render::format_of(request.out);
    const bool is_png = format == render::ImageFormat::png;
    const bool is_light = integrator.display == render::Display::light;
    const bool is_cost = integrator.display == render::Display::cost;
    refuse_vain(parser, "--exposure", !is_png, ".exr and .pfm hold the light itself; write a .png");
    refuse_vain(parser, "--cost-scale", !is_png, ".exr and .pfm hold the steps; write a .png");
    const std::string no_light =
        fmt::format("--integrator {} shows no light; whitted and path do", integrator.name);
    for (const char* const name :
         {"--exposure", "--light", "--light-radius", "--sky", "--max-depth"}) {
        refuse_vain(parser, name, !is_light, no_light);
    }
    refuse_vain(parser, "--light-radius", request.lamp_wish == LampWish::none,
                "--light none leaves no lamp");
    refuse_vain(parser, "--cost-scale", !is_cost, "only --integrator cost has a heat map");
    refuse_vain(parser, "--ao-distance", integrator.display != render::Display::share,
                "only --integrator ao goes by it");
}

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
                        const render::RayTracer& tracer, render::Emitters emitters,
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
std::unique_ptr<render::RayTracer> make_tree(const RenderRequest& request, TriangleMeshView mesh,
                                             render::RenderReport& report,
                                             lab::ProgressLine& progress) {
    if (request.tree.empty()) {
        const Method& method = find_method(request.build.method);
        report.tree = method.tree();
        render::AnyBuild built;
        watch_build(progress, report.scene + ": building",
                    lab::limit_memory(request.build.memory_limit_bytes, mesh),
                    [&](const BuildControl& control) {
                        built = render::build_tree(mesh, options_of(request.build), control);
                    });
        report.build = std::move(built.report);
        report.build.method = method.name;
        return render::make_tracer(std::move(built.tree), mesh);
    }
    progress.show(report.scene + ": loading its tree");
    const Timer timer;
    SavedTree saved = load_tree(request.tree, fingerprint_of(mesh));
    report.tree = std::holds_alternative<KdTree>(saved.tree) ? TreeKind::kd : TreeKind::bvh8;
    report.tree_file = request.tree;
    report.build.method = saved.origin.method;
    auto tracer = render::make_tracer(std::move(saved.tree), mesh);
    report.tree_load_seconds = timer.seconds();
    return tracer;
}

/// Loads, builds and traces; the report has all but where the image is.
render::RenderResult render_scene(const RenderRequest& request, render::RenderReport& report,
                                  lab::ProgressLine& progress) {
    progress.show(report.scene + ": loading");
    LoadReport loaded;
    MeshAttributes attributes;
    const TriangleMesh mesh = load_mesh(request.scenes.front(), &loaded, &attributes);
    if (mesh.triangles.empty()) {
        throw file_error(ErrorCode::unsupported, request.scenes.front(),
                         "a point cloud: it has no triangles to render");
    }
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
        set_up(request, mesh, *tracer, render::Emitters(mesh.view(), attributes), report);
    const render::View view{tracer.get(), mesh.view(), &attributes, &lighting};
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
        // File names need not be UTF-8; JSON must be.
        output.print(
            nlohmann::json(report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
            '\n');
        return;
    }
    output.print(render::render_text(report) + fmt::format("written: {}\n", report.output));
}

void check_request(const CLI::App& parser, RenderRequest& request) {
    require_scenes(parser, request.scenes);
    if (request.scenes.size() > 1) {
        throw UsageError(
            fmt::format("render: one scene at a time; '{}' is a second one", request.scenes[1]));
    }
    if (request.out.empty()) {
        throw UsageError("--out: no file is given; example: --out image.png");
    }
    if (!render::format_of(request.out)) {
        throw UsageError(
            fmt::format("--out: '{}' ends in none of .png, .exr and .pfm; example: --out image.png",
                        request.out));
    }
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
