#include "coppice/builders/bvh8_options.h"

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"

#include "builders/require_in_range.h"

#include <fmt/format.h>

namespace coppice::inline v0 {

void require_valid(const Bvh8Options& options) {
    require_valid(options.sample);
    require_in_range(options.cell_size == 0 || options.cell_size >= 64, "cell size",
                     options.cell_size, "[64, 2^32) and not 0");
    if (!(options.expected_rays >= 0.0)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("expected rays {} is outside [0, inf]", options.expected_rays));
    }
    require_thread_count(options.threads);
    require_valid(options.cost);
}

const char* name_of(Bvh8Preset preset) noexcept {
    switch (preset) {
        case Bvh8Preset::automatic:
            return "automatic";
        case Bvh8Preset::fast:
            return "fast";
        case Bvh8Preset::balanced:
            return "balanced";
        case Bvh8Preset::quality:
            return "quality";
    }
    return "unknown";
}

}  // namespace coppice::inline v0
