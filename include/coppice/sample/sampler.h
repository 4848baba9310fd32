#pragma once

#include "coppice/export.h"
#include "coppice/geom/primitive_set.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

class Sampler;

/// How to choose the primitives a tree is built from.
struct SampleOptions {
    double rate = 1.0;                ///< share of the primitives, in (0, 1]
    std::string sampler = "uniform";  ///< a name of sampler_registry()
    std::uint64_t seed = 1;           ///< same seed, same sample
    double uniform_share = 0.5;       ///< `weighted` only: the part of the inclusion probability
                                      ///< that is the same for all, in [0, 1]; at least 2^-20 is
                                      ///< taken, so that no primitive is impossible
    std::shared_ptr<const Sampler> custom_sampler = {};  ///< one of your own, instead of `sampler`
};

/// The primitives chosen: distinct ids, ascending.
struct Sample {
    std::vector<std::uint32_t> ids;  ///< distinct, ascending
    std::vector<float> weights;  ///< how many primitives each stands for, 1 / p of its inclusion
                                 ///< probability p; empty if all stand for equally many
    SampleOptions options;       ///< what it was drawn with
};

/// Chooses `count` of the primitives. Runs once a build; stateless.
class Sampler {
public:
    Sampler() = default;
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;
    virtual ~Sampler() = default;

    /// `count` distinct ids in ascending order with their weights, 1 <= count <=
    /// primitives.size(); the same for the same options, whatever the number of threads.
    [[nodiscard]] virtual Sample draw(PrimitiveSetView primitives, std::uint32_t count,
                                      const SampleOptions& options) const = 0;

    /// False if SampleOptions::uniform_share means nothing to it.
    [[nodiscard]] virtual bool uses_uniform_share() const noexcept { return true; }
};

/// A sampler under its name, with one line on what it does.
struct SamplerEntry {
    std::string_view name;     ///< how options call it
    std::string_view summary;  ///< what it does, in one line
    const Sampler& sampler;    ///< lives as long as the program
};

/// All samplers; the first is the default.
[[nodiscard]] COPPICE_EXPORT std::span<const SamplerEntry> sampler_registry();

/// The sampler of that name. Throws Error(invalid_argument) naming those that exist.
[[nodiscard]] COPPICE_EXPORT const Sampler& find_sampler(std::string_view name);

/// The sampler that the options ask for: their own, or that of the name. Throws like
/// find_sampler().
[[nodiscard]] COPPICE_EXPORT const Sampler& sampler_of(const SampleOptions& options);

/// Throws Error(invalid_argument) naming the first option outside its range.
COPPICE_EXPORT void require_valid(const SampleOptions& options);

/// The number of primitives a rate stands for: round(rate * count), at least 1 of any.
/// Throws Error(invalid_argument) unless 0 < rate <= 1.
[[nodiscard]] COPPICE_EXPORT std::uint32_t sample_count(std::uint32_t count, double rate);

}  // namespace coppice::inline v0
