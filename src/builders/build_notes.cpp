// Finds the options that have no effect on a build, with the reason, for the build's report. Only
// options that differ from their defaults are considered.

#include "coppice/builders/build_report.h"
#include "coppice/builders/split_finder.h"

#include "builders/bvh8/plan.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coppice::inline v0 {
namespace {

class Notes {
public:
    // Adds a note if `is_vain`: the option differs from its default and has no effect.
    void add(bool is_vain, std::string_view option, std::string reason) {
        if (is_vain) notes_.push_back({std::string(option), std::move(reason)});
    }

    [[nodiscard]] std::vector<BuildNote> take() && { return std::move(notes_); }

private:
    std::vector<BuildNote> notes_;
};

// Notes on sampling options of a build that draws no sample, for the given reason.
void add_sample_notes(const SampleOptions& sample, bool has_preset_sampler,
                      const std::string& reason, Notes& notes) {
    const SampleOptions usual;
    const bool is_preset = has_preset_sampler && sample.sampler == bvh8::preset_sampler;
    notes.add(sample.sampler != usual.sampler && !is_preset, "sample.sampler", reason);
    notes.add(sample.custom_sampler != nullptr, "sample.custom_sampler", reason);
    notes.add(sample.seed != usual.seed, "sample.seed", reason);
    notes.add(sample.uniform_share != usual.uniform_share, "sample.uniform_share", reason);
}

// Notes on sampling options of a build that draws a sample.
void add_sampler_notes(const SampleOptions& sample, Notes& notes) {
    const SampleOptions usual;
    notes.add(sample.custom_sampler != nullptr && sample.sampler != usual.sampler, "sample.sampler",
              "replaced by sample.custom_sampler");
    notes.add(
        sample.uniform_share != usual.uniform_share && !sampler_of(sample).uses_uniform_share(),
        "sample.uniform_share", fmt::format("the sampler {} does not use it", sample.sampler));
}

void add_cost_notes(const SahCostModel& cost, Notes& notes) {
    if (!cost.custom) return;
    const SahCostModel usual;
    const char* const reason = "replaced by cost.custom";
    notes.add(cost.traversal != usual.traversal, "cost.traversal", reason);
    notes.add(cost.intersection != usual.intersection, "cost.intersection", reason);
    notes.add(cost.empty_bonus != usual.empty_bonus, "cost.empty_bonus", reason);
}

void add_split_notes(const KdOptions& options, bool is_sampled, Notes& notes) {
    const SplitOptions& split = options.split;
    const SplitOptions usual;
    notes.add(split.custom_rule != nullptr && split.rule != usual.rule, "split.rule",
              "replaced by split.custom_rule");
    notes.add(split.sample_weighting != usual.sample_weighting && !is_sampled,
              "split.sample_weighting",
              "no sample is drawn: all primitives are used with weight 1");
    if (split.termination == Termination::sah) {
        const char* const reason =
            "not used with termination sah, which splits while a split lowers the cost";
        notes.add(split.max_leaf != usual.max_leaf, "split.max_leaf", reason);
        notes.add(split.bad_refines != usual.bad_refines, "split.bad_refines", reason);
    } else if (options.leaf_refinement == LeafRefinement::none) {
        const char* const reason = "used only with termination sah or with leaf refinement";
        notes.add(split.min_split != usual.min_split, "split.min_split", reason);
        notes.add(split.max_duplication != usual.max_duplication, "split.max_duplication", reason);
    }
}

}  // namespace

std::vector<BuildNote> notes_on(const KdOptions& options, std::uint32_t primitive_count) {
    Notes notes;
    const bool is_sampled = sample_count(primitive_count, options.sample.rate) < primitive_count;
    if (is_sampled) {
        add_sampler_notes(options.sample, notes);
    } else {
        const bool is_asked_for = options.sample.rate < 1.0;
        notes.add(is_asked_for, "sample.rate",
                  fmt::format("a rate of {} selects all of {} primitives", options.sample.rate,
                              primitive_count));
        add_sample_notes(options.sample, false, "no sample is drawn: all primitives are used",
                         notes);
    }
    add_split_notes(options, is_sampled, notes);
    add_cost_notes(options.cost, notes);
    return std::move(notes).take();
}

std::vector<BuildNote> notes_on(const Bvh8Options& options, std::uint32_t primitive_count) {
    Notes notes;
    const Bvh8Options usual;
    const bvh8::Plan plan = bvh8::make_plan(options, primitive_count);
    const bool is_small = primitive_count < options.sampled_from;
    const bool is_sampled = plan.sampling.rate < 1.0;
    notes.add(options.sample.rate < 1.0 && is_small, "sample.rate",
              fmt::format("the scene has {} triangles; scenes of fewer than {} are not sampled "
                          "(sampled_from)",
                          primitive_count, options.sampled_from));
    if (!is_sampled) {
        add_sample_notes(options.sample, true, "no sample is drawn: all triangles are used", notes);
        const bool would_be = bvh8::make_plan(options, options.sampled_from).sampling.rate < 1.0;
        notes.add(options.sampled_from != usual.sampled_from && !would_be, "sampled_from",
                  "at a sample rate of 1 no scene is sampled");
        notes.add(options.cell_size != usual.cell_size && !plan.by_planes, "cell_size",
                  "without a sample there are no cells");
    } else if (options.sample.rate == 1.0) {
        const bool is_preset = options.sample.sampler == plan.sampling.sampler;
        notes.add(!is_preset && options.sample.sampler != usual.sample.sampler, "sample.sampler",
                  fmt::format("at a sample rate of 1 the preset {} draws its own sample ({})",
                              name_of(options.preset), plan.sampling.sampler));
    } else {
        add_sampler_notes(options.sample, notes);
    }
    notes.add(
        options.expected_rays != usual.expected_rays && options.preset != Bvh8Preset::automatic,
        "expected_rays", "only the preset automatic uses it");
    notes.add(options.cost.empty_bonus != usual.cost.empty_bonus && !options.cost.custom,
              "cost.empty_bonus", "8-wide trees are built with fixed cost constants");
    add_cost_notes(options.cost, notes);
    return std::move(notes).take();
}

}  // namespace coppice::inline v0
