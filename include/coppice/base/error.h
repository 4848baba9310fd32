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
    unsupported,       ///< a legal input that this library cannot work on
    limit,             ///< a documented limit would be passed (counts, a limit on memory)
    cancelled,         ///< the work was given up because a stop was requested
    out_of_memory,     ///< the system has no more memory to give
};

/// The stable lower-case name of a code, e.g. "parse".
[[nodiscard]] COPPICE_EXPORT std::string_view error_code_name(ErrorCode code) noexcept;

/// Every exception the library throws on its own account. `what()` is one line fit for a user,
/// prefixed with its context where there is one: `bunny.obj:812: face index 90210 out of range`.
class COPPICE_EXPORT Error : public std::runtime_error {
public:
    /// `message` is what() word for word.
    Error(ErrorCode code, const std::string& message);

    /// What kind of failure it is.
    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

/// An Error whose message starts with the file at fault: `file: message`.
[[nodiscard]] COPPICE_EXPORT Error file_error(ErrorCode code, std::string_view file,
                                              std::string_view message);

/// An Error whose message starts with the file and its 1-based line: `file:line: message`.
[[nodiscard]] COPPICE_EXPORT Error file_error(ErrorCode code, std::string_view file,
                                              std::size_t line, std::string_view message);

}  // namespace coppice::inline v0
