#pragma once

#include "coppice/export.h"

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace coppice::inline v0 {

/// A large piece of uninitialized memory, aligned to at least 64 bytes and in huge pages where it
/// is large and the system has them. Owns it; can give back its end. What it is used for may change
/// in its life: a page that has been touched once need not be cleared again.
class COPPICE_EXPORT BigBuffer {
public:
    BigBuffer() = default;

    /// Throws std::bad_alloc.
    explicit BigBuffer(std::size_t byte_count);

    /// Its size.
    [[nodiscard]] std::size_t byte_count() const noexcept { return byte_count_; }

    /// The memory from `offset` on as `count` elements of a trivial type, which need not have
    /// values yet. The offset must be a multiple of their alignment.
    template <typename T>
    [[nodiscard]] std::span<T> view(std::size_t offset, std::size_t count) const noexcept {
        static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
        return {reinterpret_cast<T*>(bytes_.get() + offset), count};
    }

    /// Gives back all but the first `byte_count` bytes.
    void shrink(std::size_t byte_count);

private:
    struct Free {
        void operator()(std::byte* bytes) const noexcept;
    };

    std::unique_ptr<std::byte, Free> bytes_;
    std::size_t byte_count_ = 0;
};

}  // namespace coppice::inline v0
