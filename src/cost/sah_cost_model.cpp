#include "coppice/cost/sah_cost_model.h"

#include "coppice/base/error.h"

#include "cost/split_cost.h"

#include <fmt/format.h>

#include <cmath>

namespace coppice::inline v0 {

double SahCostModel::split_cost(double p_below, double count_below, double p_above,
                                double count_above) const noexcept {
    if (custom) return custom->split_cost(p_below, count_below, p_above, count_above);
    const bool cuts_off_empty_space = count_below == 0.0 || count_above == 0.0;
    const double factor = cuts_off_empty_space ? 1.0 - empty_bonus : 1.0;
    return sah::scalar::split_cost(traversal, intersection * factor, p_below, count_below, p_above,
                                   count_above);
}

void require_valid(const SahCostModel& model) {
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
