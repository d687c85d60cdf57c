// The demo scene cembox, version 1: the box of a control module that is drawn out of its guide rails in a
// crowded engine bay. A version never changes what an option set makes; a better scene is a new version
// beside it.
#pragma once

#include "program/scenes/generated_scene.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

/// The clearance can be 0.5 to 8 mm.
constexpr SceneOptions kCembox{1, 30000, 500000, 4};

/// The part and the environment in millimetres, all coordinates representable in float, every component a
/// closed solid.
///
/// x to the left, y to the rear, z up. The module stands in two rails in front of the bulkhead; the box of
/// the part has a diagonal of about 390 mm. The path begins there: straight up along the rails, with a gap of
/// at least `clearance` and at most 1.5 times as much until the part has left them; then tilted under the
/// wiper's tube, out over the strut brace, and turned. Beyond the rails nothing is nearer than 1.5 times the
/// clearance, nor than 3 times once the part is above them. problem.step is half the thinnest sheet.
///
/// The shapes need about 3,300 and 41,000 triangles; there are more details, and finer ones, the more are
/// asked for. Neighbours may reach into each other a little where sheets are joined or screws are driven in.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is less than the shape needs, or above 4 million.
GeneratedScene makeCembox(const SceneOptions& options);

/// Version 2: the same module, rails and path in a bay with more to it: bumper and grille, subframe, steering
/// and drive shafts, insulation in layers, sheets with lightening holes, wipers. Where fewer triangles are
/// asked for than all components have when coarsest, small ones are left out.
GeneratedScene makeCembox2(const SceneOptions& options);

}  // namespace clearway::scenes
