#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::test {

/// What operations are tried on.
struct LaneInput {
    alignas(32) std::array<float, 8> a;
    alignas(32) std::array<float, 8> b;
    alignas(32) std::array<float, 8> c;
};

/// What came out, bit for bit.
struct LaneOutput {
    void put(float value) noexcept { bits[size++] = std::bit_cast<std::uint32_t>(value); }

    void put(double value) noexcept { bits[size++] = std::bit_cast<std::uint64_t>(value); }

    void put(std::uint32_t value) noexcept { bits[size++] = value; }

    void put(std::int32_t value) noexcept { put(static_cast<std::uint32_t>(value)); }

    template <typename T, std::size_t count>
    void put(const std::array<T, count>& values) noexcept {
        for (const T value : values) {
            put(value);
        }
    }

    friend bool operator==(const LaneOutput&, const LaneOutput&) = default;

    std::array<std::uint64_t, 32> bits{};
    std::size_t size = 0;
};

/// The inputs for which an operation gives the same on every set.
enum class Domain {
    any,       ///< NaN, infinities and zeros of both signs among them
    finite,    ///< no NaN
    positive,  ///< >= +0, no NaN: what may be compared as integers
    integers   ///< small whole numbers: products are exact, so that rounding once or twice is the
               ///< same
};

struct LaneOp {
    const char* name;
    Domain domain;
    void (*run)(const LaneInput&, LaneOutput&) noexcept;
};

/// The operations of one set, in the same order for all.
struct LaneOps {
    std::span<const LaneOp> ops;
};

}  // namespace coppice::test
