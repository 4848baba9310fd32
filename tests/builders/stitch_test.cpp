#include "builders/stitch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace coppice::test {
namespace {

using testing::ElementsAre;

struct NamedPart {
    std::string name;
    std::size_t node_count;
    std::size_t item_count;
    std::vector<NamedPart> links;

    [[nodiscard]] std::size_t own_node_count() const { return node_count; }

    [[nodiscard]] std::size_t own_item_count() const { return item_count; }

    [[nodiscard]] std::size_t link_count() const { return links.size(); }

    NamedPart& link(std::size_t i) { return links[i]; }
};

// Root, below and items of each part, and the roots of what hangs below it.
template <LinkedRoots linked_roots>
std::map<std::string, std::vector<std::uint64_t>> places_of(NamedPart& part) {
    const Placement<NamedPart, linked_roots> placement(part);
    EXPECT_EQ(placement.node_count(), 10U);
    EXPECT_EQ(placement.item_count(), 11U);
    std::vector<typename Placement<NamedPart, linked_roots>::Placed> placed(4);
    placement.for_each([&](const auto& one) {
        placed[std::string("rabc").find(one.part->name)] = one;  // from several threads
    });
    std::map<std::string, std::vector<std::uint64_t>> places;
    for (const auto& one : placed) {
        std::vector<std::uint64_t>& numbers = places[one.part->name];
        numbers = {one.place.root, one.place.below, one.place.items};
        numbers.insert(numbers.end(), one.link_roots.begin(), one.link_roots.end());
    }
    return places;
}

NamedPart three_below_a_root() {
    return {"r", 2, 1, {{"a", 3, 4, {{"b", 1, 6, {}}}}, {"c", 4, 0, {}}}};
}

TEST(Placement, PutsRootsBeforeWhatIsBelowThem) {
    NamedPart part = three_below_a_root();
    const auto places = places_of<LinkedRoots::apart>(part);
    EXPECT_THAT(places.at("r"), ElementsAre(0, 1, 0, 2, 6));
    EXPECT_THAT(places.at("a"), ElementsAre(2, 3, 1, 5));
    EXPECT_THAT(places.at("b"), ElementsAre(5, 6, 5));
    EXPECT_THAT(places.at("c"), ElementsAre(6, 7, 11));
}

TEST(Placement, PutsRootsSideBySide) {
    NamedPart part = three_below_a_root();
    const auto places = places_of<LinkedRoots::together>(part);
    EXPECT_THAT(places.at("r"), ElementsAre(0, 1, 0, 2, 3));
    EXPECT_THAT(places.at("a"), ElementsAre(2, 4, 1, 6));
    EXPECT_THAT(places.at("b"), ElementsAre(6, 7, 5));
    EXPECT_THAT(places.at("c"), ElementsAre(3, 7, 11));
}

}  // namespace
}  // namespace coppice::test
