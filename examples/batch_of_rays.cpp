// A picture in depth: one ray a pixel, traced all at once.
#include <coppice/coppice.h>

#include <cstdio>
#include <vector>

int main() {
    const coppice::Scene scene(coppice::load_mesh("bunny.obj"));
    const coppice::Aabb box = scene.tree().bounds();
    constexpr int width = 48;
    constexpr int height = 24;

    std::vector<coppice::Ray> rays;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float right = (static_cast<float>(x) + 0.5F) / width;
            const float down = (static_cast<float>(y) + 0.5F) / height;
            rays.push_back(
                {.origin = {box.lower.x + right * (box.upper.x - box.lower.x),
                            box.upper.y - down * (box.upper.y - box.lower.y), box.upper.z + 1.0F},
                 .direction = {0, 0, -1}});
        }
    }

    std::vector<coppice::Hit> hits(rays.size());
    scene.intersect(rays, hits);  // on all threads

    const float depth = box.upper.z - box.lower.z;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const float behind = (hits[i].t - 1.0F) / depth;  // 0 in front, 1 at the back
        std::putchar(hits[i].is_hit() ? ".:-=+*#%@@"[9 - static_cast<int>(9.0F * behind)] : ' ');
        if (i % width == width - 1) std::putchar('\n');
    }
}
