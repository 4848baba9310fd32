#pragma once

#include "coppice/base/error.h"

#include <new>
#include <string>
#include <string_view>

namespace coppice {

/// Runs work at a door of the library: what lacks memory becomes Error(out_of_memory), whose
/// message begins with `what`. Should there be none even for that, it stays std::bad_alloc.
template <typename Work>
decltype(auto) with_memory_errors(std::string_view what, Work&& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::out_of_memory, std::string(what) + ": out of memory");
    }
}

}  // namespace coppice
