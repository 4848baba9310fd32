// xxHash is compiled into this file, so that programs need not link it.
#define XXH_INLINE_ALL

#include "store/checksum.h"

#include "coppice/base/parallel.h"

#include <xxhash.h>

#include <bit>
#include <vector>

namespace coppice::inline v0 {

// The hashes of pieces are hashed in their memory representation.
static_assert(std::endian::native == std::endian::little);

std::uint64_t checksum(std::span<const std::byte> bytes) {
    constexpr std::size_t piece_bytes = std::size_t{1} << 20;
    std::vector<std::uint64_t> pieces((bytes.size() + piece_bytes - 1) / piece_bytes);
    parallel_for_chunks(bytes.size(), piece_bytes, [&](std::size_t begin, std::size_t end) {
        pieces[begin / piece_bytes] = XXH3_64bits(bytes.data() + begin, end - begin);
    });
    return XXH3_64bits(pieces.data(), pieces.size() * sizeof(std::uint64_t));
}

}  // namespace coppice::inline v0
