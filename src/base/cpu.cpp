#include "coppice/base/cpu.h"

#include "coppice/base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdlib>
#include <vector>

namespace coppice {
namespace {

constexpr std::array all_isas{Isa::scalar, Isa::avx2};

bool has_avx2() noexcept {
#if defined(__x86_64__)
    return static_cast<bool>(__builtin_cpu_supports("avx2")) &&
           static_cast<bool>(__builtin_cpu_supports("fma"));
#else
    return false;
#endif
}

}  // namespace

std::string_view name_of(Isa isa) noexcept {
    return isa == Isa::avx2 ? "avx2" : "scalar";
}

std::span<const Isa> available_isas() noexcept {
    static const std::size_t count = has_avx2() ? 2 : 1;
    return std::span(all_isas).first(count);
}

Isa choose_isa() {
    const std::span<const Isa> available = available_isas();
    const char* wanted = std::getenv("COPPICE_ISA");
    if (wanted == nullptr || *wanted == '\0') return available.back();
    std::vector<std::string_view> names;
    for (const Isa isa : available) {
        if (name_of(isa) == wanted) return isa;
        names.push_back(name_of(isa));
    }
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("COPPICE_ISA is '{}'; this processor has: {}", wanted, fmt::join(names, ", ")));
}

}  // namespace coppice
