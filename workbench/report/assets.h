#pragma once

#include <string_view>

namespace coppice::report {

/// The files that report.html is made of, as they were when the program was built.
struct Assets {
    std::string_view page_html;     ///< the skeleton, with {{name}} where the results go
    std::string_view page_css;      ///< its style
    std::string_view page_js;       ///< draws the charts, sorts the tables
    std::string_view inspector_js;  ///< draws the tree inspector, with three.js
    std::string_view vega;          ///< the chart library, for browsers
    std::string_view vega_lite;     ///< its chart language, for browsers
    std::string_view vega_embed;    ///< puts charts into a page, for browsers
    std::string_view vega_license;
    std::string_view vega_lite_license;
    std::string_view vega_embed_license;
    std::string_view d3_license;  ///< of the d3 modules inside vega
    std::string_view three_license;
    std::string_view thesis_csv;  ///< the thesis's published tables
};

/// The embedded files; they live as long as the program.
[[nodiscard]] const Assets& embedded_assets() noexcept;

}  // namespace coppice::report
