#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/ray.h"
#include "coppice/geom/vec3.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <string>

namespace coppice::render {

/// A pinhole camera. `up` need not be perpendicular to the line of sight.
struct Camera {
    Vec3f eye{0.0F, 0.0F, 0.0F};
    Vec3f look_at{0.0F, 0.0F, -1.0F};
    Vec3f up{0.0F, 1.0F, 0.0F};
    double fov = 45.0;  ///< degrees from the lower to the upper edge of the image, in (0, 180)
};

/// What of a camera is given; the rest is chosen by frame_box().
struct CameraWish {
    std::optional<Vec3f> eye;
    std::optional<Vec3f> look_at;
    std::optional<Vec3f> up;
    std::optional<double> fov;  ///< else default_fov, or what suits the place chosen
};

/// Degrees, of a camera that sees a scene from outside.
inline constexpr double default_fov = 45.0;

/// A point of a camera in as few digits as people copy: to a ten-thousandth of `distance`, that
/// between its eye and what it looks at.
[[nodiscard]] Vec3f in_few_digits(Vec3d point, double distance);

/// A camera that sees all of a box in an image of `aspect` (width over height): from the side where
/// the box appears largest, a little from above. Up is y, or z for a box flat in z. What is wished
/// for is kept, and the rest chosen around it. An empty box is taken for the point 0. Throws
/// Error(limit) if the eye would be beyond the range of float.
[[nodiscard]] Camera frame_box(const Aabb& box, const CameraWish& wish, double aspect);

/// The same for points, closer: their own extent is looked at, not their box's, and from its front
/// if two opposite sides are alike: models mostly face +z if y is up, and -y if z is. Up is z, too,
/// if they stand on z = 0 and not on y = 0.
[[nodiscard]] Camera frame_points(std::span<const Vec3f> points, const CameraWish& wish,
                                  double aspect);

/// A place for a light that serves what a camera sees of a box: above and right of the eye, by part
/// of the distance to what it looks at; within the box if the eye is.
[[nodiscard]] Vec3f place_light(const Camera& camera, const Aabb& box);

/// The rays of a camera through the centres of an image's pixels.
class CameraRays {
public:
    /// Throws Error(invalid_argument) if the camera looks along its up vector or nowhere, if its
    /// field of view is outside (0, 180), or if the image has no pixels.
    CameraRays(const Camera& camera, int width, int height);

    /// Pixel (0, 0) is the upper left one. The direction has unit length.
    [[nodiscard]] Ray through(int x, int y) const noexcept { return at(x + 0.5, y + 0.5); }

    /// The ray through any point of the image, in pixels from its upper left corner.
    [[nodiscard]] Ray at(double x, double y) const noexcept;

private:
    Vec3f eye_;
    Vec3d forward_;
    Vec3d right_;  // to the right edge of the image
    Vec3d up_;     // to its upper edge
    int width_;
    int height_;
};

/// A vector as the program's options take it: "1,2,3".
[[nodiscard]] std::string vector_text(Vec3f v);

/// The options that give this camera again: "--eye=1,2,3 --look-at=0,0,0 --up=0,1,0 --fov=45".
[[nodiscard]] std::string camera_text(const Camera& camera);

/// Serializes all fields under their own names.
void to_json(nlohmann::json& json, const Camera& camera);

}  // namespace coppice::render
