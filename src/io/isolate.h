#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace coppice::inline v0 {

/// The limits of work in a separate process.
struct IsolationLimits {
    std::uint64_t memory_bytes;  ///< address space beyond what this process uses already
    std::uint64_t cpu_seconds;
};

/// The result of work in a separate process.
struct IsolatedResult {
    std::string bytes;    ///< bytes that the work returned
    std::string failure;  ///< why it returned nothing, a verb phrase such as "failed"; else empty
};

/// Calls `work` in a copy of this process and returns its result. Whatever it does to its memory,
/// this process is not affected: it may crash, loop forever or use up memory. Its output is
/// discarded. The copy has only the calling thread, so `work` must not need other threads or locks
/// that they may hold. If `work` throws, the result is a failure. Throws Error(io) if no copy can
/// be made.
[[nodiscard]] IsolatedResult run_isolated(const std::function<std::string()>& work,
                                          const IsolationLimits& limits);

}  // namespace coppice::inline v0
