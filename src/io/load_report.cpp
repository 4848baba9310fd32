#include "coppice/io/load_mesh.h"

namespace coppice::inline v0 {

void LoadIssue::add(std::uint64_t place) {
    ++count;
    if (first.size() < kept_places) {
        first.push_back(place);
    }
}

}  // namespace coppice::inline v0
