#pragma once

#include <vector>

namespace coppice::inline v0 {

/// Frees the memory of an array. Neither clear() nor `array = {}` does: both keep the capacity.
template <typename T>
void free_memory(std::vector<T>& array) noexcept {
    std::vector<T>().swap(array);
}

}  // namespace coppice::inline v0
