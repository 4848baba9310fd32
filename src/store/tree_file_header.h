#pragma once

#include "coppice/store/fingerprint.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace coppice::inline v0 {

/// The header of a tree file, in its memory representation; see docs/formats.md. It is followed
/// without gaps by the nodes, the items (references of a k-d tree, blocks of an 8-wide tree), the
/// method's name and the options.
struct TreeFileHeader {
    /// The magic bytes. The first byte is not text, and the line ends detect a transfer in text
    /// mode.
    static constexpr std::array<unsigned char, 8> own_magic{0x89, 'c',  'p',  'k',
                                                            '\r', '\n', 0x1a, '\n'};
    static constexpr std::uint32_t own_byte_order = 0x01020304;
    static constexpr std::uint32_t other_byte_order = 0x04030201;
    /// The format version. Increase it with every change of this header, of a node or a block, or
    /// of their meaning.
    static constexpr std::uint32_t own_version = 1;

    enum Kind : std::uint32_t { kd = 0, bvh8 = 1 };

    std::array<unsigned char, 8> magic = own_magic;
    std::uint32_t byte_order = own_byte_order;
    std::uint32_t version = own_version;
    std::uint32_t kind = kd;
    std::uint32_t header_bytes = 192;
    std::uint32_t node_bytes = 0;  ///< size of one node
    std::uint32_t item_bytes = 0;  ///< size of one item
    std::uint64_t node_count = 0;
    std::uint64_t item_count = 0;
    std::uint64_t method_bytes = 0;
    std::uint64_t options_bytes = 0;
    Fingerprint primitives;
    std::array<float, 6> bounds{};  ///< lower x, y, z, upper x, y, z
    std::uint64_t node_checksum = 0;
    std::uint64_t item_checksum = 0;
    std::uint64_t text_checksum = 0;  ///< of the method's name and the options
    std::array<std::uint64_t, 5> unused{};
    std::uint64_t header_checksum = 0;  ///< of all bytes before it
};

// The size is a multiple of the alignment of nodes and blocks.
static_assert(sizeof(TreeFileHeader) == 192 && std::is_trivially_copyable_v<TreeFileHeader>);

}  // namespace coppice::inline v0
