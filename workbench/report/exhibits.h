#pragma once

#include "coppice/geom/aabb.h"
#include "coppice/geom/triangle_mesh.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coppice::report {

/// An image as a file.
struct Picture {
    std::string png;  ///< the bytes of a PNG file; empty: there is none
    int width = 0;    ///< pixels
    int height = 0;   ///< the same
};

/// What the colours of an image stand for: `colors`, evenly spread, from `low` to `high`. What is
/// outside has the colour of the end.
struct ColorScale {
    std::vector<std::string> colors;  ///< "#rrggbb", at least two
    double low = 0.0;
    double high = 1.0;
};

/// Which tree of the experiment.
struct TreeName {
    std::string protocol;
    double percent = 100.0;  ///< of the primitives, its sample
};

/// What rays through each pixel cost in two trees.
struct HeatMaps {
    Picture full;            ///< nodes visited and primitives tested, in the tree of all primitives
    Picture other;           ///< the same in the tree beside it; none if there is no such tree
    Picture difference;      ///< the steps of `other` less those of `full`
    ColorScale steps;        ///< of the first two
    ColorScale change;       ///< of the difference
    double full_mean = 0.0;  ///< steps a pixel's ray takes on average
    double other_mean = 0.0;  ///< the same
};

/// A node of a k-d tree, as a box.
struct Cell {
    Aabb box;
    double cost_share = 0.0;  ///< of the tree's cost, spent in this node and all below; in [0, 1]
    std::uint64_t reference_count = 0;  ///< in it and all below; 0: an empty leaf
};

/// The nodes of one level of a tree.
struct CellLevel {
    std::uint64_t cell_count = 0;   ///< of all there are
    std::uint64_t empty_count = 0;  ///< those that are empty leaves
    std::vector<Cell> shown;        ///< all of them, or so many evenly drawn
};

/// A scene in few words: triangles, or points on its surface.
struct SceneOutline {
    std::vector<Vec3f> positions;
    std::vector<TriangleIndices> triangles;  ///< none: the positions are points
    std::vector<std::uint8_t> shades;  ///< of each point: how bright it is; empty for triangles
};

/// From where something is looked at.
struct Viewpoint {
    Vec3f eye;
    Vec3f look_at;
    Vec3f up;
    double fov = 45.0;  ///< degrees, from the lower to the upper edge
};

/// What the tree inspector shows.
struct Inspector {
    Aabb bounds;  ///< of the scene; positions and boxes are within it
    Viewpoint viewpoint;
    SceneOutline outline;
    std::vector<CellLevel> full;   ///< level by level, the root's first
    std::vector<CellLevel> other;  ///< the same of the tree beside it; none if there is none
};

/// What the report shows of a scene beside its numbers. Whatever is missing is left out.
struct SceneExhibits {
    Picture picture;
    std::string picture_camera;     ///< the options of `coppice render` that see the same
    double seconds = 0.0;           ///< it took to make all this
    std::string kind;               ///< of the primitives of the two trees
    TreeName full;                  ///< the tree of all primitives
    std::optional<TreeName> other;  ///< the one beside it
    bool is_recommended = false;    ///< whether the rule recommends `other`
    std::optional<HeatMaps> heat_maps;
    std::optional<Inspector> inspector;
    std::string missing;  ///< a sentence on what there is not, and why; or nothing
};

}  // namespace coppice::report
