#include "scenes/camera.h"

#include "coppice/base/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace coppice::render {

namespace {

constexpr std::array boxes{
    Aabb{{-1.0F, -1.0F, -1.0F}, {1.0F, 1.0F, 1.0F}},
    Aabb{{10.0F, 0.0F, -3.0F}, {30.0F, 2.0F, 50.0F}},
    Aabb{{0.0F, 0.0F, 0.0F}, {100.0F, 100.0F, 1.0F}},
    Aabb{{0.0F, 0.0F, 0.0F}, {5.0F, 0.0F, 5.0F}},
    Aabb{{1e-30F, 0.0F, 0.0F}, {3e-30F, 2e-30F, 1e-30F}},
    Aabb{{-1e30F, -1e30F, -1e30F}, {1e30F, 1e30F, 1e30F}},
};

/// Where a point appears in the image: within [-1, 1] both ways if it is in view.
std::array<double, 2> image_point(const Camera& camera, double aspect, Vec3d point) {
    const CameraRays corner(camera, 1, 1);
    const Vec3d forward = to_double(corner.through(0, 0).direction);
    const Vec3d right_unnormalized = cross(forward, to_double(camera.up));
    const Vec3d right =
        (1.0 / std::sqrt(dot(right_unnormalized, right_unnormalized))) * right_unnormalized;
    const Vec3d offset = point - to_double(camera.eye);
    const double depth = dot(offset, forward);
    const double tan_half = std::tan(camera.fov * 3.14159265358979 / 360.0);
    return {dot(offset, right) / depth / tan_half / aspect,
            dot(offset, cross(right, forward)) / depth / tan_half};
}

TEST(FrameBox, HasAllCornersInView) {
    for (const Aabb& box : boxes) {
        for (const double aspect : {1.0, 2.0, 0.5}) {
            for (const double fov : {20.0, 45.0, 90.0}) {
                const Camera camera = frame_box(box, {.fov = fov}, aspect);
                for (unsigned i = 0; i < 8; ++i) {
                    const Vec3d corner = to_double({(i & 1) != 0 ? box.upper.x : box.lower.x,
                                                    (i & 2) != 0 ? box.upper.y : box.lower.y,
                                                    (i & 4) != 0 ? box.upper.z : box.lower.z});
                    for (const double coordinate : image_point(camera, aspect, corner)) {
                        EXPECT_LE(std::abs(coordinate), 1.0);
                    }
                }
                EXPECT_FALSE(box.contains(camera.eye));
            }
        }
    }
}

TEST(FrameBox, LooksFromALittleAbove) {
    for (const Aabb& box : boxes) {
        const Camera camera = frame_box(box, {}, 1.0);
        const Vec3d back = to_double(camera.eye) - to_double(camera.look_at);
        EXPECT_GT(dot(back, to_double(camera.up)), 0.0);
    }
    EXPECT_EQ(frame_box(boxes[0], {}, 1.0).up, (Vec3f{0.0F, 1.0F, 0.0F}));
    EXPECT_EQ(frame_box(boxes[2], {}, 1.0).up, (Vec3f{0.0F, 0.0F, 1.0F})) << "flat in z";
}

TEST(FrameBox, LooksAtTheLargestSide) {
    // A wall in the plane x = 0: the eye is in front of it and not beside it.
    const Camera camera = frame_box({{0.0F, 0.0F, 0.0F}, {0.1F, 5.0F, 10.0F}}, {}, 1.0);
    EXPECT_GT(std::abs(camera.eye.x - camera.look_at.x), std::abs(camera.eye.z - camera.look_at.z));
}

TEST(FrameBox, KeepsWhatIsWishedFor) {
    const Vec3f eye{1.0F, 2.0F, 3.0F};
    const Vec3f target{4.0F, 5.0F, 6.0F};
    const Vec3f up{0.0F, 0.0F, -1.0F};
    const Camera all = frame_box(boxes[0], {eye, target, up, 60.0}, 1.0);
    EXPECT_EQ(all.eye, eye);
    EXPECT_EQ(all.look_at, target);
    EXPECT_EQ(all.up, up);
    EXPECT_EQ(all.fov, 60.0);
    EXPECT_EQ(frame_box(boxes[0], {.eye = eye}, 1.0).look_at, Vec3f{});
    const Camera below = frame_box(boxes[0], {.up = up}, 1.0);
    EXPECT_LT(below.eye.z, 0.0F);
    EXPECT_EQ(frame_box(boxes[0], {.look_at = target}, 1.0).look_at, target);
}

TEST(FrameBox, TakesAnEmptyBoxForAPoint) {
    const Camera camera = frame_box(Aabb{}, {}, 1.0);
    EXPECT_EQ(camera.look_at, Vec3f{});
    EXPECT_NO_THROW(CameraRays(camera, 4, 4));
}

TEST(FrameBox, SaysThatAnEyeOutsideWouldBeBeyondFloat) {
    constexpr float utmost = std::numeric_limits<float>::max();
    const Aabb box{{-utmost, 0.0F, 0.0F}, {utmost, 1.0F, 1.0F}};
    EXPECT_THROW((void)frame_box(box, {}, 1.0), Error);
    EXPECT_NO_THROW((void)frame_box(box, {.eye = Vec3f{}}, 1.0));
}

TEST(PlaceLight, IsOutsideOrInsideWithTheEye) {
    for (const Aabb& box : boxes) {
        const Camera outside = frame_box(box, {}, 1.0);
        EXPECT_FALSE(box.contains(place_light(outside, box)));
    }
    const Aabb room{{0.0F, 0.0F, 0.0F}, {4.0F, 3.0F, 5.0F}};
    for (const Vec3f eye : {Vec3f{0.5F, 1.5F, 0.5F}, Vec3f{3.9F, 2.9F, 4.9F}}) {
        const Camera inside = frame_box(room, {.eye = eye}, 1.0);
        EXPECT_TRUE(room.contains(place_light(inside, room)));
    }
}

TEST(CameraRays, GoThroughPixelCentres) {
    const Camera camera{{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -2.0F}, {0.0F, 3.0F, 0.0F}, 90.0};
    const CameraRays rays(camera, 4, 2);
    const auto expect_direction = [&](int x, int y, Vec3d direction) {
        const Ray ray = rays.through(x, y);
        const double length = std::sqrt(dot(direction, direction));
        EXPECT_NEAR(ray.direction.x, direction.x / length, 1e-6);
        EXPECT_NEAR(ray.direction.y, direction.y / length, 1e-6);
        EXPECT_NEAR(ray.direction.z, direction.z / length, 1e-6);
        EXPECT_EQ(ray.origin, camera.eye);
        EXPECT_EQ(ray.t_min, 0.0F);
        EXPECT_TRUE(is_traceable(ray));
    };
    expect_direction(0, 0, {-1.5, 0.5, -1.0});
    expect_direction(3, 0, {1.5, 0.5, -1.0});
    expect_direction(1, 1, {-0.5, -0.5, -1.0});
}

TEST(CameraRays, RefuseWhatShowsNothing) {
    const Camera good;
    EXPECT_THROW(CameraRays(good, 0, 1), Error);
    EXPECT_THROW(CameraRays(good, 1, -1), Error);
    Camera along = good;
    along.up = {0.0F, 0.0F, 5.0F};
    EXPECT_THROW(CameraRays(along, 1, 1), Error);
    Camera nowhere = good;
    nowhere.look_at = nowhere.eye;
    EXPECT_THROW(CameraRays(nowhere, 1, 1), Error);
    for (const double fov : {0.0, 180.0, -1.0, std::nan("")}) {
        Camera odd = good;
        odd.fov = fov;
        EXPECT_THROW(CameraRays(odd, 1, 1), Error);
    }
}

TEST(Camera, IsSerializedWithAllFields) {
    const Camera camera{{1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}, {0.0F, 0.0F, 1.0F}, 30.0};
    EXPECT_EQ(nlohmann::json(camera),
              nlohmann::json(
                  {{"eye", {1, 2, 3}}, {"look_at", {4, 5, 6}}, {"up", {0, 0, 1}}, {"fov", 30.0}}));
}

}  // namespace

}  // namespace coppice::render
