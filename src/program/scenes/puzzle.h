// The demo scene puzzle: two interlocked bent bars. The part runs through the eye at the other's
// end and must be slid through it, bend after bend, to come free. A version never
// changes what an option set makes; a better scene is a new version beside it.
#pragma once

#include "program/scenes/generated_scene.h"
#include "program/scenes/scene_options.h"

namespace clearway::scenes {

constexpr SceneOptions kPuzzle{1, 2000, 2000, 2};  // clearance 0.1 to 10 mm

/// Both bars are round, 10 mm thick, closed solids with coordinates representable in float; the part measures
/// about 200 mm. The part has a loop at one end that does not pass the eye, and bends in several planes. In
/// version 1 the beginning of a loop runs into the bar behind its end; in version 2 no bar meets itself:
/// neither loop is quite closed, but its gap is narrower than a bar.
///
/// The path keeps the part's middle line on the eye's axis, where it leaves the clearance and less than half
/// as much again; when the end has come through, it pulls and turns the part clear of the other bar.
/// problem.step is a quarter of a bar's thickness.
///
/// Throws std::invalid_argument, naming the option, its value and what was expected, when the clearance is
/// out of range or a number of triangles is less than the bars need, or above 4 million.
GeneratedScene makePuzzle(const SceneOptions& options);
GeneratedScene makePuzzle2(const SceneOptions& options);

}  // namespace clearway::scenes
