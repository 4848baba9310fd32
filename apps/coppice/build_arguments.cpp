#include "build_arguments.h"

#include "coppice/builders/method.h"
#include "coppice/sample/sampler.h"

#include "options.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace coppice::app {

void add_costs(CLI::App& parser, SahCostModel& cost) {
    constexpr double infinity = std::numeric_limits<double>::max();
    add_number(parser, {"--traversal-cost", "T", "Cost of passing an inner node, >= 0", "1"},
               cost.traversal, {0.0, infinity, "a finite number >= 0"});
    add_number(parser, {"--intersection-cost", "T", "Cost of testing a primitive, > 0", "1"},
               cost.intersection, {0.0, infinity, "a finite number > 0", false});
    add_number(
        parser,
        {"--empty-bonus", "B", "Share of a split's cost taken off if one side is empty", "0.5"},
        cost.empty_bonus, {0.0, 1.0, "a number in [0, 1)", true, false});
}

CLI::Option* add_sampler(CLI::App& parser, std::string& sampler) {
    return add_name(parser,
                    {"--sampler", "NAME",
                     listing("How the sample is drawn", names_in(sampler_registry())), "uniform"},
                    sampler, names_in(sampler_registry()));
}

void add_threads(CLI::App& parser, int& threads) {
    add_whole(parser, {"--threads", "N", "Use at most N threads; 0 = all", "0"}, threads, 0, 1024);
}

void add_memory_limit(CLI::App& parser, std::uint64_t& limit_bytes, const std::string& meaning) {
    const auto read = [&limit_bytes](const std::string& given) {
        limit_bytes = parse_bytes("--memory-limit", given);
    };
    parser.add_option_function<std::string>("--memory-limit", read, meaning)
        ->type_name("SIZE")
        ->default_str("none");
}

void add_method(CLI::App& parser, MethodRequest& request, const std::string& seed_meaning) {
    add_name(parser,
             {"--method", "NAME", listing("How it is built", names_in(method_registry())),
              request.method},
             request.method, names_in(method_registry()));
    parser
        .add_option_function<std::string>(
            "--sample",
            [&request](const std::string& given) { request.rate = parse_share("--sample", given); },
            "Share of the primitives that is sampled: 1% or 0.01")
        ->type_name("SHARE")
        ->default_str("the method's");
    add_sampler(parser, request.sampler)->default_str("the method's");
    add_whole(parser, {"--seed", "N", seed_meaning, "1"}, request.seed, 0,
              std::numeric_limits<std::int64_t>::max());
    add_costs(parser, request.cost);
    for (const char* name : {"--traversal-cost", "--intersection-cost", "--empty-bonus"}) {
        parser.get_option(name)->default_str("the method's");
    }
    add_number(parser,
               {"--expected-rays", "N",
                "Rays that will be traced with the tree, which --method auto goes by", "1e7"},
               request.expected_rays,
               {0.0, std::numeric_limits<double>::max(), "a finite number >= 0"});
    add_threads(parser, request.threads);
    add_memory_limit(parser, request.memory_limit_bytes,
                     "Fail early if scene and build would take more: 512M, 2G;\n"
                     "--method auto takes a smaller method then");
}

BuildOptions options_of(const MethodRequest& request) {
    const Method& method = find_method(request.method);
    BuildOptions options = method.options();
    SampleOptions& sample = sample_of(options);
    if (!request.sampler.empty()) {
        sample.sampler = request.sampler;
        if (method.is_automatic()) sample.rate = 0.01;
    }
    if (request.rate) sample.rate = *request.rate;
    sample.seed = request.seed;
    const auto take = [](double given, double& value) {
        if (!std::isnan(given)) value = given;
    };
    SahCostModel& cost = cost_of(options);
    take(request.cost.traversal, cost.traversal);
    take(request.cost.intersection, cost.intersection);
    take(request.cost.empty_bonus, cost.empty_bonus);
    set_threads(options, request.threads);
    if (auto* const bvh8 = std::get_if<Bvh8Options>(&options)) {
        bvh8->expected_rays = request.expected_rays;
        // A rate of 1 by itself leaves the sample to the preset.
        if (method.is_automatic() && request.rate == 1.0) {
            bvh8->sampled_from = std::numeric_limits<std::uint32_t>::max();
        }
    }
    return options;
}

void refuse_vain_options(const CLI::App& parser, const MethodRequest& request, const TreeUse& use) {
    const Method& method = find_method(request.method);
    const BuildOptions options = options_of(request);
    const bool takes_all =
        sample_of(options).rate == 1.0 && (!method.is_automatic() || request.rate == 1.0);
    const std::string all =
        fmt::format("no sample is drawn with --method {}{}; give a share of less with --sample",
                    method.name, request.rate ? " --sample 100%" : "");
    refuse_vain(parser, "--sampler", takes_all, all);
    refuse_vain(parser, "--seed", takes_all && !use.seeds_more, all);
    refuse_vain(parser, "--expected-rays", !method.is_automatic(),
                "only --method auto goes by the rays expected; leave one of them out");
    const bool is_wide = method.tree() == TreeKind::bvh8;
    const std::string constants = fmt::format(
        "--method {} builds by constants of its own; k-d methods go by this", method.name);
    refuse_vain(parser, "--empty-bonus", is_wide, constants);
    for (const char* const name : {"--traversal-cost", "--intersection-cost"}) {
        refuse_vain(parser, name, is_wide && !use.shows_cost, constants);
    }
}

}  // namespace coppice::app
