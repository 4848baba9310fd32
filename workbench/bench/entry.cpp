#include "bench/entry.h"

#include "coppice/base/named.h"

#include "statistics/median.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace coppice::lab {

namespace {

/// Half the range over the median of what each run took to trace all rays.
double scatter_of(const BenchEntry& entry) {
    std::vector<double> totals(entry.wall_seconds.size(), 0.0);
    for (const std::vector<double>& runs : entry.trace_seconds) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            totals[i] += runs[i];
        }
    }
    const auto [least, most] = std::minmax_element(totals.begin(), totals.end());
    const double middle = median_of(totals);
    return middle > 0.0 ? 0.5 * (*most - *least) / middle : 0.0;
}

}  // namespace

std::vector<BenchEntry> make_entries(const BenchOptions& options, const BenchScene& scene,
                                     int threads) {
    std::vector<BenchEntry> entries;
    const auto add = [&](const std::string& name, bool is_peer,
                         std::unique_ptr<Contestant> contestant) {
        BenchEntry& entry = entries.emplace_back();
        entry.row.scene = scene.scene;
        entry.row.triangles = scene.triangles;
        entry.row.method = name;
        entry.row.is_peer = is_peer;
        entry.row.threads = threads;
        entry.contestant = std::move(contestant);
    };
    for (const std::string& name : options.methods) {
        add(name, false, make_contestant(find_variant(name), threads, options.memory_limit_bytes));
    }
    for (const std::string& name : options.peers) {
        add(name, true, find_named(peer_registry(), name, "peer").make(threads));
    }
    return entries;
}

std::vector<BenchEntry*> take_turns(std::vector<BenchEntry>& entries) {
    std::array<std::vector<BenchEntry*>, 2> sides;
    for (BenchEntry& entry : entries) {
        sides[entry.row.is_peer ? 1 : 0].push_back(&entry);
    }
    std::vector<BenchEntry*> order;
    for (std::size_t i = 0; order.size() < entries.size(); ++i) {
        for (const auto& side : sides) {
            if (i < side.size()) order.push_back(side[i]);
        }
    }
    return order;
}

BenchRow finished_row(const BenchEntry& entry, std::span<const RayKind> kinds,
                      std::span<const std::uint64_t> ray_counts) {
    BenchRow row = entry.row;
    row.build_seconds = median_of(entry.wall_seconds);
    row.build_cpu_seconds = median_of(entry.cpu_seconds);
    for (const RayKind kind : kinds) {
        const std::size_t index = index_of(kind);
        if (ray_counts[index] == 0) continue;  // nothing was hit that a ray could start from
        row.mrays[index] =
            1e-6 * static_cast<double>(ray_counts[index]) / median_of(entry.trace_seconds[index]);
    }
    row.scatter = scatter_of(entry);
    return row;
}

}  // namespace coppice::lab
