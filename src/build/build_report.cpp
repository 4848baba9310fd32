#include "coppice/build/build_report.h"

#include <nlohmann/json.hpp>

namespace coppice {

void to_json(nlohmann::json& json, const BuildReport& report) {
    json = {{"options", report.options},
            {"primitive_count", report.primitive_count},
            {"sample_count", report.sample_count},
            {"seconds",
             {{"sample", report.seconds.sample},
              {"build", report.seconds.build},
              {"empty", report.seconds.empty},
              {"refill", report.seconds.refill},
              {"refine", report.seconds.refine},
              {"total", report.seconds.total()}}},
            {"statistics", report.statistics}};
}

}  // namespace coppice
