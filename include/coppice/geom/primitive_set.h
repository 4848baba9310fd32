#pragma once

#include "coppice/geom/aabb.h"

#include <concepts>
#include <cstdint>
#include <memory>
#include <span>

namespace coppice::inline v0 {

/// A set of primitives that trees can be built on. Ids run from 0 to size() - 1.
/// - `bounds(id)` is the bounding box of the primitive. It is finite and not empty.
/// - `clipped_bounds(id, box)` is the bounding box of the part of the primitive inside `box`. It
///   lies within `box` and is empty if no part of the primitive is inside. It may be larger than
///   necessary but never smaller: `intersection(bounds(id), box)` is a valid result.
///
/// Both are called from several threads at once. A set that may contain invalid primitives, such as
/// a mesh with a vertex index out of range, can also have `require_valid(first, last)`. It throws
/// an Error that names the first invalid primitive of [first, last). build_kd_tree() and
/// build_bvh8() call it before they call bounds().
template <typename T>
concept PrimitiveSet = requires(const T& set, std::uint32_t id, const Aabb& box) {
    { set.size() } -> std::convertible_to<std::uint32_t>;
    { set.bounds(id) } -> std::convertible_to<Aabb>;
    { set.clipped_bounds(id, box) } -> std::convertible_to<Aabb>;
};

/// Any PrimitiveSet behind one type, so that the builders are compiled once. Does not own the set,
/// which must outlive the view. Holds two pointers; each call costs an indirect jump.
class PrimitiveSetView {
public:
    // Implicit by design: a function that takes a PrimitiveSetView accepts any set.
    // NOLINTBEGIN(google-explicit-constructor)
    /// A view of `set`.
    template <PrimitiveSet Set>
    requires(!std::same_as<Set, PrimitiveSetView>) PrimitiveSetView(const Set& set)
    noexcept : set_(std::addressof(set)), calls_(&calls_of<Set>) {}

    // NOLINTEND(google-explicit-constructor)

    /// The number of primitives.
    [[nodiscard]] std::uint32_t size() const { return calls_->size(set_); }

    /// The bounding box of primitive `id`.
    [[nodiscard]] Aabb bounds(std::uint32_t id) const { return calls_->bounds(set_, id); }

    /// Fills `boxes` with the bounding boxes of the primitives from `first` on, at the cost of one
    /// indirect call.
    void bounds(std::uint32_t first, std::span<Aabb> boxes) const {
        calls_->many_bounds(set_, first, boxes);
    }

    /// The bounding box of the part of primitive `id` inside `box`.
    [[nodiscard]] Aabb clipped_bounds(std::uint32_t id, const Aabb& box) const {
        return calls_->clipped_bounds(set_, id, box);
    }

    /// Calls the set's own require_valid() if it has one, and throws what that throws.
    void require_valid(std::uint32_t first, std::uint32_t last) const {
        calls_->require_valid(set_, first, last);
    }

private:
    struct Calls {
        std::uint32_t (*size)(const void*);
        Aabb (*bounds)(const void*, std::uint32_t);
        void (*many_bounds)(const void*, std::uint32_t, std::span<Aabb>);
        Aabb (*clipped_bounds)(const void*, std::uint32_t, const Aabb&);
        void (*require_valid)(const void*, std::uint32_t, std::uint32_t);
    };

    template <PrimitiveSet Set>
    static constexpr Calls calls_of{
        [](const void* set) {
            return static_cast<std::uint32_t>(static_cast<const Set*>(set)->size());
        },
        [](const void* set, std::uint32_t id) {
            return static_cast<Aabb>(static_cast<const Set*>(set)->bounds(id));
        },
        [](const void* set, std::uint32_t first, std::span<Aabb> boxes) {
            for (Aabb& box : boxes) {
                box = static_cast<Aabb>(static_cast<const Set*>(set)->bounds(first++));
            }
        },
        [](const void* set, std::uint32_t id, const Aabb& box) {
            return static_cast<Aabb>(static_cast<const Set*>(set)->clipped_bounds(id, box));
        },
        [](const void* set, std::uint32_t first, std::uint32_t last) {
            if constexpr (requires(const Set& it) { it.require_valid(first, last); }) {
                static_cast<const Set*>(set)->require_valid(first, last);
            }
        }};

    const void* set_;
    const Calls* calls_;
};

}  // namespace coppice::inline v0
