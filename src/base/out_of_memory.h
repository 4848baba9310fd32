#pragma once

#include "coppice/base/error.h"

#include <filesystem>
#include <new>
#include <string>

namespace coppice::inline v0 {

/// Runs `work` at an entry point of the library and turns std::bad_alloc into Error(out_of_memory).
/// Its message starts with `what`, a text or the path of a file. If there is no memory even for the
/// message, std::bad_alloc is thrown.
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
