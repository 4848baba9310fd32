#include "coppice/base/error.h"

#include <fmt/format.h>

namespace coppice::inline v0 {

std::string_view error_code_name(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::invalid_argument:
            return "invalid_argument";
        case ErrorCode::io:
            return "io";
        case ErrorCode::parse:
            return "parse";
        case ErrorCode::unsupported:
            return "unsupported";
        case ErrorCode::limit:
            return "limit";
        case ErrorCode::cancelled:
            return "cancelled";
        case ErrorCode::out_of_memory:
            return "out_of_memory";
    }
    return "unknown";
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
