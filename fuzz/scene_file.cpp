// What Assimp reads: the first byte chooses the format, the others are the file. It reads them in a
// process of its own (docs/decisions/0007), and what it breaks there is no finding: what it does
// to this one would be.

#include "load.h"
#include "scratch_file.h"

#include <pthread.h>
#include <sanitizer/common_interface_defs.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace {

constexpr std::array extensions{"stl", "gltf", "glb", "dae", "x3d", "3ds",  "fbx", "blend",
                                "lwo", "x",    "ase", "dxf", "ac",  "ms3d", "3mf", "md5mesh"};

// The fuzzer would have it write a reproducer.
void die_quietly_in_copies() {
    static const int once =
        pthread_atfork(nullptr, nullptr, [] { __sanitizer_set_death_callback([] {}); });
    coppice::fuzz::expect(once == 0, "a handler of forks");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    die_quietly_in_copies();
    const std::string name = std::string("scene.") + extensions[data[0] % extensions.size()];
    coppice::fuzz::load_anything(
        coppice::fuzz::scratch_folder().write(name, coppice::fuzz::text_of({data + 1, size - 1})));
    return 0;
}
