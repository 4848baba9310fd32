#pragma once

#include "coppice/base/error.h"

#include <span>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

// Helpers for registries: arrays of entries that each have a member `name`.

/// The names of all entries in order, separated by commas: "fixed, scaled, grown".
template <typename Entry>
[[nodiscard]] std::string names_of(std::span<const Entry> entries) {
    std::string names;
    for (const Entry& entry : entries) {
        if (!names.empty()) names += ", ";
        names += entry.name;
    }
    return names;
}

/// The entry called `name`. Throws Error(invalid_argument) with a list of the existing names if
/// there is none. `what` is the singular noun for an entry, used in that message.
template <typename Entry>
[[nodiscard]] const Entry& find_named(std::span<const Entry> entries, std::string_view name,
                                      std::string_view what) {
    for (const Entry& entry : entries) {
        if (entry.name == name) return entry;
    }
    throw Error(ErrorCode::invalid_argument, "unknown " + std::string(what) + " '" +
                                                 std::string(name) +
                                                 "'; choose one of: " + names_of(entries));
}

}  // namespace coppice::inline v0
