#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// The checksum of a piece of memory: XXH3 (64 bits) over the XXH3 hashes of its pieces of 1 MiB,
/// which are hashed in parallel; of no bytes, that of no pieces.
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace coppice::inline v0
