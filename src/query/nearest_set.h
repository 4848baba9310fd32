#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coppice::inline v0 {

/// Collects the nearest results, as many as a span has room for. The span is a heap with the
/// farthest result on top.
template <typename Found>
class NearestSet {
public:
    /// Collects into `found`, which must not be empty. Results farther than sqrt(limit) are
    /// ignored.
    NearestSet(std::span<Found> found, double limit) noexcept : found_(found), limit_(limit) {}

    /// Results with a squared distance above this need not be inserted.
    [[nodiscard]] double limit() const noexcept { return limit_; }

    [[nodiscard]] bool contains(std::uint32_t prim) const noexcept {
        return std::any_of(found_.begin(), end(), [&](const Found& f) { return f.prim == prim; });
    }

    void offer(const Found& other) noexcept {
        if (size_ < found_.size()) {
            if (!(other.distance_squared <= limit_)) return;
            found_[size_++] = other;
            if (size_ < found_.size()) return;
            std::make_heap(found_.begin(), found_.end(), is_before);
        } else {
            if (!is_before(other, found_.front())) return;
            replace_last(other);
        }
        limit_ = found_.front().distance_squared;
    }

    /// Sorts the results and returns their number.
    std::size_t sort() noexcept {
        std::sort(found_.begin(), end(), is_before);
        return size_;
    }

private:
    using Iterator = typename std::span<Found>::iterator;

    static bool is_before(const Found& a, const Found& b) noexcept {
        return a.distance_squared < b.distance_squared ||
               (a.distance_squared == b.distance_squared && a.prim < b.prim);
    }

    [[nodiscard]] Iterator end() const noexcept {
        return found_.begin() + static_cast<std::ptrdiff_t>(size_);
    }

    // Replaces the result on top by `other` and restores the heap.
    void replace_last(const Found& other) noexcept {
        std::size_t place = 0;
        for (;;) {
            std::size_t child = 2 * place + 1;
            if (child >= size_) break;
            if (child + 1 < size_ && is_before(found_[child], found_[child + 1])) ++child;
            if (!is_before(other, found_[child])) break;
            found_[place] = found_[child];
            place = child;
        }
        found_[place] = other;
    }

    std::span<Found> found_;
    double limit_;
    std::size_t size_ = 0;
};

}  // namespace coppice::inline v0
