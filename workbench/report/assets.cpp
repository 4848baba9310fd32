#include "report/assets.h"

#include <cstddef>

// coppice_embed (cmake/CoppiceTargets.cmake) defines these two for each file in assets.cmake.
#define COPPICE_EMBEDDED(symbol) extern "C" const char symbol##_begin[], symbol##_end[]
COPPICE_EMBEDDED(coppice_report_page_html);
COPPICE_EMBEDDED(coppice_report_page_css);
COPPICE_EMBEDDED(coppice_report_page_js);
COPPICE_EMBEDDED(coppice_report_inspector_js);
COPPICE_EMBEDDED(coppice_report_vega);
COPPICE_EMBEDDED(coppice_report_vega_lite);
COPPICE_EMBEDDED(coppice_report_vega_embed);
COPPICE_EMBEDDED(coppice_report_vega_license);
COPPICE_EMBEDDED(coppice_report_vega_lite_license);
COPPICE_EMBEDDED(coppice_report_vega_embed_license);
COPPICE_EMBEDDED(coppice_report_d3_license);
COPPICE_EMBEDDED(coppice_report_three_license);
COPPICE_EMBEDDED(coppice_report_thesis_csv);
#undef COPPICE_EMBEDDED

namespace coppice::report {
namespace {

std::string_view text(const char* begin, const char* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

const Assets& embedded_assets() noexcept {
    static const Assets assets{
        .page_html = text(coppice_report_page_html_begin, coppice_report_page_html_end),
        .page_css = text(coppice_report_page_css_begin, coppice_report_page_css_end),
        .page_js = text(coppice_report_page_js_begin, coppice_report_page_js_end),
        .inspector_js = text(coppice_report_inspector_js_begin, coppice_report_inspector_js_end),
        .vega = text(coppice_report_vega_begin, coppice_report_vega_end),
        .vega_lite = text(coppice_report_vega_lite_begin, coppice_report_vega_lite_end),
        .vega_embed = text(coppice_report_vega_embed_begin, coppice_report_vega_embed_end),
        .vega_license = text(coppice_report_vega_license_begin, coppice_report_vega_license_end),
        .vega_lite_license =
            text(coppice_report_vega_lite_license_begin, coppice_report_vega_lite_license_end),
        .vega_embed_license =
            text(coppice_report_vega_embed_license_begin, coppice_report_vega_embed_license_end),
        .d3_license = text(coppice_report_d3_license_begin, coppice_report_d3_license_end),
        .three_license = text(coppice_report_three_license_begin, coppice_report_three_license_end),
        .thesis_csv = text(coppice_report_thesis_csv_begin, coppice_report_thesis_csv_end),
    };
    return assets;
}

}  // namespace coppice::report
