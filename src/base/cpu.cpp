#include "coppice/base/cpu.h"

#include "coppice/base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <string>
#include <vector>

namespace coppice::inline v0 {
namespace {

constexpr std::array all_isas{Isa::scalar, Isa::sse42, Isa::avx2, Isa::avx512};

// The number of entries of all_isas that this processor supports.
std::size_t count_isas() noexcept {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("sse4.2") == 0) return 1;
    if (__builtin_cpu_supports("avx2") == 0 || __builtin_cpu_supports("fma") == 0) return 2;
    const bool has_avx512 =
        __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512dq") != 0;
    return has_avx512 ? 4 : 3;
#else
    return 1;
#endif
}

// The name in lower case without dots: "SSE4.2" becomes "sse42".
std::string plain(std::string_view name) {
    std::string text;
    for (const char c : name) {
        if (c != '.') text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return text;
}

}  // namespace

std::string_view name_of(Isa isa) noexcept {
    switch (isa) {
        case Isa::scalar:
            return "scalar";
        case Isa::sse42:
            return "sse4.2";
        case Isa::avx2:
            return "avx2";
        case Isa::avx512:
            return "avx512";
    }
    return "";
}

std::span<const Isa> available_isas() noexcept {
    static const std::size_t count = count_isas();
    return std::span(all_isas).first(count);
}

Isa choose_isa() {
    const std::span<const Isa> available = available_isas();
    const char* wanted = std::getenv("COPPICE_ISA");
    if (wanted == nullptr || *wanted == '\0') return available.back();
    std::vector<std::string_view> names;
    for (const Isa isa : available) {
        if (plain(name_of(isa)) == plain(wanted)) return isa;
        names.push_back(name_of(isa));
    }
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("COPPICE_ISA is '{}'; set it to one of: {}", wanted, fmt::join(names, ", ")));
}

}  // namespace coppice::inline v0
