#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace coppice::report {

/// `text` safe inside HTML text and inside quoted attributes.
[[nodiscard]] std::string escape_html(std::string_view text);

/// `json` as text that is safe inside a `<script type="application/json">`: no `<` is left in it.
/// Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string script_json(const nlohmann::json& json);

/// `javascript` safe inside a `<script>`, without its pointer to a source map.
[[nodiscard]] std::string script_text(std::string_view javascript);

/// `text` as lower-case letters, digits and single dashes, fit for an id; "unnamed" if none is
/// left.
[[nodiscard]] std::string make_slug(std::string_view text);

/// `text` with its first letter in upper case, where that is of the Latin alphabet.
[[nodiscard]] std::string capitalize(std::string text);

/// A count with thousands separators, "871,414"; fractions keep three digits. "–" if not finite.
[[nodiscard]] std::string format_count(double count);

/// A sample percentage as it was given, "0.5 %", with a no-break space.
[[nodiscard]] std::string format_percent(double percent);

/// A factor to about three digits: "0.0332", "0.44", "1.71", "12.3", "1,024".
[[nodiscard]] std::string format_ratio(double ratio);

/// A share of 1 in percent to about three digits, "2.59 %", with a no-break space.
[[nodiscard]] std::string format_share(double share);

/// Seconds as a duration with its unit: "0 s", "31 µs", "4.2 ms", "1.83 s".
[[nodiscard]] std::string format_duration(double seconds);

/// Seconds as the number of milliseconds, for columns headed "ms": "<0.001", "4.20", "1,830".
[[nodiscard]] std::string format_milliseconds(double seconds);

/// Bytes with a binary unit, "15.6 GiB".
[[nodiscard]] std::string format_bytes(double bytes);

/// "points, triangles and lines".
[[nodiscard]] std::string join_words(const auto& words) {
    std::string joined;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) joined += i + 1 < words.size() ? ", " : " and ";
        joined += words[i];
    }
    return joined;
}

}  // namespace coppice::report
