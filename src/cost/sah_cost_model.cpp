#include "coppice/cost/sah_cost_model.h"

#include "coppice/base/error.h"

#include <fmt/format.h>

#include <cmath>

namespace coppice::inline v0 {

void check(const SahCostModel& model) {
    const auto require = [](bool holds, const char* name, double value, const char* range) {
        if (holds) return;
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("{} {} is outside {}", name, value, range));
    };
    require(model.traversal >= 0.0 && std::isfinite(model.traversal), "traversal cost",
            model.traversal, "[0, inf)");
    require(model.intersection > 0.0 && std::isfinite(model.intersection), "intersection cost",
            model.intersection, "(0, inf)");
    require(model.empty_bonus >= 0.0 && model.empty_bonus < 1.0, "empty bonus", model.empty_bonus,
            "[0, 1)");
}

}  // namespace coppice::inline v0
