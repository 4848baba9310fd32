#pragma once

#include "coppice/export.h"

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace coppice::inline v0 {

/// A large block of uninitialized memory, aligned to at least 64 bytes. Uses huge pages where the
/// block is large and the system has them. Owns its memory and can release the end of it. The
/// memory may be reused for other contents in its lifetime, so that pages which have been touched
/// once need not be zeroed again by the system.
class COPPICE_EXPORT BigBuffer {
public:
    BigBuffer() = default;

    /// Allocates `byte_count` bytes. Throws std::bad_alloc if that fails.
    explicit BigBuffer(std::size_t byte_count);

    /// The size in bytes.
    [[nodiscard]] std::size_t byte_count() const noexcept { return byte_count_; }

    /// The memory from byte `offset` on as `count` elements of a trivial type. The elements have no
    /// values until they are written. `offset` must be a multiple of the type's alignment, and the
    /// elements must end within the buffer.
    template <typename T>
    [[nodiscard]] std::span<T> view(std::size_t offset, std::size_t count) const noexcept {
        static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
        return {reinterpret_cast<T*>(bytes_.get() + offset), count};
    }

    /// Shrinks the buffer to its first `byte_count` bytes; no effect if it is not longer. On Linux,
    /// a buffer in huge pages returns the pages after them to the system.
    void shrink(std::size_t byte_count);

private:
    struct Free {
        void operator()(std::byte* bytes) const noexcept;
    };

    std::unique_ptr<std::byte, Free> bytes_;
    std::size_t byte_count_ = 0;
};

}  // namespace coppice::inline v0
