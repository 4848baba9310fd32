#pragma once

#include "coppice/builders/kd_options.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace coppice::lab {

/// A way to go from a sample to a tree of all primitives. Maps the options that all protocols
/// share (split rule, costs, threads ...) to those of one build.
struct Protocol {
    std::string_view name;
    std::string_view summary;
    /// `rate` in (0, 1]; sets the sample's rate and seed, the leaf limit and the growth.
    KdOptions (*options)(const KdOptions& base, double rate, std::uint64_t seed);
};

/// All protocols, in the order in which they are run by default.
[[nodiscard]] std::span<const Protocol> protocol_registry();

/// The protocol of that name. Throws Error(invalid_argument) naming those that exist.
[[nodiscard]] const Protocol& find_protocol(std::string_view name);

}  // namespace coppice::lab
