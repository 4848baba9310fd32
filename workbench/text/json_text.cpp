#include "text/json_text.h"

#include <cmath>

namespace coppice::lab {

nlohmann::ordered_json number_json(double number) {
    return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json();
}

nlohmann::ordered_json number_json(float number) {
    return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json();
}

nlohmann::ordered_json number_json(const std::optional<double>& number) {
    return number ? number_json(*number) : nlohmann::ordered_json();
}

nlohmann::ordered_json vector_json(Vec3f v) {
    return {v.x, v.y, v.z};
}

}  // namespace coppice::lab
