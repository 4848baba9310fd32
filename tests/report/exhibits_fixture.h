#pragma once

#include "report/exhibits.h"

#include <string>

namespace coppice::report::test {

/// Exhibits of a scene of four corners, with bytes in place of images.
inline SceneExhibits make_exhibits() {
    const Picture picture{"PNG", 3, 2};
    SceneExhibits exhibits;
    exhibits.picture = picture;
    exhibits.picture_camera = "--eye=1,2,3";
    exhibits.kind = "triangles";
    exhibits.full = {"grown", 100.0};
    exhibits.other = TreeName{"grown", 1.0};
    exhibits.is_recommended = true;
    exhibits.heat_maps = HeatMaps{picture,
                                  picture,
                                  picture,
                                  {{"#000000", "#ffffff"}, 0.0, 500.0},
                                  {{"#0000ff", "#ff0000"}, -50.0, 50.0},
                                  20.0,
                                  25.0};
    Inspector inspector;
    inspector.bounds = {{-1, -2, 0}, {3, 2, 0}};
    inspector.viewpoint = {{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 45.0};
    inspector.outline.positions = {{-1, -2, 0}, {3, -2, 0}, {3, 2, 0}, {3, 2, 0}, {-1, 2, 0}};
    inspector.outline.triangles = {{0, 1, 2}, {0, 3, 4}};
    const CellLevel root{1, 0, {{inspector.bounds, 1.0, 2}}};
    const CellLevel halves{
        2, 1, {{{{-1, -2, 0}, {1, 2, 0}}, 0.25, 2}, {{{1, -2, 0}, {3, 2, 0}}, 0.0, 0}}};
    inspector.full = {root, halves};
    inspector.other = {root};
    exhibits.inspector = inspector;
    return exhibits;
}

}  // namespace coppice::report::test
