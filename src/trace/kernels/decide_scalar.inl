// One triangle of a block decided in double precision. Part of a kernel source.

// True if the ray hits the triangle at a t of at most t_max, and then the hit.
inline bool decide(const TriangleBlock& block, std::size_t lane, const Ray& ray,
                   const RayAxes& /*axes*/, float t_max, Hit& hit) noexcept {
    return decide_alone(block, lane, ray, t_max, hit);
}
