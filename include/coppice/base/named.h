#pragma once

#include "coppice/base/error.h"

#include <span>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

// What all registries of named entries have in common; an entry has a member `name`.

/// The names of a registry's entries, in order: "fixed, scaled, grown".
template <typename Entry>
[[nodiscard]] std::string names_of(std::span<const Entry> entries) {
    std::string names;
    for (const Entry& entry : entries) {
        if (!names.empty()) names += ", ";
        names += entry.name;
    }
    return names;
}

/// The entry of that name. Throws Error(invalid_argument) naming those that exist; `what` is the
/// singular word for an entry.
template <typename Entry>
[[nodiscard]] const Entry& find_named(std::span<const Entry> entries, std::string_view name,
                                      std::string_view what) {
    for (const Entry& entry : entries) {
        if (entry.name == name) return entry;
    }
    throw Error(ErrorCode::invalid_argument, "no " + std::string(what) + " '" + std::string(name) +
                                                 "'; there are: " + names_of(entries));
}

}  // namespace coppice::inline v0
