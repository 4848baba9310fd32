#pragma once

#include "coppice/builders/build_options.h"

#include "experiment/experiment_options.h"
#include "experiment/protocol.h"
#include "rows/tree_form.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::lab {

/// What makes the trees of some rows: a protocol, one of our methods, or a peer. Its name is what
/// the rows have as their `protocol`.
struct Builder {
    std::string_view name;
    std::string_view summary;
    TreeForm form = TreeForm::kd;
    bool is_sampling = true;             ///< else there is only the tree of all primitives
    std::vector<std::string> samplers;   ///< at least one; "" for a builder that does not sample
    const Protocol* protocol = nullptr;  ///< null for methods and peers
};

/// A name that `ExperimentOptions::methods` may have, with one line on what it is.
struct MethodEntry {
    std::string_view name;
    std::string_view summary;
};

/// Our methods, except `auto`, which only chooses one of the others; then the peers.
[[nodiscard]] std::vector<MethodEntry> experiment_methods();

/// The builders of an experiment in the order of its rows: protocols, then methods.
/// Throws Error(invalid_argument) for a name that is not there.
[[nodiscard]] std::vector<Builder> builders_of(const ExperimentOptions& options);

/// One line on a builder. Throws Error(invalid_argument) for a name that is not there.
[[nodiscard]] std::string_view builder_summary(std::string_view builder);

/// The options of one build; `percent` in (0, 100]. Methods keep all of their own but the two costs
/// and the threads; peers have those of `base`.
[[nodiscard]] BuildOptions options_of(const Builder& builder, const KdOptions& base,
                                      const std::string& sampler, double percent,
                                      std::uint64_t seed);

}  // namespace coppice::lab
