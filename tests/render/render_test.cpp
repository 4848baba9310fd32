#include "render/render.h"

#include "coppice/base/error.h"

#include "render/integrators/integrators.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>

namespace coppice::render {

namespace {

/// A mesh with all that is needed to render it.
struct Stage {
    TriangleMesh mesh;
    MeshAttributes attributes;
    Lighting lighting{.sky = {.color = Vec3f{1.0F, 1.0F, 1.0F}}};
    IntegratorOptions integrator_options{.ao_distance = 1e9};
    RenderOptions options{.width = 24, .height = 20, .samples = 4, .threads = 1};
    std::string method = "auto";

    /// One material for all triangles.
    void set_material(const Material& material) {
        attributes.materials = {material};
        attributes.triangle_materials.assign(mesh.triangles.size(), 0);
        lighting.emitters = Emitters(mesh.view(), attributes);
    }

    [[nodiscard]] RenderResult render(std::string_view integrator, const Camera& camera,
                                      const RenderObserver& observer = {}) const {
        const Method& how = find_method(method);
        const lab::TracedTree tracer(mesh.view(), how.options());
        const View view{&tracer, mesh.view(), &attributes, &lighting};
        return render::render(view, camera, *find_integrator(integrator).make(integrator_options),
                              options, observer);
    }
};

/// A sheet at y = 0 that fills the view of `from_above`, scaled.
Stage sheet(float scale) {
    Stage stage;
    stage.mesh = test::scaled(
        test::make_sheet(7, {-50.0F, 0.0F, -50.0F}, {100.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 100.0F}),
        scale);
    return stage;
}

Camera from_above(float scale) {
    return {{0.3F * scale, 3.0F * scale, 1.0F * scale}, {}, {0.0F, 1.0F, 0.0F}, 60.0};
}

void expect_all(const Image& image, Vec3f expected, float tolerance) {
    for (const Vec3f pixel : image.pixels) {
        for (const Axis axis : all_axes) {
            ASSERT_NEAR(pixel[axis], expected[axis], tolerance);
        }
    }
}

TEST(Render, SeesNoOcclusionOnAPlaneAtAnyScale) {
    for (const float scale : {1e-15F, 1e-3F, 1.0F, 1e4F, 1e12F}) {
        Stage stage = sheet(scale);
        stage.integrator_options.ao_distance = 1e3 * scale;
        expect_all(stage.render("ao", from_above(scale)).image, {1.0F, 1.0F, 1.0F}, 0.0F);
    }
}

TEST(Render, SeesHalfOfTheSkyInACorner) {
    // A floor and a wall: at the foot of the wall half of the sky is hidden.
    Stage stage;
    stage.mesh = test::joined(
        test::make_sheet(1, {-1e4F, 0.0F, 0.0F}, {2e4F, 0.0F, 0.0F}, {0.0F, 0.0F, 1e4F}),
        test::make_sheet(1, {-1e4F, 0.0F, 0.0F}, {2e4F, 0.0F, 0.0F}, {0.0F, 1e4F, 0.0F}));
    stage.options = {.width = 2, .height = 2, .samples = 1024, .threads = 1};
    const Camera camera{{0.0F, 1.0F, 1.0F}, {0.0F, 0.0F, 0.001F}, {0.0F, 1.0F, 0.0F}, 0.01};
    expect_all(stage.render("ao", camera).image, {0.5F, 0.5F, 0.5F}, 0.02F);
}

TEST(Render, LeavesAWhiteBodyInWhiteLightInvisible) {
    Stage stage;
    stage.mesh = test::make_sphere(20, 30);
    stage.set_material({.diffuse = {1.0F, 1.0F, 1.0F}});
    const Camera camera{{0.0F, 0.0F, 4.0F}, {}, {0.0F, 1.0F, 0.0F}, 35.0};
    expect_all(stage.render("path", camera).image, {1.0F, 1.0F, 1.0F}, 1e-5F);
    // Inside a grey emitter light goes on without end: e / (1 - k).
    stage.set_material({.diffuse = {0.5F, 0.5F, 0.5F}, .emission = {1.0F, 2.0F, 3.0F}});
    stage.integrator_options.max_depth = 40;
    stage.options = {.width = 4, .height = 4, .samples = 2048, .threads = 0};
    const Camera inside{{0.1F, 0.2F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 60.0};
    expect_all(stage.render("path", inside).image, {2.0F, 4.0F, 6.0F}, 0.25F);
}

TEST(Render, ShowsTheSkyInAMirror) {
    Stage stage = sheet(1.0F);
    stage.set_material({.diffuse = {}, .specular = {0.5F, 0.25F, 1.0F}, .illumination = 3});
    for (const char* integrator : {"whitted", "path"}) {
        const RenderResult result = stage.render(integrator, from_above(1.0F));
        expect_all(result.image, {0.5F, 0.25F, 1.0F}, 1e-6F);
        EXPECT_EQ(result.rays.reflection, result.rays.primary);
        EXPECT_EQ(result.rays.diffuse, 0U);
    }
    stage.integrator_options.max_depth = 0;
    expect_all(stage.render("whitted", from_above(1.0F)).image, {}, 0.0F);
}

TEST(Render, LightsAPlaneByTheCosineAndLeavesShadowsDark) {
    Stage stage = sheet(1.0F);
    stage.set_material({.diffuse = {0.4F, 0.4F, 0.4F}});
    stage.lighting.lamp = Lamp{{0.0F, 1e6F, 0.0F}, 0.0, 1.0};
    stage.lighting.sky.color = Vec3f{};
    stage.integrator_options.max_depth = 1;
    const RenderResult lit = stage.render("path", from_above(1.0F));
    expect_all(lit.image, {0.4F, 0.4F, 0.4F}, 1e-4F);
    EXPECT_EQ(lit.rays.shadow, lit.rays.primary);
    stage.lighting.lamp = Lamp{{0.0F, -1.0F, 0.0F}, 0.5, 1.0};  // on the other side
    const RenderResult dark = stage.render("path", from_above(1.0F));
    expect_all(dark.image, {}, 0.0F);
    EXPECT_EQ(dark.rays.shadow, 0U);
}

TEST(Render, ShowsNormalsOfTheFileAndDistances) {
    Stage stage = sheet(2.0F);
    const Camera camera{{0.0F, 4.0F, 0.0F}, {}, {0.0F, 0.0F, -1.0F}, 0.01};
    expect_all(stage.render("depth", camera).image, {4.0F, 4.0F, 4.0F}, 1e-4F);
    expect_all(stage.render("normal", camera).image, {0.0F, 1.0F, 0.0F}, 1e-6F);
    stage.attributes.normals.assign(stage.mesh.vertices.size(), Vec3f{3.0F, -4.0F, 0.0F});
    expect_all(stage.render("normal", camera).image, {-0.6F, 0.8F, 0.0F}, 1e-6F);
    stage.attributes.normals.front() = {};  // not near enough to be seen
    stage.attributes.triangle_normals.assign(stage.mesh.triangles.size(),
                                             {0, 1, MeshAttributes::none});
    expect_all(stage.render("normal", camera).image, {0.0F, 1.0F, 0.0F}, 1e-6F);
    const Camera away{{0.0F, 4.0F, 0.0F}, {0.0F, 8.0F, 0.0F}, {0.0F, 0.0F, -1.0F}, 10.0};
    expect_all(stage.render("depth", away).image, {}, 0.0F);
}

TEST(Render, DependsOnTheSeedAndNotOnThreadsOrTrees) {
    Stage stage;
    stage.mesh = test::make_terrain(12, 3);
    stage.options = {.width = 70, .height = 33, .samples = 3, .threads = 1};
    stage.lighting.lamp = Lamp{{0.5F, 3.0F, 0.5F}, 0.3};
    const Camera camera = frame_points(stage.mesh.vertices, {}, 2.0);
    const RenderResult one = stage.render("path", camera);
    EXPECT_TRUE(one.is_complete());
    for (const auto& [method, threads] : {std::pair{"auto", 2}, {"sampled", 0}, {"sweep", 1}}) {
        stage.method = method;
        stage.options.threads = threads;
        const RenderResult other = stage.render("path", camera);
        EXPECT_EQ(one.image.pixels, other.image.pixels) << method;
        EXPECT_EQ(one.rays.total(), other.rays.total());
    }
    stage.options.seed = 2;
    EXPECT_NE(one.image.pixels, stage.render("path", camera).image.pixels);
}

TEST(Render, StopsWhenAskedToAndTellsHowFarItGot) {
    Stage stage = sheet(1.0F);
    std::atomic<int> asked = 0;
    double told = -1.0;
    RenderObserver observer;
    observer.is_stopped = [&] { return ++asked > 100; };
    observer.on_progress = [&](double share, double /*seconds*/) { told = share; };
    const RenderResult result = stage.render("normal", from_above(1.0F), observer);
    EXPECT_FALSE(result.is_complete());
    EXPECT_EQ(result.pixel_count, 100U);
    EXPECT_EQ(result.rays.primary, 400U);
    EXPECT_EQ(result.image.at(0, 0), (Vec3f{0.0F, 1.0F, 0.0F}));
    EXPECT_EQ(result.image.at(23, 19), Vec3f());
    EXPECT_GT(told, 0.0);
}

TEST(Render, RefusesWhatIsNoImage) {
    Stage stage = sheet(1.0F);
    stage.options.samples = 0;
    EXPECT_THROW(static_cast<void>(stage.render("ao", from_above(1.0F))), Error);
    EXPECT_THROW(static_cast<void>(find_integrator("photon")), Error);
}

TEST(FramePoints, FillsTheImageFromTheFront) {
    const TriangleMesh ball = test::make_sphere(30, 40);
    const Camera camera = frame_points(ball.vertices, {}, 1.0);
    EXPECT_GT(camera.eye.z, 0.0F);
    // A ball of radius 1 in 45 degrees; its box would need twice that.
    EXPECT_NEAR(std::hypot(camera.eye.x, camera.eye.y, camera.eye.z), 1.02 / std::sin(0.3927),
                0.03);
    EXPECT_EQ(frame_points({}, {}, 1.0).look_at, Vec3f());
}

}  // namespace

}  // namespace coppice::render
