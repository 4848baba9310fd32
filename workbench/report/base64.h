#pragma once

#include <string>
#include <string_view>

namespace coppice::report {

/// Bytes as text of A-Z, a-z, 0-9, `+`, `/`, padded with `=`: RFC 4648, section 4.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace coppice::report
