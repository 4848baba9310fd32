// What Assimp reads: the first byte chooses the format, the others are the file.

#include "load.h"
#include "scratch_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace {

constexpr std::array extensions{"stl", "gltf", "glb", "dae", "x3d", "3ds",  "fbx", "blend",
                                "lwo", "x",    "ase", "dxf", "ac",  "ms3d", "3mf", "md5mesh"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string name = std::string("scene.") + extensions[data[0] % extensions.size()];
    coppice::fuzz::load_anything(
        coppice::fuzz::scratch_folder().write(name, coppice::fuzz::text_of({data + 1, size - 1})));
    return 0;
}
