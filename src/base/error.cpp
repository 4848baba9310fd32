#include "coppice/base/error.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace coppice::inline v0 {

std::string_view error_code_name(ErrorCode code) noexcept {
    constexpr std::array<std::string_view, 7> names{
        "invalid_argument", "io", "parse", "unsupported", "limit", "cancelled", "out_of_memory"};
    const auto index = static_cast<std::size_t>(code);
    return index < names.size() ? names[index] : "unknown";
}

Error::Error(ErrorCode code, const std::string& message)
    : std::runtime_error(message), code_(code) {}

Error file_error(ErrorCode code, std::string_view file, std::string_view message) {
    return {code, fmt::format("{}: {}", file, message)};
}

Error file_error(ErrorCode code, std::string_view file, std::size_t line,
                 std::string_view message) {
    return {code, fmt::format("{}:{}: {}", file, line, message)};
}

}  // namespace coppice::inline v0
