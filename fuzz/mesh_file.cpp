// Our own readers: the first byte chooses the format, the others are the file. Of a material
// library the scene is given.

#include "load.h"
#include "scratch_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace {

using coppice::fuzz::scratch_folder;

constexpr std::array names{"scene.obj",    "scene.obj.gz", "scene.ply",
                           "scene.ply.gz", "scene.off",    "library.mtl"};

constexpr std::string_view scene_with_library =
    "mtllib library.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string name = names[data[0] % names.size()];
    const auto file = scratch_folder().write(name, coppice::fuzz::text_of({data + 1, size - 1}));
    const bool is_library = name.ends_with(".mtl");
    coppice::fuzz::load_anything(is_library ? scratch_folder().write("with.obj", scene_with_library)
                                            : file);
    return 0;
}
