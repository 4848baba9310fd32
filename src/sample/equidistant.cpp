// Equidistant (systematic) sampling in Morton order without sorting. The primitives are put into
// buckets along a Morton curve, in order of their ids within a bucket. The sum of probabilities
// before a primitive is the sum of the preceding buckets plus the sum of its own bucket so far. So
// one pass computes the sums per bucket, and a second pass draws each primitive whose probability
// interval contains the next multiple of 1. O(N): two passes over the boxes, in parallel by chunks.
// Chunks depend on N alone, and so does every sum.
// Source: [Tessari2023] sec. 3.2 (equidistant along the Morton-ordered CDF), [Morton1966].

#include "sample/equidistant.h"

#include "coppice/base/parallel.h"
#include "coppice/base/rng.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace coppice::inline v0 {
namespace {

// The target number of primitives per bucket. At a sample rate of 1 %, about one draw falls into
// each bucket.
constexpr std::uint32_t bucket_size = 128;
constexpr unsigned max_bits_per_axis = 4;

// A small limit, since each chunk stores a sum for every bucket.
constexpr std::size_t max_chunk_count = 32;
constexpr std::size_t min_chunk_size = 4096;

Vec3f centroid_of(const Aabb& box) {
    return 0.5F * box.lower + 0.5F * box.upper;  // halved first, so that a float cannot overflow
}

// A quarter of the diagonal, so that a float does not overflow for any finite box. Only ratios of
// diagonals matter.
float diagonal_of(const Aabb& box) {
    const double x = box.extent(Axis::x);
    const double y = box.extent(Axis::y);
    const double z = box.extent(Axis::z);
    return static_cast<float>(0.25 * std::sqrt(x * x + y * y + z * z));
}

// std::ceil() for values greater than -1. A call to std::ceil() would cost more than the rest of
// the loop.
std::int64_t ceil(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    return whole + (static_cast<double>(whole) < value ? 1 : 0);
}

// Maps centroids to buckets along a Morton curve over their box.
class MortonBuckets {
public:
    MortonBuckets(const Aabb& centroids, std::uint32_t primitive_count) : origin_(centroids.lower) {
        const auto wanted = static_cast<unsigned>(std::bit_width(primitive_count / bucket_size));
        bits_ = std::clamp((wanted + 2) / 3, 1U, max_bits_per_axis);
        for (const Axis axis : all_axes) {
            const double scale = std::ldexp(1.0, static_cast<int>(bits_)) / centroids.extent(axis);
            scale_[axis] =
                scale < static_cast<double>(Aabb::infinity) ? static_cast<float>(scale) : 0.0F;
        }
    }

    [[nodiscard]] std::size_t count() const { return std::size_t{1} << (3 * bits_); }

    [[nodiscard]] std::uint16_t at(const Vec3f& centroid) const {
        // The bits of 0 to 15, each two positions apart.
        constexpr std::array<std::uint16_t, 16> spread{0,   1,   8,   9,   64,  65,  72,  73,
                                                       512, 513, 520, 521, 576, 577, 584, 585};
        std::uint32_t code = 0;
        for (const Axis axis : all_axes) {
            const float place = (centroid[axis] - origin_[axis]) * scale_[axis];
            const auto last = static_cast<float>((1U << bits_) - 1);
            const auto cell = static_cast<std::size_t>(place < last ? place : last);
            code |= static_cast<std::uint32_t>(spread[cell]) << static_cast<unsigned>(axis);
        }
        return static_cast<std::uint16_t>(code);
    }

private:
    Vec3f origin_;
    unsigned bits_ = 1;
    Vec3f scale_;
};

struct Chunks {
    explicit Chunks(std::uint32_t primitive_count)
        : size(std::max(min_chunk_size, (primitive_count + max_chunk_count - 1) / max_chunk_count)),
          count((primitive_count + size - 1) / size) {}

