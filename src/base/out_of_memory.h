#pragma once

#include "coppice/base/error.h"

#include <filesystem>
#include <new>
#include <string>

namespace coppice::inline v0 {

/// Runs work at a door of the library: what lacks memory becomes Error(out_of_memory), whose
/// message begins with `what`, a text or the path of a file. Should there be none even for that, it
/// stays std::bad_alloc.
template <typename What, typename Work>
decltype(auto) with_memory_errors(const What& what, Work&& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::out_of_memory,
                    std::filesystem::path(what).string() + ": out of memory");
    }
}

}  // namespace coppice::inline v0
