#pragma once

#include "coppice/builders/build_options.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace coppice::app {

/// The options of a build that several commands have. Each fills in what is given and leaves the
/// rest as it is.

/// --traversal-cost, --intersection-cost and --empty-bonus.
void add_costs(CLI::App& parser, SahCostModel& cost);

/// --sampler.
CLI::Option* add_sampler(CLI::App& parser, std::string& sampler);

/// --threads.
void add_threads(CLI::App& parser, int& threads);

/// --memory-limit, with what happens to a build that would pass it.
void add_memory_limit(CLI::App& parser, std::uint64_t& limit_bytes, const std::string& meaning);

/// A method, and what is to be different from it.
struct MethodRequest {
    static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

    std::string method = "auto";
    std::optional<double> rate;
    std::string sampler;
    std::uint64_t seed = 1;
    SahCostModel cost{not_given, not_given, not_given};
    double expected_rays = Bvh8Options{}.expected_rays;
    int threads = 0;
    std::uint64_t memory_limit_bytes = 0;  ///< 0: none
};

/// All options above, and --method, --sample, --expected-rays and --seed, which `seed_meaning` is
/// shown for.
void add_method(CLI::App& parser, MethodRequest& request, const std::string& seed_meaning);

/// The options of a build that a request asks for: the method's own where nothing is given.
[[nodiscard]] BuildOptions options_of(const MethodRequest& request);

/// What a command does with the tree it builds, beside building it.
struct TreeUse {
    bool seeds_more = false;  ///< --seed is that of more than the sample
    bool shows_cost = true;   ///< the tree's SAH cost
};

/// Throws UsageError naming the first option given that has no effect with the method.
void refuse_vain_options(const CLI::App& parser, const MethodRequest& request, const TreeUse& use);

}  // namespace coppice::app
