// What every sampler promises, and the list of them.

#include "coppice/base/error.h"
#include "coppice/base/parallel.h"
#include "coppice/geom/point_cloud.h"
#include "coppice/sample/sampler.h"

#include "support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace coppice::test {
namespace {

using Ids = std::vector<std::uint32_t>;

bool is_strictly_ascending(const Ids& ids) {
    return std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end();
}

class EverySampler : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static Ids draw(PrimitiveSetView primitives, std::uint32_t count,
                                  std::uint64_t seed) {
        return find_sampler(GetParam()).draw(primitives, count, {.seed = seed}).ids;
    }
};

TEST_P(EverySampler, DrawsDistinctIdsInOrder) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 1);
    const TriangleMeshView primitives = mesh.view();
    for (const std::uint32_t count : {1U, 2U, 10U, 500U, 999U, 1000U}) {
        for (const std::uint64_t seed : {0U, 1U, 77U}) {
            const Ids ids = draw(primitives, count, seed);
            ASSERT_EQ(ids.size(), count);
            EXPECT_TRUE(is_strictly_ascending(ids));
            EXPECT_LT(ids.back(), 1000U);
        }
    }
}

TEST_P(EverySampler, DrawsTheOnlyOne) {
    const TriangleMesh mesh = make_soup(1, 0.1F, 1);
    EXPECT_EQ(draw(mesh.view(), 1, 9), Ids{0});
}

TEST_P(EverySampler, DrawsAll) {
    const TriangleMesh mesh = make_soup(100, 0.1F, 1);
    Ids all(100);
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(draw(mesh.view(), 100, 9), all);
}

TEST_P(EverySampler, DependsOnTheSeed) {
    const TriangleMesh mesh = make_soup(1000, 0.1F, 1);
    const Ids ids = draw(mesh.view(), 100, 5);
    EXPECT_EQ(draw(mesh.view(), 100, 5), ids);
    EXPECT_NE(draw(mesh.view(), 100, 6), ids);
    for (const int threads : {1, 2}) {
        run_with_threads(threads, [&] { EXPECT_EQ(draw(mesh.view(), 100, 5), ids); });
    }
}

TEST_P(EverySampler, CopesWithEqualAndDegeneratePrimitives) {
    for (const TriangleMesh& mesh :
         {repeated(make_degenerate_points(1, 1), 200), make_collinear(200, {1, 0, 0}, 1),
          repeated(make_soup(1, 1.0F, 1), 200), scaled(make_soup(200, 0.1F, 1), 1e30F),
          scaled(make_soup(200, 0.1F, 1), 1e-30F)}) {
        const Ids ids = draw(mesh.view(), 20, 3);
        EXPECT_EQ(ids.size(), 20U);
        EXPECT_TRUE(is_strictly_ascending(ids));
        EXPECT_LT(ids.back(), 200U);
    }
}

TEST_P(EverySampler, WeighsWhatItDraws) {
    const TriangleMesh mesh = make_soup(4000, 0.1F, 1);
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Sample sample = find_sampler(GetParam()).draw(mesh.view(), 400, {.seed = seed});
        for (const float weight : sample.weights) {
            EXPECT_GE(weight, 1.0F);
            sum += static_cast<double>(weight);
        }
        if (sample.weights.empty()) sum += 4000.0;
    }
    EXPECT_NEAR(sum / 20.0, 4000.0, 100.0);  // unbiased: together they stand for all
}

std::vector<std::string> sampler_names() {
    std::vector<std::string> names;
    for (const SamplerEntry& entry : sampler_registry()) {
        names.emplace_back(entry.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Named, EverySampler, testing::ValuesIn(sampler_names()),
                         [](const auto& each) { return each.param; });

TEST(SamplerRegistry, NamesAreUniqueAndSummariesThere) {
    std::set<std::string_view> names;
    for (const SamplerEntry& entry : sampler_registry()) {
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
        EXPECT_FALSE(entry.name.empty());
        EXPECT_FALSE(entry.summary.empty());
        EXPECT_EQ(&find_sampler(entry.name), &entry.sampler);
    }
    ASSERT_FALSE(names.empty());
    EXPECT_EQ(sampler_registry().front().name, SampleOptions{}.sampler);
}

TEST(FindSampler, NamesThoseThatExist) {
    for (const std::string_view name : {"", "Uniform", "uniform ", "best"}) {
        try {
            static_cast<void>(find_sampler(name));
            FAIL() << "no exception";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
            EXPECT_THAT(error.what(), testing::StartsWith("unknown sampler '" + std::string(name) +
                                                          "'; choose one of: "));
            for (const std::string& known : sampler_names()) {
                EXPECT_THAT(error.what(), testing::HasSubstr(known));
            }
        }
    }
}

TEST(SampleCount, IsTheRoundedShare) {
    EXPECT_EQ(sample_count(1000, 1.0), 1000U);
    EXPECT_EQ(sample_count(1000, 0.5), 500U);
    EXPECT_EQ(sample_count(1000, 0.0014), 1U);
    EXPECT_EQ(sample_count(1000, 0.0016), 2U);
    EXPECT_EQ(sample_count(3, 0.5), 2U);
    EXPECT_EQ(sample_count(437'645, 0.01), 4376U);
}

TEST(SampleCount, IsAtLeastOneOfAny) {
    EXPECT_EQ(sample_count(0, 1.0), 0U);
    EXPECT_EQ(sample_count(0, 0.01), 0U);
    EXPECT_EQ(sample_count(1, 0.01), 1U);
    EXPECT_EQ(sample_count(1000, 1e-300), 1U);
    EXPECT_EQ(sample_count(1000, std::numeric_limits<double>::denorm_min()), 1U);
}

TEST(SampleCount, DoesNotOverflow) {
    constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
    EXPECT_EQ(sample_count(most, 1.0), most);
    EXPECT_EQ(sample_count(most, std::nextafter(1.0, 0.0)), most);
    EXPECT_EQ(sample_count(most, 0.5), most / 2 + 1);
}

TEST(SampleCount, RefusesRatesOutsideOfItsRange) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double rate : {0.0, -0.0, -0.5, 1.0000001, 50.0, nan, infinity, -infinity}) {
        for (const std::uint32_t count : {0U, 10U}) {
            try {
                static_cast<void>(sample_count(count, rate));
                FAIL() << "no exception for " << rate;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
                EXPECT_THAT(error.what(), testing::StartsWith("sample rate "));
                EXPECT_THAT(error.what(), testing::HasSubstr("(0, 1]"));
            }
        }
    }
}

}  // namespace
}  // namespace coppice::test
