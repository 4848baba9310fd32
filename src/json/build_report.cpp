#include "coppice/json/build_report.h"

#include "coppice/json/build_options.h"
#include "coppice/json/tree_statistics.h"

#include <nlohmann/json.hpp>

namespace coppice::inline v0 {
namespace {

nlohmann::json stage_json(const StageReport& stage) {
    return {{"wall_seconds", stage.wall_seconds},
            {"cpu_seconds", stage.cpu_seconds},
            {"items", stage.items}};
}

nlohmann::json stages_json(const StageReports& stages) {
    return {{"sample", stage_json(stages.sample)},
            {"build", stage_json(stages.build)},
            {"empty", stage_json(stages.empty)},
            {"refill", stage_json(stages.refill)},
            {"refine", stage_json(stages.refine)},
            {"total",
             {{"wall_seconds", stages.wall_seconds()}, {"cpu_seconds", stages.cpu_seconds()}}}};
}

nlohmann::json notes_json(const std::vector<BuildNote>& notes) {
    nlohmann::json array = nlohmann::json::array();
    for (const BuildNote& note : notes) {
        array.push_back({{"option", note.option}, {"reason", note.reason}});
    }
    return array;
}

}  // namespace

void to_json(nlohmann::json& json, const BuildEstimate& estimate) {
    json = {{"references", estimate.references},
            {"bytes", estimate.bytes},
            {"peak_bytes", estimate.peak_bytes},
            {"seconds", estimate.seconds}};
}

void to_json(nlohmann::json& json, const BuildReport& report) {
    json = {{"options", report.options},
            {"method", report.method},
            {"sample", report.sample},
            {"notes", notes_json(report.notes)},
            {"primitive_count", report.primitive_count},
            {"sample_count", report.sample_count},
            {"stages", stages_json(report.stages)},
            {"tree_bytes", report.tree_bytes},
            {"peak_bytes", report.peak_bytes},
            {"preset", name_of(report.preset)},
            {"preset_reason", report.preset_reason},
            {"estimate", nullptr},
            {"statistics", report.statistics}};
    if (report.estimate) json["estimate"] = *report.estimate;
}

}  // namespace coppice::inline v0
