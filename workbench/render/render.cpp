// The loop over an image: tiles are tasks, and every pixel depends on its own samples alone, summed
// in their order, so that threads change nothing. The pixel filter is a tent of two pixels' width,
// by placing the samples: each counts in one pixel only. A single sample goes through the middle.
// Source: [Pharr2016] sec. 7.8 (filters).

#include "render/render.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/base/timer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

namespace coppice::render {

namespace {

constexpr int tile_size = 16;
constexpr double progress_seconds = 0.1;  // between two reports

/// From a number in [0, 1) to an offset in (-1, 1), distributed as a tent.
double tent(double u) {
    return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * u);
}

void check(const RenderOptions& options) {
    const auto is_in = [](int value, int highest) { return value >= 1 && value <= highest; };
    if (!is_in(options.width, RenderOptions::max_size) ||
        !is_in(options.height, RenderOptions::max_size) ||
        !is_in(options.samples, RenderOptions::max_samples)) {
        throw Error(ErrorCode::invalid_argument,
                    "an image has 1 to " + std::to_string(RenderOptions::max_size) +
                        " pixels each way and 1 to " + std::to_string(RenderOptions::max_samples) +
                        " samples");
    }
}

/// One rendering at work.
class Rendering {
public:
    Rendering(const View& view, const Camera& camera, const Integrator& integrator,
              const RenderOptions& options, const RenderObserver& observer)
        : view_(view),
          rays_(camera, options.width, options.height),
          integrator_(integrator),
          options_(options),
          observer_(observer) {
        result_.image = Image(options.width, options.height);
    }

    RenderResult run() {
        columns_ = (options_.width + tile_size - 1) / tile_size;
        const int rows = (options_.height + tile_size - 1) / tile_size;
        const auto tile_count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows);
        run_with_threads(options_.threads, [&] {
            parallel_for_chunks(tile_count, 1, [&](std::size_t tile, std::size_t /*end*/) {
                render_tile(static_cast<int>(tile));
            });
        });
        result_.seconds = timer_.seconds();
        return std::move(result_);
    }

private:
    void render_tile(int tile) {
        const int left = tile % columns_ * tile_size;
        const int top = tile / columns_ * tile_size;
        RayCounts rays;
        std::uint64_t pixel_count = 0;
        for (int y = top; y < std::min(top + tile_size, options_.height); ++y) {
            for (int x = left; x < std::min(left + tile_size, options_.width); ++x) {
                if (observer_.is_stopped && observer_.is_stopped()) break;
                result_.image.at(x, y) = to_float(pixel(x, y, rays));
                ++pixel_count;
            }
        }
        finish_tile(rays, pixel_count);
    }

    Vec3d pixel(int x, int y, RayCounts& rays) const {
        const auto id = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.width) +
                        static_cast<std::uint32_t>(x);
        Vec3d sum;
        for (int sample = 0; sample < options_.samples; ++sample) {
            PixelSamples random(id, static_cast<std::uint32_t>(sample), options_.seed);
            const auto [u, v] = random.next_2d();
            const bool is_only_one = options_.samples == 1;
            const double across = is_only_one ? 0.0 : tent(u);
            const double down = is_only_one ? 0.0 : tent(v);
            const Ray ray = rays_.at(x + 0.5 + across, y + 0.5 + down);
            sum = sum + integrator_.sample(view_, ray, random, rays);
        }
        return integrator_.pixel_of(sum, options_.samples);
    }

    void finish_tile(const RayCounts& rays, std::uint64_t pixel_count) {
        const std::lock_guard lock(mutex_);
        result_.rays += rays;
        result_.pixel_count += pixel_count;
        const double now = timer_.seconds();
        if (!observer_.on_progress || now < next_progress_) return;
        next_progress_ = now + progress_seconds;
        const auto all = static_cast<double>(result_.image.pixels.size());
        observer_.on_progress(static_cast<double>(result_.pixel_count) / all, now);
    }

    const View& view_;
    CameraRays rays_;
    const Integrator& integrator_;
    const RenderOptions& options_;
    const RenderObserver& observer_;
    int columns_ = 0;  // of tiles
    Timer timer_;
    std::mutex mutex_;
    RenderResult result_;  // but for the pixels, under the mutex
    double next_progress_ = 0.0;
};

}  // namespace

RenderResult render(const View& view, const Camera& camera, const Integrator& integrator,
                    const RenderOptions& options, const RenderObserver& observer) {
    check(options);
    return Rendering(view, camera, integrator, options, observer).run();
}

}  // namespace coppice::render
