#include "report/figure.h"

#include "report/format.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coppice::report {

std::string figure(const std::string& id, const std::string& title, const std::string& note,
                   const nlohmann::json& chart) {
    return fmt::format(
        "<figure><figcaption><b>{}</b> {}</figcaption>"
        "<div class=\"plot\" data-chart=\"{}\" style=\"min-height:{}px\"></div>"
        "<script type=\"application/json\" class=\"chart\" id=\"{}\">{}</script></figure>\n",
        title, note, id, chart.at("height").get<int>(), id, script_json(chart));
}

}  // namespace coppice::report