    std::size_t size;
    std::size_t count;
};

// Calls visit(id, box) for the primitives in [begin, end). Boxes are fetched several at a time.
template <typename Visit>
void for_boxes(PrimitiveSetView primitives, std::size_t begin, std::size_t end, Visit&& visit) {
    std::array<Aabb, 128> boxes;
    for (std::size_t first = begin; first < end; first += boxes.size()) {
        const std::size_t count = std::min(boxes.size(), end - first);
        primitives.bounds(static_cast<std::uint32_t>(first), std::span(boxes).first(count));
        for (std::size_t at = 0; at < count; ++at) {
            visit(first + at, boxes[at]);
        }
    }
}

// The results of the first pass over all boxes.
struct Survey {
    std::vector<float> diagonals;
    Aabb centroids;
};

Survey survey(PrimitiveSetView primitives, const Chunks& chunks) {
    Survey survey;
    survey.diagonals.resize(primitives.size());
    std::vector<Aabb> parts(chunks.count);
    parallel_for_chunks(primitives.size(), chunks.size, [&](std::size_t begin, std::size_t end) {
        Aabb& centroids = parts[begin / chunks.size];
        for_boxes(primitives, begin, end, [&](std::size_t id, const Aabb& box) {
            centroids.grow(centroid_of(box));
            survey.diagonals[id] = diagonal_of(box);
        });
    });
    for (const Aabb& part : parts) {
        survey.centroids.grow(part);
    }
    return survey;
}

// The second pass: finds the bucket of each primitive and the sum of probabilities before it.
class Positions {
public:
    Positions(PrimitiveSetView primitives, const Survey& survey, const Chunks& chunks,
              InclusionProbability probability)
        : buckets_(survey.centroids, primitives.size()),
          diagonals_(survey.diagonals),
          probability_(probability),
          bucket_of_(primitives.size()),
          starts_(chunks.count * buckets_.count()) {
        parallel_for_chunks(
            primitives.size(), chunks.size, [&](std::size_t begin, std::size_t end) {
                double* sums = &starts_[begin / chunks.size * buckets_.count()];
                for_boxes(primitives, begin, end, [&](std::size_t id, const Aabb& box) {
                    bucket_of_[id] = buckets_.at(centroid_of(box));
                    sums[bucket_of_[id]] += probability_(diagonals_[id]);
                });
            });
        double total = 0.0;
        for (std::size_t bucket = 0; bucket < buckets_.count(); ++bucket) {
            for (std::size_t chunk = 0; chunk < chunks.count; ++chunk) {
                double& sum = starts_[chunk * buckets_.count() + bucket];
                sum = std::exchange(total, total + sum);
            }
        }
    }

    // Draws the primitives of a chunk whose probability interval, shifted by `offset`, contains a
    // multiple of 1.
    void draw(std::size_t chunk, std::size_t begin, std::size_t end, double offset,
              Sample& drawn) const {
        const double* start = &starts_[chunk * buckets_.count()];
        std::vector<double> sums(buckets_.count());
        for (std::size_t id = begin; id < end; ++id) {
            const std::size_t bucket = bucket_of_[id];
            const double p = probability_(diagonals_[id]);
            const double from = start[bucket] + sums[bucket] - offset;
            sums[bucket] += p;
            const double to = start[bucket] + sums[bucket] - offset;
            if (ceil(to) <= ceil(from)) continue;
            drawn.ids.push_back(static_cast<std::uint32_t>(id));
            drawn.weights.push_back(static_cast<float>(1.0 / p));
        }
    }

private:
    MortonBuckets buckets_;
    std::span<const float> diagonals_;
    InclusionProbability probability_;
    std::vector<std::uint16_t> bucket_of_;
    std::vector<double> starts_;  // [chunk][bucket]
};

}  // namespace

Sample EquidistantSampler::draw(PrimitiveSetView primitives, std::uint32_t count,
                                const SampleOptions& options) const {
    const Chunks chunks(primitives.size());
    const Survey found = survey(primitives, chunks);
    const Positions positions(primitives, found, chunks, choose(found.diagonals, count, options));
    // Keeps a distance from whole numbers, so that rounding can neither add nor lose a draw.
    const double offset = 0.001 + 0.998 * random_unit(options.seed, 0);
    std::vector<Sample> parts(chunks.count);
    parallel_for_chunks(primitives.size(), chunks.size, [&](std::size_t begin, std::size_t end) {
        const std::size_t chunk = begin / chunks.size;
        positions.draw(chunk, begin, end, offset, parts[chunk]);
    });
    Sample sample{{}, {}, options};
    sample.ids.reserve(count);
    sample.weights.reserve(count);
    for (const Sample& part : parts) {
        sample.ids.insert(sample.ids.end(), part.ids.begin(), part.ids.end());
        sample.weights.insert(sample.weights.end(), part.weights.begin(), part.weights.end());
    }
    return sample;
}

}  // namespace coppice::inline v0
