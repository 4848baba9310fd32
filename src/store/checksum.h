#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// A 64-bit checksum of bytes: XXH3 over the XXH3 hashes of the 1 MiB pieces, which are hashed in
/// parallel. Zero bytes have zero pieces.
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace coppice::inline v0
