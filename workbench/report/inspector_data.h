#pragma once

#include "report/exhibits.h"

#include <nlohmann/json_fwd.hpp>

namespace coppice::report {

/// What the page's script draws the tree inspector from (web/inspector_data.js reads it):
/// - `bounds`, `viewpoint`: numbers as they are;
/// - `positions`: three 16-bit fractions of the bounds each; those that fall together are one;
/// - `shades`: a byte a point, where the scene is points;
/// - `indices`: of triangles, each less its predecessor, zigzag, seven bits a byte; `index_count`;
/// - `trees`: of each its `levels` as [cells, empty ones, shown ones], and of the shown ones, level
///   by level, `boxes` (lower, upper: six 16-bit fractions), `shares` and `counts` (16 bits: 65535
///   (1 + log2(share) / 40), 65535 log2(1 + count) / 40).
/// Arrays are base64 text of little-endian numbers.
[[nodiscard]] nlohmann::json inspector_data(const Inspector& inspector);

}  // namespace coppice::report
