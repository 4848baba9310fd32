#pragma once

#include "coppice/geom/triangle_mesh.h"

#include "experiment/builders.h"
#include "experiment/experiment.h"
#include "rows/results.h"
#include "text/remaining_time.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace coppice::lab {

/// The percentage of the trees that others are relative to.
inline constexpr double all_percent = 100.0;

/// What is known of a scene before its trees are built.
struct SceneFile {
    std::string name;
    std::filesystem::path file;
    std::vector<PrimitiveKind> kinds;
    std::uint64_t vertex_count = 0;
    std::uint64_t triangle_count = 0;

    [[nodiscard]] double count_of(PrimitiveKind kind) const {
        return static_cast<double>(kind == PrimitiveKind::points ? vertex_count : triangle_count);
    }
};

/// What all scenes of a run share.
struct ExperimentRun {
    const ExperimentOptions& options;
    const ExperimentObserver& observer;
    std::vector<Builder> builders;
    RemainingTime remaining;

    void tell(const ExperimentProgress& progress) const {
        if (observer.on_progress) observer.on_progress(progress);
    }

    void note(const std::string& text) const {
        if (observer.on_note) observer.on_note(text);
    }

    [[nodiscard]] bool lists_all_percent() const {
        return std::count(options.percents.begin(), options.percents.end(), all_percent) > 0;
    }

    /// The percentages that are rows, as asked for.
    [[nodiscard]] std::vector<double> listed(const Builder& builder) const {
        return builder.is_sampling ? options.percents : std::vector{all_percent};
    }

    /// The percentages to build, the reference first.
    [[nodiscard]] std::vector<double> build_order(const Builder& builder) const {
        std::vector<double> order = listed(builder);
        std::erase(order, all_percent);
        order.insert(order.begin(), all_percent);
        return order;
    }
};

/// Whether a builder takes primitives of a kind.
[[nodiscard]] inline bool is_built_over(const Builder& builder, PrimitiveKind kind) {
    return builder.form == TreeForm::kd || kind == PrimitiveKind::triangles;
}

/// Builds and measures all trees of one scene; adds the rows to `result`, which has the view of the
/// rays if there are any.
void run_scene_trees(ExperimentRun& run, const SceneFile& scene, const TriangleMesh& mesh,
                     SceneResult& result);

}  // namespace coppice::lab
