#pragma once

#include <vector>

namespace coppice::inline v0 {

/// Gives back what an array has allocated, which clear() and `array = {}` both keep.
template <typename T>
void free_memory(std::vector<T>& array) noexcept {
    std::vector<T>().swap(array);
}

}  // namespace coppice::inline v0
