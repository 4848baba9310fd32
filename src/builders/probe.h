#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/primitive_set.h"
#include "coppice/tree/kd_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coppice::inline v0 {

/// A primitive's part in one of the pieces of a probe.
struct ProbePart {
    std::uint32_t id;
    Aabb box;  ///< of the part
    std::uint32_t piece;
};

/// A primitive whose box has its middle in one of the pieces, whether or not it touches the piece.
struct ProbeCenter {
    std::uint32_t id;
    std::uint32_t piece;
};

/// Pieces of a scene: the parts of all primitives within some boxes, as a set of primitives of its
/// own. Satisfies PrimitiveSet. What it is a probe of must outlive it.
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

    /// The primitives that have their middle in one of the pieces, by ascending ids. Every
    /// primitive has it in one piece of the whole scene, so their number over that of all is the
    /// share of the scene probed.
    [[nodiscard]] std::span<const ProbeCenter> centers() const noexcept { return centers_; }

    /// The probe of every n-th piece of this one.
    [[nodiscard]] Probe thinned(std::uint32_t n) const;

private:
    PrimitiveSetView primitives_;
    std::vector<Aabb> pieces_;
    std::vector<ProbePart> parts_;
    std::vector<ProbeCenter> centers_;
};

/// Divides a scene into about `piece_count` pieces (one for 1) and takes one in `n` of them, evenly
/// over it.
[[nodiscard]] Probe take_probe(PrimitiveSetView primitives, std::uint32_t piece_count,
                               std::uint32_t n);

}  // namespace coppice::inline v0
