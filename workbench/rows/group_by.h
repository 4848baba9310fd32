#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace coppice::lab {

/// Items that are alike, at least one, in their order.
template <typename Item>
using Group = std::vector<const Item*>;

/// Groups the items that are alike by `is_alike(a, b)`, an equivalence. Groups are in the order of
/// their first items. The items must outlive the groups.
template <typename Item, typename IsAlike>
[[nodiscard]] std::vector<Group<Item>> group_by(std::span<const Item> items, IsAlike&& is_alike) {
    std::vector<Group<Item>> groups;
    for (const Item& item : items) {
        const auto at = std::find_if(groups.begin(), groups.end(), [&](const Group<Item>& group) {
            return is_alike(*group.front(), item);
        });
        if (at == groups.end()) {
            groups.push_back({&item});
        } else {
            at->push_back(&item);
        }
    }
    return groups;
}

}  // namespace coppice::lab
