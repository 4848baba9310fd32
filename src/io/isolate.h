#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace coppice::inline v0 {

/// What work in a process of its own may take.
struct IsolationLimits {
    std::uint64_t memory_bytes;  ///< beyond what this process has already
    std::uint64_t cpu_seconds;
};

/// How it ended.
struct IsolatedResult {
    std::string bytes;    ///< what it returned
    std::string failure;  ///< why it returned nothing, to complete "it ..."; else empty
};

/// Calls `work` in a copy of this process and hands its result over. Whatever it does to its
/// memory, this process is not touched: it may crash, run without end or take all memory. What it
/// prints is lost. The copy has no threads but the calling one: `work` must not need others, nor
/// locks that others may hold. If it throws, it fails. Throws Error(io) if there can be no copy.
[[nodiscard]] IsolatedResult run_isolated(const std::function<std::string()>& work,
                                          const IsolationLimits& limits);

}  // namespace coppice::inline v0
