#pragma once

#include "coppice/export.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace coppice::inline v0 {

/// What kind of failure an Error reports. The values are stable across releases.
enum class ErrorCode {
    invalid_argument,  ///< an option or argument outside its documented range
    io,                ///< a file could not be opened, read, written or renamed
    parse,             ///< a file's contents break its format
    unsupported,       ///< a legal input that this library does not support
    limit,             ///< a documented limit would be exceeded (a count, the memory limit)
    cancelled,         ///< the work was abandoned because cancellation was requested
    out_of_memory,     ///< the system could not provide memory
};

/// The stable lower-case name of an error code, e.g. "parse".
[[nodiscard]] COPPICE_EXPORT std::string_view error_code_name(ErrorCode code) noexcept;

/// The exception that the library throws for every failure it detects. `what()` is one line fit for
/// a user. It starts with its context where there is one: `bunny.obj:812: face index 90210 out of
/// range`.
class COPPICE_EXPORT Error : public std::runtime_error {
public:
    /// An error whose what() is `message`, unchanged.
    Error(ErrorCode code, const std::string& message);

    /// The kind of failure.
    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

/// An Error whose message starts with the file that it concerns: `file: message`.
[[nodiscard]] COPPICE_EXPORT Error file_error(ErrorCode code, std::string_view file,
                                              std::string_view message);

/// An Error whose message starts with the file and its 1-based line: `file:line: message`.
[[nodiscard]] COPPICE_EXPORT Error file_error(ErrorCode code, std::string_view file,
                                              std::size_t line, std::string_view message);

}  // namespace coppice::inline v0
