#pragma once

#include "coppice/base/cpu.h"

#include "simd/dispatch.h"
#include "simd/lane_ops.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::test {

[[nodiscard]] inline float number_in(Domain domain, Random& random) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr std::array special{0.0F, 1.0F, 0x1.0p-140F, infinity, -0.0F, -1.0F, -infinity};
    constexpr std::size_t positive_count = 4;
    if (domain == Domain::integers) return static_cast<float>(random.below(64)) - 32.0F;
    const bool is_special = random.below(3) == 0;
    if (domain == Domain::positive) {
        return is_special ? special[random.below(positive_count)] : random.uniform(0.0F, 9.0F);
    }
    if (domain == Domain::any && random.below(8) == 0) {
        return std::numeric_limits<float>::quiet_NaN();
    }
    return is_special ? special[random.below(special.size())] : random.uniform(-9.0F, 9.0F);
}

// Finite inputs may give NaN (infinity - infinity), whose sign is the processor's own.
[[nodiscard]] inline LaneInput make_input(Domain domain, Random& random) {
    LaneInput in;
    for (std::array<float, 8>* numbers : {&in.a, &in.b, &in.c}) {
        for (float& number : *numbers) {
            do {
                number = number_in(domain, random);
            } while (domain == Domain::finite && std::abs(number) > 100.0F);
        }
    }
    return in;
}

/// Every operation of every set that the processor has gives what the scalar one gives.
inline void expect_like_scalar(const simd::Tables<LaneOps>& tables) {
    const std::span<const LaneOp> expected = tables.at(Isa::scalar).ops;
    for (const Isa isa : available_isas()) {
        const std::span<const LaneOp> ops = tables.at(isa).ops;
        ASSERT_EQ(ops.size(), expected.size());
        for (std::size_t i = 0; i < ops.size(); ++i) {
            Random random(i + 1);
            for (int round = 0; round < 200; ++round) {
                const LaneInput in = make_input(ops[i].domain, random);
                LaneOutput out;
                LaneOutput expected_out;
                ops[i].run(in, out);
                expected[i].run(in, expected_out);
                ASSERT_EQ(out, expected_out) << ops[i].name << " by " << name_of(isa);
            }
        }
    }
}

}  // namespace coppice::test
