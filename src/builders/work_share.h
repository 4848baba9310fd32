#pragma once

#include "coppice/builders/progress.h"

#include <cstddef>

namespace coppice::inline v0 {

/// A share of the work of a stage, held by the task that does it: a node divides its own among its
/// children, and what is done is told. One that nobody asks about tells nothing and costs nothing.
class WorkShare {
public:
    WorkShare() = default;

    /// All the work of a stage; of null nobody asks about it.
    explicit WorkShare(Progress* progress) noexcept
        : WorkShare(progress, progress == nullptr ? 0.0 : 1.0) {}

    /// All of it is done.
    void done() const {
        if (share_ > 0.0) progress_->add(share_);
    }

    /// True if somebody asks.
    [[nodiscard]] bool is_asked_for() const noexcept { return share_ > 0.0; }

    /// A part in [0, 1] of it.
    [[nodiscard]] WorkShare part(double of_it) const noexcept {
        return WorkShare(progress_, of_it * share_);
    }

    struct Children;

    /// Divides the share of a node of `count` PrimRefs, >= 1, by the work to come: the node's own
    /// grows with its PrimRefs, the children's with theirs and the number of levels below. The
    /// node's own is done.
    [[nodiscard]] Children divide(std::size_t count, std::size_t below, std::size_t above) const;

private:
    WorkShare(Progress* progress, double share) noexcept : progress_(progress), share_(share) {}

    Progress* progress_ = nullptr;
    double share_ = 0.0;
};

/// The shares of a node's children.
struct WorkShare::Children {
    WorkShare below;
    WorkShare above;
};

}  // namespace coppice::inline v0
