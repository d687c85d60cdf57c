// The demo scene tunnel-console: a centre console that must be threaded out of the bent tunnel it just fits.
// A version never changes what an option set makes; a better scene is a new version beside it.
#pragma once

#include "program/scenes/generated_scene.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

/// A size that planners solve in seconds. The clearance can be 1 to 25 mm.
constexpr SceneOptions kTunnelConsole{1, 2000, 8000, 10};
/// As large as a car maker's.
constexpr SceneOptions kTunnelConsole3{1, 73425, 300401, 10};

/// The part and the environment in millimetres, all coordinates representable in float, every component a
/// closed solid.
///
/// Part and tunnel are swept along one screw (see Screw), so that the part can be turned out of the tunnel
/// with a gap that stays as it is: at least `clearance`, and less than half as much again as long as the part
/// is in one of the ribs. The path is that motion, in chords, then one more motion through the free room to
/// the goal. The part's box has a diagonal of about 900 mm. problem.step is half the thinnest sheet.
///
/// Version 1 is near everywhere: the floor pan lies at the gap below the whole part, and every rib leaves it
/// all around. In version 2, as in a car, floor, walls and roof keep farther off, at least twice the
/// clearance (four times at 10 mm), and the gap is left in places: by mounts on the floor, guides on the
/// walls and some ribs, each on one side. Others of these kinds keep farther off, by different lengths.
///
/// Version 3 is version 2 with all that a car has there: sheets with beads, flanges and holes, flanged ribs,
/// bolts, brackets, pipes, hoses, cables, propeller shaft and exhaust; a console with bin, lid, gear lever,
/// vents, ribs and cables. At narrow clearances its sheets keep farther off.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is less than the shape needs at this clearance, or above 4 million.
GeneratedScene makeTunnelConsole1(const SceneOptions& options);
GeneratedScene makeTunnelConsole2(const SceneOptions& options);
GeneratedScene makeTunnelConsole3(const SceneOptions& options);

}  // namespace clearway::scenes
