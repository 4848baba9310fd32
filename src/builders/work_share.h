#pragma once

#include "coppice/builders/progress.h"

#include <cstddef>

namespace coppice::inline v0 {

/// A share of a stage's work, for progress reports. A task holds the share of its node, divides it
/// among the children, and reports what is done. A default-constructed share reports nothing and
/// costs nothing.
class WorkShare {
public:
    WorkShare() = default;

    /// The whole work of a stage; null disables reports.
    explicit WorkShare(Progress* progress) noexcept
        : WorkShare(progress, progress == nullptr ? 0.0 : 1.0) {}

    /// Reports the whole share as done.
    void done() const {
        if (share_ > 0.0) progress_->add(share_);
    }

    /// True if progress is reported.
    [[nodiscard]] bool is_asked_for() const noexcept { return share_ > 0.0; }

    /// A part of the share; `of_it` is in [0, 1].
    [[nodiscard]] WorkShare part(double of_it) const noexcept {
        return WorkShare(progress_, of_it * share_);
    }

    struct Children;

    /// Divides the share of a node of `count` PrimRefs, >= 1, by the expected work and reports the
    /// node's own part as done. The node's own work grows with its PrimRefs, that of the children
    /// with their PrimRefs and the number of levels below.
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
