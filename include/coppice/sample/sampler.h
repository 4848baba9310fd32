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

/// How to draw the sample of primitives that a tree is built from.
struct SampleOptions {
    double rate = 1.0;                ///< share of the primitives, in (0, 1]
    std::string sampler = "uniform";  ///< name of a sampler, see sampler_registry()
    std::uint64_t seed = 1;           ///< equal seeds give equal samples
    double uniform_share = 0.5;       ///< `weighted` only: the part of the inclusion probability
                                      ///< that is the same for all primitives, in [0, 1]; less than
                                      ///< 2^-20 counts as 2^-20, so that each can be drawn
    std::shared_ptr<const Sampler> custom_sampler = {};  ///< your own, instead of `sampler`
};

/// A sample of a primitive set.
struct Sample {
    std::vector<std::uint32_t> ids;  ///< ids of the drawn primitives, distinct, ascending
    std::vector<float> weights;      ///< number of primitives that each stands for: 1 / p, for its
                                     ///< inclusion probability p; empty if all weights are equal
    SampleOptions options;           ///< options it was drawn with
};

/// Interface of samplers. Stateless; draw() is called once per build.
class Sampler {
public:
    Sampler() = default;
    Sampler(const Sampler&) = delete;
    Sampler& operator=(const Sampler&) = delete;
    virtual ~Sampler() = default;

    /// Draws `count` distinct primitives, 1 <= count <= primitives.size(). Returns their ids in
    /// ascending order with their weights. The same for the same options, whatever the number of
    /// threads.
    [[nodiscard]] virtual Sample draw(PrimitiveSetView primitives, std::uint32_t count,
                                      const SampleOptions& options) const = 0;

    /// False if the sampler ignores SampleOptions::uniform_share.
    [[nodiscard]] virtual bool uses_uniform_share() const noexcept { return true; }
};

/// A registered sampler.
struct SamplerEntry {
    std::string_view name;     ///< name in SampleOptions
    std::string_view summary;  ///< what it does, in one line
    const Sampler& sampler;    ///< lives as long as the program
};

/// All samplers; the first is the default.
[[nodiscard]] COPPICE_EXPORT std::span<const SamplerEntry> sampler_registry();

/// The sampler called `name`. Throws Error(invalid_argument) with a list of the valid names if
/// there is none.
[[nodiscard]] COPPICE_EXPORT const Sampler& find_sampler(std::string_view name);

/// The sampler of the options: `custom_sampler` if set, else the one called `sampler`. Throws as
/// find_sampler() does.
[[nodiscard]] COPPICE_EXPORT const Sampler& sampler_of(const SampleOptions& options);

/// Throws Error(invalid_argument) naming the first option outside its range.
COPPICE_EXPORT void require_valid(const SampleOptions& options);

/// The number of primitives that a sample rate stands for: round(rate * count), but at least 1 if
/// count > 0. Throws Error(invalid_argument) unless 0 < rate <= 1.
[[nodiscard]] COPPICE_EXPORT std::uint32_t sample_count(std::uint32_t count, double rate);

}  // namespace coppice::inline v0
