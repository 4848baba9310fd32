#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace coppice {

/// Storage for `byte_count` bytes, aligned to at least 64 and in huge pages where it is large and
/// the system has them (page faults and clearing were 11 % of a build). Throws std::bad_alloc.
[[nodiscard]] void* allocate_big(std::size_t byte_count);

/// Frees what allocate_big() gave.
void free_big(void* storage) noexcept;

/// An allocator on allocate_big() that leaves new elements of trivial types uninitialized.
template <typename T>
struct BigAllocator {
    using value_type = T;

    BigAllocator() = default;

    template <typename Other>
    explicit BigAllocator(const BigAllocator<Other>& /*other*/) noexcept {}

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocate_big(count * sizeof(T)));
    }

    void deallocate(T* storage, std::size_t /*count*/) noexcept { free_big(storage); }

    template <typename Other>
    void construct(Other* at) noexcept(noexcept(Other())) {
        ::new (static_cast<void*>(at)) Other;
    }

    template <typename Other, typename... Arguments>
    void construct(Other* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) Other(std::forward<Arguments>(arguments)...);
    }

    friend bool operator==(const BigAllocator&, const BigAllocator&) = default;
};

/// A vector for large arrays of plain data. `BigVector<T>(n)` does not clear its elements.
template <typename T>
using BigVector = std::vector<T, BigAllocator<T>>;

}  // namespace coppice
