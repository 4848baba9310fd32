// What a program that used madmann91/bvh does with coppice: build, trace, save the tree and load it
// again.
#include <coppice/coppice.h>

#include <cstdio>
#include <filesystem>

int main() {
    const coppice::TriangleMesh mesh = coppice::load_mesh("bunny.obj");

    // DefaultBuilder::build: boxes and centers are the builder's own business.
    const coppice::Bvh8Tracer tracer(coppice::build_bvh8(mesh.view()).tree);

    // Bvh::intersect<false, true>: no stack, no callback; triangles are tested inside.
    const coppice::Ray ray{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    if (const auto hit = tracer.intersect(ray)) {
        std::printf("triangle %u at t = %g, (u, v) = (%g, %g)\n", hit->prim, hit->t, hit->u,
                    hit->v);
    }

    // Bvh::intersect<true, true>
    std::printf("%s\n", tracer.occluded(ray) ? "occluded" : "free");

    // Bvh::serialize and Bvh::deserialize: checked, and mapped instead of read.
    const auto file = std::filesystem::temp_directory_path() / "coppice_from_madmann91_bvh.cpk";
    const coppice::Fingerprint fingerprint = coppice::fingerprint_of(mesh.view());
    coppice::save_tree(file, tracer.tree(), fingerprint);
    const coppice::SavedTree saved = coppice::load_tree(file, fingerprint);
    std::printf("%llu bytes\n", static_cast<unsigned long long>(saved.file_bytes));
    std::filesystem::remove(file);
}
