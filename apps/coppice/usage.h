#pragma once

#include "coppice/geom/vec3.h"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::app {

/// Wrong use of the program: one line on what is wrong and how to mend it. Exit code 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The values that a numeric option takes.
struct NumberRange {
    double lowest;
    double highest;
    std::string_view text;     ///< completes "is not ...": "a number in [0, 1)"
    bool is_lowest_in = true;  ///< whether `lowest` itself is allowed
    bool is_highest_in = true;
};

/// The number that `text` writes, all of it. Throws UsageError naming the option, the range and
/// `example`.
[[nodiscard]] double parse_number(std::string_view option, std::string_view text,
                                  const NumberRange& range, std::string_view example);

/// The whole number in [lowest, highest] that `text` writes. Throws UsageError.
[[nodiscard]] std::int64_t parse_whole(std::string_view option, std::string_view text,
                                       std::int64_t lowest, std::int64_t highest,
                                       std::string_view example);

/// The items of comma lists, trimmed, each once, in order. Throws UsageError for an empty item.
[[nodiscard]] std::vector<std::string> parse_list(std::string_view option,
                                                  std::span<const std::string> texts,
                                                  std::string_view example);

/// The percentages in (0, 100] of comma lists, each once, in order; a trailing "%" is allowed.
/// Throws UsageError.
[[nodiscard]] std::vector<double> parse_percents(std::string_view option,
                                                 std::span<const std::string> texts);

/// The share in (0, 1] that `text` writes, as a percentage (`1%`) or a number (`0.01`). Throws
/// UsageError.
[[nodiscard]] double parse_share(std::string_view option, std::string_view text);

/// The bytes, at least 1, that `text` writes: a number, and K, M, G or T for powers of 1024 (also
/// as KB or KiB). Throws UsageError.
[[nodiscard]] std::uint64_t parse_bytes(std::string_view option, std::string_view text);

/// The three finite numbers that `text` writes, with commas between. Throws UsageError.
[[nodiscard]] Vec3f parse_vector(std::string_view option, std::string_view text);

/// A width and a height in pixels.
struct PixelSize {
    int width;
    int height;
};

/// The size that `text` writes as `1280x720`, both in [1, highest]. Throws UsageError.
[[nodiscard]] PixelSize parse_size(std::string_view option, std::string_view text, int highest);

/// Throws UsageError unless `name` is among `names`, with the nearest one or all of them.
void require_name(std::string_view option, std::string_view name,
                  std::span<const std::string_view> names);

/// " (did you mean 'grown'?)" if one of the names is near enough to be meant, else nothing.
[[nodiscard]] std::string suggestion(std::string_view name,
                                     std::span<const std::string_view> names);

}  // namespace coppice::app
