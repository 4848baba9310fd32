#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// The part of a primitive in one piece of a probe.
struct ProbePart {
    std::uint32_t id;
    Aabb box;  ///< box of the part
    std::uint32_t piece;
};

/// A primitive whose box has its midpoint in one of the pieces, whether or not the primitive
/// touches the piece.
struct ProbeCenter {
    std::uint32_t id;
    std::uint32_t piece;
};

/// Pieces of a scene as a set of primitives: the parts of all primitives within some boxes.
/// Satisfies PrimitiveSet. Refers to the scene, which must outlive it.
class Probe {
public:
    Probe(PrimitiveSetView primitives, std::vector<Aabb> pieces, std::vector<ProbePart> parts,
          std::vector<ProbeCenter> centers)
        : primitives_(primitives),
          pieces_(std::move(pieces)),
          parts_(std::move(parts)),
          centers_(std::move(centers)) {}

    [[nodiscard]] std::uint32_t size() const noexcept {
        return static_cast<std::uint32_t>(parts_.size());
    }

    [[nodiscard]] Aabb bounds(std::uint32_t id) const noexcept { return parts_[id].box; }

    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const {
        const ProbePart& part = parts_[id];
        const Aabb inside = intersection(box, pieces_[part.piece]);
        return inside.is_empty() ? Aabb{} : primitives_.clipped_bounds(part.id, inside);
    }

    /// The primitives with their midpoint in one of the pieces, by ascending id. Every primitive
    /// has its midpoint in exactly one piece of the whole scene. So their number, divided by the
    /// number of all primitives, is the share of the scene that is probed.
    [[nodiscard]] std::span<const ProbeCenter> centers() const noexcept { return centers_; }

    /// A smaller probe, of every n-th piece of this one.
    [[nodiscard]] Probe thinned(std::uint32_t n) const;

private:
    PrimitiveSetView primitives_;
    std::vector<Aabb> pieces_;
    std::vector<ProbePart> parts_;
    std::vector<ProbeCenter> centers_;
};

/// Divides a scene into about `piece_count` pieces (one piece for 1) and takes every n-th of them.
[[nodiscard]] Probe take_probe(PrimitiveSetView primitives, std::uint32_t piece_count,
                               std::uint32_t n);

}  // namespace coppice::inline v0
