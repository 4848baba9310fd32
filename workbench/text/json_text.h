#pragma once

#include "coppice/geom/vec3.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace coppice::lab {

/// How all JSON of the workbench is written. Names of files need not be valid UTF-8, but JSON must
/// be: bytes that are not are replaced.

/// A document as text, indented by two spaces, with a line end behind it.
template <typename Json>
[[nodiscard]] std::string json_text(const Json& document) {
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// A value in one line, without a line end.
template <typename Json>
[[nodiscard]] std::string json_line(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The same in ASCII: all other characters are escaped.
template <typename Json>
[[nodiscard]] std::string json_ascii_line(const Json& value) {
    return value.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// The document as its text is read back: all strings are valid UTF-8, and numbers that are not
/// finite are null.
template <typename Json>
[[nodiscard]] Json as_written(const Json& document) {
    return Json::parse(json_line(document));
}

/// A number, or null if it is not finite.
[[nodiscard]] nlohmann::ordered_json number_json(double number);

/// The same with the digits that a float needs.
[[nodiscard]] nlohmann::ordered_json number_json(float number);

/// A number, or null if there is none or it is not finite.
[[nodiscard]] nlohmann::ordered_json number_json(const std::optional<double>& number);

/// [x, y, z]
[[nodiscard]] nlohmann::ordered_json vector_json(Vec3f v);

}  // namespace coppice::lab
