#pragma once

#include "render/image.h"
#include "render/integrator.h"
#include "scenes/camera.h"

#include <cstdint>
#include <functional>

namespace coppice::render {

/// The image that is asked for.
struct RenderOptions {
    static constexpr int max_size = 16384;
    static constexpr int max_samples = 65536;

    int width = 1280;        ///< pixels, in [1, max_size]
    int height = 720;        ///< the same
    int samples = 16;        ///< per pixel, in [1, max_samples]
    std::uint64_t seed = 1;  ///< same seed, same image
    int threads = 0;         ///< at most so many; 0 = all the hardware has
};

/// What wants to know how a rendering gets on; either may be empty.
struct RenderObserver {
    /// The share of the pixels that is done and the seconds so far. Called by any thread, but by
    /// one at a time and not all the time.
    std::function<void(double share, double seconds)> on_progress;
    /// Whether to stop, asked by all threads for every pixel.
    std::function<bool()> is_stopped;
};

/// An image, and what it took.
struct RenderResult {
    Image image;                    ///< pixels that were not reached are 0
    std::uint64_t pixel_count = 0;  ///< that are done: all, unless it was stopped
    RayCounts rays;
    double seconds = 0.0;  ///< wall clock

    [[nodiscard]] bool is_complete() const noexcept { return pixel_count == image.pixels.size(); }
};

/// Renders an image. Equal for equal arguments to the bit, whatever the number of threads. Throws
/// Error(invalid_argument) for a camera that sees nothing, see CameraRays, and for options out of
/// range.
[[nodiscard]] RenderResult render(const View& view, const Camera& camera,
                                  const Integrator& integrator, const RenderOptions& options,
                                  const RenderObserver& observer = {});

}  // namespace coppice::render
