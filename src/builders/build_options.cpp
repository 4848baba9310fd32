#include "coppice/builders/build_options.h"

namespace coppice::inline v0 {

const SampleOptions& sample_of(const BuildOptions& options) noexcept {
    return std::visit([](const auto& of) -> const SampleOptions& { return of.sample; }, options);
}

SampleOptions& sample_of(BuildOptions& options) noexcept {
    return std::visit([](auto& of) -> SampleOptions& { return of.sample; }, options);
}

const SahCostModel& cost_of(const BuildOptions& options) noexcept {
    return std::visit([](const auto& of) -> const SahCostModel& { return of.cost; }, options);
}

SahCostModel& cost_of(BuildOptions& options) noexcept {
    return std::visit([](auto& of) -> SahCostModel& { return of.cost; }, options);
}

int threads_of(const BuildOptions& options) noexcept {
    return std::visit([](const auto& of) { return of.threads; }, options);
}

void set_threads(BuildOptions& options, int threads) noexcept {
    std::visit([threads](auto& of) { of.threads = threads; }, options);
}

}  // namespace coppice::inline v0
