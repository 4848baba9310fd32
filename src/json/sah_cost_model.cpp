#include "coppice/json/sah_cost_model.h"

#include <nlohmann/json.hpp>

namespace coppice::inline v0 {

void to_json(nlohmann::json& json, const SahCostModel& model) {
    json = {{"traversal", model.traversal},
            {"intersection", model.intersection},
            {"empty_bonus", model.empty_bonus}};
    if (model.custom) json["custom"] = true;
}

}  // namespace coppice::inline v0
