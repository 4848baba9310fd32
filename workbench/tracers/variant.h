#pragma once

#include "coppice/builders/method.h"

#include <string>
#include <string_view>

namespace coppice::lab {

/// A method, perhaps with another sample than its own.
struct Variant {
    std::string_view method;  ///< its name in method_registry()
    BuildOptions options;
};

/// "fast@10%": a method with a sample of so many percent of the primitives, in (0, 100].
[[nodiscard]] std::string variant_name(std::string_view method, double percent);

/// What a name stands for: a method ("fast"), or one with a percentage ("fast@10%"). Throws
/// Error(invalid_argument) for a method that is not there and for a percentage outside (0, 100].
[[nodiscard]] Variant find_variant(std::string_view name);

}  // namespace coppice::lab
