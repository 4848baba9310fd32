// Traversal of the 8-wide tree: included once for each instruction set, in a namespace of its own,
// after that set's lanes_*.inl.
//
// Boxes: all eight children are cut with the ray at once. Differences and reciprocals in float are
// off by 3 units of rounding at most, and intervals are widened by 8 [Ize2013], so no box that the
// ray touches is passed over. A direction component of zero (or -0) gives infinite distances, or
// NaN where the origin lies in the plane of a face; minimum and maximum then take their second
// argument, so such a face does not cut.
//
// Triangles: eight at a time are sifted with edge functions in float [Woop2013 in the form of
// Davidovic2012: volumes of edges and ray], with a bound on all that rounding can do; what remains,
// about one triangle a hit, is decided in double by TriangleTest. So hits are those of brute force
// on every instruction set, and watertight.
//
// Stack: an inner node leaves at most 7 entries, and no node is deeper than
// WideBvh::max_depth.

constexpr std::size_t max_stack = (wide_width - 1) * WideBvh::max_depth + 1;

struct Lanes3 {
    Lanes x;
    Lanes y;
    Lanes z;
};

inline Lanes3 operator-(const Lanes3& a, const Lanes3& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Lanes3 operator+(const Lanes3& a, const Lanes3& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Lanes sum_of_abs(const Lanes3& a) noexcept {
    return abs(a.x) + (abs(a.y) + abs(a.z));
}

inline Lanes3 broadcast(Vec3f v) noexcept {
    return {broadcast(v.x), broadcast(v.y), broadcast(v.z)};
}

// More than all that rounding does to a distance.
constexpr float shrink = 1.0F - 0x1.0p-21F;
constexpr float grow = 1.0F + 0x1.0p-21F;

// Hits count by their rounded t: those a little outside of an interval may belong to it. The least
// slack is far from the denormal numbers, which are slow to calculate with.
inline float above(float t) noexcept {
    return std::max(t * shrink, t * grow) + 0x1.0p-100F;
}

inline float below(float t) noexcept {
    return std::min(t * shrink, t * grow) - 0x1.0p-100F;
}

// The reciprocal of a direction's component, or NaN where it or a distance to a box could overflow:
// then nothing is cut on that axis.
inline float inverse_of(Axis axis, const Ray& ray, const Aabb& bounds) noexcept {
    constexpr float far = 0x1.0p126F;
    const float direction = ray.direction[axis];
    const bool is_tiny = direction != 0.0F && std::abs(direction) < 0x1.0p-100F;
    const bool is_near = std::abs(ray.origin[axis]) < far && bounds.lower[axis] > -far &&
                         bounds.upper[axis] < far;
    return is_near && !is_tiny ? 1.0F / direction : std::numeric_limits<float>::quiet_NaN();
}

// A ray as the kernels use it. Reciprocals are off by half a unit of rounding, differences and
// products by as much again: distances to near planes are taken a little too small and those to far
// planes a little too large [Ize2013]. That is so for positive distances; negative ones matter only
// to rays with t_min < 0, whose boxes are met by meet_boxes_behind().
struct LaneRay {
    LaneRay(const Ray& ray, const Aabb& bounds) noexcept
        : LaneRay(ray, Vec3f{inverse_of(Axis::x, ray, bounds), inverse_of(Axis::y, ray, bounds),
                        inverse_of(Axis::z, ray, bounds)}) {}

    LaneRay(const Ray& ray, Vec3f inverse) noexcept
        : origin(broadcast(ray.origin)),
          direction(broadcast(ray.direction)),
          to_near(broadcast(shrink * inverse)),
          to_far(broadcast(grow * inverse)),
          direction_size(sum_of_abs(direction)),
          near{near_row(Axis::x, ray), near_row(Axis::y, ray), near_row(Axis::z, ray)} {}

    // The row of WideNode::bound that the ray comes to first; the other is 3 away.
    static std::size_t near_row(Axis axis, const Ray& ray) noexcept {
        return static_cast<std::size_t>(axis) + (std::signbit(ray.direction[axis]) ? 3 : 0);
    }

    Lanes3 origin;
    Lanes3 direction;
    Lanes3 to_near;
    Lanes3 to_far;
    Lanes direction_size;
    std::array<std::size_t, 3> near;
};

struct BoxHits {
    unsigned mask;
    Lanes enter;
};

struct Distances {
    Lanes3 near;
    Lanes3 far;
};

// To the six planes of each child's box.
inline Distances measure_boxes(const WideNode& node, const LaneRay& ray) noexcept {
    const auto near = [&](std::size_t axis, Lanes origin, Lanes inverse) {
        return (load(node.bound[ray.near[axis]]) - origin) * inverse;
    };
    const auto far = [&](std::size_t axis, Lanes origin, Lanes inverse) {
        return (load(node.bound[2 * axis + 3 - ray.near[axis]]) - origin) * inverse;
    };
    return {{near(0, ray.origin.x, ray.to_near.x), near(1, ray.origin.y, ray.to_near.y),
             near(2, ray.origin.z, ray.to_near.z)},
            {far(0, ray.origin.x, ray.to_far.x), far(1, ray.origin.y, ray.to_far.y),
             far(2, ray.origin.z, ray.to_far.z)}};
}

// The children whose boxes the ray meets between enter and exit.
inline BoxHits meet_boxes(const WideNode& node, const LaneRay& ray, Lanes enter,
                          Lanes exit) noexcept {
    const auto [near, far] = measure_boxes(node, ray);
    // Two by two: of a NaN the second argument is left, at worst less is cut.
    enter = max(max(near.x, near.y), max(near.z, enter));
    exit = min(min(far.x, far.y), min(far.z, exit));
    return {less_equal(enter, exit), enter};
}

// The same for distances of either sign.
inline BoxHits meet_boxes_behind(const WideNode& node, const LaneRay& ray, Lanes enter,
                                 Lanes exit) noexcept {
    const auto [near, far] = measure_boxes(node, ray);
    const Lanes low = broadcast(shrink * shrink * shrink);
    const Lanes high = broadcast(grow * grow * grow);
    const auto lowest = [&](Lanes t) { return min(t * low, t * high); };
    const auto highest = [&](Lanes t) { return max(t * low, t * high); };
    enter = max(max(lowest(near.x), lowest(near.y)), max(lowest(near.z), enter));
    exit = min(min(highest(far.x), highest(far.y)), min(highest(far.z), exit));
    return {less_equal(enter, exit), enter};
}

// Twice the volume between the ray and an edge from `a` to `b`, by both as seen from its origin.
inline Lanes edge_volume(const LaneRay& ray, const Lanes3& a, const Lanes3& b) noexcept {
    const Lanes3 edge = b - a;
    const Lanes3 sum = b + a;
    const Lanes x = edge.y * sum.z - edge.z * sum.y;
    const Lanes y = edge.z * sum.x - edge.x * sum.z;
    const Lanes z = edge.x * sum.y - edge.y * sum.x;
    return x * ray.direction.x + (y * ray.direction.y + z * ray.direction.z);
}

// The triangles that the ray may hit, rounding considered, at any distance.
inline unsigned sift_triangles(const TriangleBlock& block, const LaneRay& ray) noexcept {
    const auto corner = [&](std::size_t at) {
        const auto& axes = block.corner[at];
        return Lanes3{load(axes[0]), load(axes[1]), load(axes[2])} - ray.origin;
    };
    const Lanes3 a = corner(0);
    const Lanes3 b = corner(1);
    const Lanes3 c = corner(2);
    const Lanes ab = edge_volume(ray, a, b);
    const Lanes bc = edge_volume(ray, b, c);
    const Lanes ca = edge_volume(ray, c, a);
    const Lanes size = sum_of_abs(b - a) + sum_of_abs(c - a);
    const Lanes reach = sum_of_abs(a) + size;
    // Corners are off by 2^-24 of their distance, products and sums by a few times 2^-24: together
    // by less than 2^-19 reach size |direction|. What underflows is less than 2^-120 of 1 +
    // |direction|.
    const Lanes error = broadcast(0x1.0p-19F) * (reach * size * ray.direction_size) +
                        broadcast(0x1.0p-120F) * (ray.direction_size + broadcast(1.0F));
    const Lanes least = min(ab, min(bc, ca));
    const Lanes most = max(ab, max(bc, ca));
    const Lanes zero = broadcast(0.0F);
    // What overflowed is NaN and stays; lanes without a triangle are NaN from the start.
    const unsigned is_outside = less(least + error, zero) & less(zero, most - error);
    const Lanes first = load(block.corner[0][0]);
    return less_equal(first, first) & ~is_outside;
}

struct Entry {
    float enter;
    WideChild child;
};

template <bool any_hit, bool from_behind>
class Traversal {
public:
    Traversal(const WideBvh& tree, const Ray& ray) noexcept
        : tree_(tree),
          lanes_(ray, tree.bounds()),
          test_(ray),
          enter_(broadcast(below(ray.t_min))),
          exit_(broadcast(above(ray.t_max))) {
        hit_.t = ray.t_max;
    }

    bool run(Hit& hit) noexcept {
        Entry at{0.0F, WideChild::make_inner(0)};
        for (;;) {
            if (!at.child.is_leaf()) {
                if (step_down(tree_.nodes()[at.child.node()], at)) continue;
            } else if (visit_leaf(at.child) && any_hit) {
                break;
            }
            if (!pop(at)) break;
        }
        hit = hit_;
        return has_hit_;
    }

private:
    // The next entry not behind the closest hit, or false.
    bool pop(Entry& at) noexcept {
        while (size_ > 0) {
            at = stack_[--size_];
            if (at.enter <= limit_) return true;
        }
        return false;
    }

    // Goes on to the nearest child that the ray meets and leaves the others on the stack, the
    // nearer ones on top; false if it meets none.
    bool step_down(const WideNode& node, Entry& at) noexcept {
        const BoxHits met = from_behind ? meet_boxes_behind(node, lanes_, enter_, exit_)
                                        : meet_boxes(node, lanes_, enter_, exit_);
        if (met.mask == 0) return false;
        if ((met.mask & (met.mask - 1)) == 0) {
            at.child = node.child[static_cast<std::size_t>(std::countr_zero(met.mask))];
            return true;
        }
        alignas(32) std::array<float, 8> enter;
        store(met.enter, enter);
        const auto entry_of = [&](unsigned mask) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(mask));
            return Entry{enter[slot], node.child[slot]};
        };
        at = entry_of(met.mask);
        const std::size_t first = size_;
        for (unsigned rest = met.mask & (met.mask - 1); rest != 0; rest &= rest - 1) {
            Entry other = entry_of(rest);
            if (other.child.is_empty()) break;  // met only if no axis cuts; the rest is empty too
            if (other.enter < at.enter) std::swap(other, at);
            std::size_t place = size_++;
            for (; place > first && stack_[place - 1].enter < other.enter; --place)
                stack_[place] = stack_[place - 1];
            stack_[place] = other;
        }
        return !at.child.is_empty();
    }

    // True if something in the leaf is hit, closer than all before.
    bool visit_leaf(WideChild leaf) noexcept {
        bool is_hit = false;
        const TriangleBlock* block = &tree_.blocks()[leaf.first_block()];
        for (std::uint32_t count = leaf.block_count(); count > 0; --count, ++block) {
            for (unsigned rest = sift_triangles(*block, lanes_); rest != 0; rest &= rest - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
                is_hit |= test_triangle(*block, lane);
            }
        }
        return is_hit;
    }

    bool test_triangle(const TriangleBlock& block, std::size_t lane) noexcept {
        const auto found = test_(block.triangle(lane), hit_.t);
        const std::uint32_t id = block.id[lane];
        if (!found || (has_hit_ && found->t == hit_.t && id > hit_.prim)) return false;
        hit_ = {found->t, found->u, found->v, id};
        has_hit_ = true;
        limit_ = above(found->t);
        exit_ = broadcast(limit_);
        return true;
    }

    const WideBvh& tree_;
    LaneRay lanes_;
    TriangleTest test_;
    Lanes enter_;
    Lanes exit_;
    float limit_ = std::numeric_limits<float>::infinity();
    Hit hit_;
    bool has_hit_ = false;
    std::size_t size_ = 0;
    std::array<Entry, max_stack> stack_;
};

template <bool any_hit>
bool trace(const WideBvh& tree, const Ray& ray, Hit& hit) noexcept {
    if (!is_traceable(ray)) return false;
    if (ray.t_min < 0.0F) return Traversal<any_hit, true>(tree, ray).run(hit);
    return Traversal<any_hit, false>(tree, ray).run(hit);
}

constexpr TraceKernels kernels{&trace<false>, &trace<true>};
