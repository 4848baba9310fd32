#include "build_arguments.h"

#include "coppice/build/method.h"
#include "coppice/sample/sampler.h"

#include "options.h"

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

void add_method(CLI::App& parser, std::string& method) {
    method = "auto";
    add_name(parser,
             {"--method", "NAME", listing("How it is built", names_in(method_registry())), method},
             method, names_in(method_registry()));
}

void add_sample(CLI::App& parser, std::optional<double>& rate) {
    const auto read = [&rate](const std::string& given) { rate = parse_share("--sample", given); };
    parser
        .add_option_function<std::string>("--sample", read,
                                          "Share of the primitives that is sampled: 1% or 0.01")
        ->type_name("SHARE")
        ->default_str("the method's");
}

void add_threads(CLI::App& parser, int& threads) {
    add_whole(parser, {"--threads", "N", "Use at most N threads; 0 = all", "0"}, threads, 0, 1024);
}

}  // namespace coppice::app
