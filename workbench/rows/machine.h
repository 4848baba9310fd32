#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace coppice::lab {

/// The machine that a result was measured on.
struct Machine {
    std::string cpu;                 ///< the processor's own name, "unknown" where it has none
    int cores = 1;                   ///< hardware threads that this process may use
    std::uint64_t memory_bytes = 0;  ///< installed
    std::string os;
    std::string kernel;
};

/// Asks the operating system. Never throws; what it cannot find out is "unknown" or 0.
[[nodiscard]] Machine find_machine();

/// Serializes all fields under their own names.
void to_json(nlohmann::json& json, const Machine& machine);

/// The time by UTC as a result records it: "2026-11-22T14:05:09Z".
[[nodiscard]] std::string utc_now();

/// A new result's `machine`: the machine, how this program was built, and the time by UTC.
[[nodiscard]] nlohmann::ordered_json provenance_json();

/// The version of coppice, e.g. "0.1.0".
[[nodiscard]] std::string_view coppice_version() noexcept;

/// The compiler of this program, e.g. "GCC 12.2.0".
[[nodiscard]] std::string_view compiler_name() noexcept;

/// How this program was built, e.g. "Release".
[[nodiscard]] std::string_view build_type() noexcept;

/// The compiler flags that were given in addition to the project's own.
[[nodiscard]] std::string_view compiler_flags() noexcept;

/// The revision that this program was built from: an abbreviated commit, with "-dirty" behind it
/// if files differed from it, or "unknown" outside a git checkout.
[[nodiscard]] std::string_view git_revision() noexcept;

}  // namespace coppice::lab
