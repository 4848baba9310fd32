// Search of a k-d tree over points for what is near a place, or in a box: included once for each
// instruction set, in a namespace of its own. Loops over the eight points of a step are written so
// that compilers make vector code of them.
//
// Near a place: the nearer child first, the other waits on a stack with a lower bound of its
// distance, kept up to date one axis at a time [AryaMount1993]: on the axis of the plane it is the
// distance to the plane, on the others what it was. Bounds and distances are the same sums of three
// squares in double; a bound's terms are no larger than those of any point beyond the planes, and
// rounding keeps order, so no point is passed over that brute force would find, a tie included.
//
// Stack: one entry a level at most, and no leaf is deeper than KdTree::max_depth.

constexpr std::size_t max_stack = static_cast<std::size_t>(KdTree::max_depth) + 1;

using LaneDistances = std::array<double, point_lanes>;

// Squared distances of eight points from `first` on.
inline void measure_points(const SearchedPoints& points, std::size_t first, Vec3d from,
                           LaneDistances& distances) noexcept {
    const float* x = points.x + first;
    const float* y = points.y + first;
    const float* z = points.z + first;
    for (std::size_t lane = 0; lane < point_lanes; ++lane) {
        const double dx = static_cast<double>(x[lane]) - from.x;
        const double dy = static_cast<double>(y[lane]) - from.y;
        const double dz = static_cast<double>(z[lane]) - from.z;
        distances[lane] = dx * dx + dy * dy + dz * dz;
    }
}

// Bit i is set if distances[i] <= limit.
inline unsigned mask_within(const LaneDistances& distances, double limit) noexcept {
    unsigned mask = 0;
    for (unsigned lane = 0; lane < point_lanes; ++lane) {
        mask |= (distances[lane] <= limit ? 1U : 0U) << lane;
    }
    return mask;
}

// What a search for the one nearest point keeps.
struct NearestOne {
    Neighbor& found;
    double reach;

    [[nodiscard]] double limit() const noexcept { return reach; }

    void offer(const Neighbor& other) noexcept {
        if (other.distance_squared > reach) return;
        if (other.distance_squared == found.distance_squared && other.prim > found.prim) return;
        found = other;
        reach = other.distance_squared;
    }
};

// The same for all within a distance; a limit of -1 ends the search.
struct AllWithin {
    Visitor<Neighbor> visit;
    double reach;

    [[nodiscard]] double limit() const noexcept { return reach; }

    void offer(const Neighbor& other) noexcept {
        if (other.distance_squared <= reach && !visit(other)) reach = -1.0;
    }
};

template <typename Keeper>
class Search {
public:
    Search(const SearchedPoints& points, Vec3f from, Keeper& keeper) noexcept
        : points_(points), from_(to_double(from)), keeper_(keeper) {}

    void run() noexcept {
        Entry at{bounds_of_root(), 0};
        if (!(bound_of(at.squares) <= keeper_.limit())) return;
        do {
            while (!points_.tree.nodes()[at.node].is_leaf()) {
                step_down(at);
            }
            visit_leaf(points_.tree.nodes()[at.node]);
        } while (pop(at));
    }

private:
    struct Entry {
        Vec3d squares;  // of the distances to the node, axis by axis
        std::uint32_t node;
    };

    static double bound_of(Vec3d squares) noexcept { return squares.x + squares.y + squares.z; }

    [[nodiscard]] Vec3d bounds_of_root() const noexcept {
        const Aabb& box = points_.tree.bounds();
        Vec3d squares;
        for (const Axis axis : all_axes) {
            const double outside = std::max(0.0, std::max(box.lower[axis] - from_[axis],
                                                          from_[axis] - box.upper[axis]));
            squares[axis] = outside * outside;
        }
        return squares;
    }

    // The next entry that is near enough, or false.
    bool pop(Entry& at) noexcept {
        while (size_ > 0) {
            at = stack_[--size_];
            if (bound_of(at.squares) <= keeper_.limit()) return true;
        }
        return false;
    }

    // Goes on to the nearer child and leaves the other on the stack if it is near enough.
    void step_down(Entry& at) noexcept {
        const KdNode& node = points_.tree.nodes()[at.node];
        const double beyond = from_[node.axis()] - static_cast<double>(node.position());
        const std::uint32_t is_above = beyond > 0.0 ? 1 : 0;
        Entry far{at.squares, node.lower_child() + (1 - is_above)};
        far.squares[node.axis()] = beyond * beyond;
        if (bound_of(far.squares) <= keeper_.limit()) stack_[size_++] = far;
        at.node = node.lower_child() + is_above;
    }

    void visit_leaf(const KdNode& leaf) noexcept {
        const std::size_t end = leaf.first_reference() + std::size_t{leaf.reference_count()};
        for (std::size_t at = leaf.first_reference(); at < end; at += point_lanes) {
            LaneDistances distances;
            measure_points(points_, at, from_, distances);
            unsigned rest = mask_within(distances, keeper_.limit());
            if (end - at < point_lanes) rest &= (1U << (end - at)) - 1U;
            for (; rest != 0; rest &= rest - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
                keeper_.offer({distances[lane], points_.tree.references()[at + lane]});
            }
        }
    }

    const SearchedPoints& points_;
    Vec3d from_;
    Keeper& keeper_;
    std::size_t size_ = 0;
    std::array<Entry, max_stack> stack_;
};

void nearest(const SearchedPoints& points, Vec3f point, double limit, Neighbor& found) noexcept {
    NearestOne keeper{found, limit};
    Search<NearestOne>(points, point, keeper).run();
}

std::size_t nearest_k(const SearchedPoints& points, Vec3f point, double limit,
                      std::span<Neighbor> found) noexcept {
    NearestSet<Neighbor> keeper(found, limit);
    Search<NearestSet<Neighbor>>(points, point, keeper).run();
    return keeper.sort();
}

void within(const SearchedPoints& points, Vec3f point, double limit,
            Visitor<Neighbor> visit) noexcept {
    AllWithin keeper{visit, limit};
    Search<AllWithin>(points, point, keeper).run();
}

void overlapping(const SearchedPoints& points, const Aabb& box,
                 Visitor<std::uint32_t> visit) noexcept {
    const auto is_inside = [&](std::size_t at) {
        return box.contains({points.x[at], points.y[at], points.z[at]});
    };
    std::array<std::uint32_t, max_stack> stack;
    stack[0] = 0;
    for (std::size_t size = 1; size > 0;) {
        const KdNode& node = points.tree.nodes()[stack[--size]];
        if (!node.is_leaf()) {
            const Axis axis = node.axis();
            if (box.upper[axis] >= node.position()) stack[size++] = node.upper_child();
            if (box.lower[axis] <= node.position()) stack[size++] = node.lower_child();
            continue;
        }
        const std::size_t end = node.first_reference() + std::size_t{node.reference_count()};
        for (std::size_t at = node.first_reference(); at < end; ++at) {
            if (is_inside(at) && !visit(points.tree.references()[at])) return;
        }
    }
}

constexpr PointSearchKernels kernels{&nearest, &nearest_k, &within, &overlapping};
