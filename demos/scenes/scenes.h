// The demo scenes: their options, the generators' results, the table of all scenes, and how a scene becomes
// files. A name ends with a version. A version makes equal scenes from equal options for as long as the
// program has it; a better scene is a new version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"
#include "demos/scenes/replay.h"

namespace clearway::scenes {

/// Equal options make equal scenes on every machine, up to the last digits of sine and cosine.
struct SceneOptions {
    std::uint64_t seed = 1;                ///< varies the details
    std::size_t partTriangles = 0;         ///< reached within 5 %
    std::size_t environmentTriangles = 0;  ///< reached within 5 %
    double clearance = 0;                  ///< least distance along the constructed path, environment units
};

struct GeneratedScene {
    std::string name;  ///< of the files
    Mesh part;
    Mesh environment;
    Problem problem;  ///< start and goal, like the path, refer to the part's coordinates as stored here
    std::vector<PartState> path;
};

struct NamedScene {
    const char* name;   ///< with its version: "tunnel-console-3"
    const char* about;  ///< one line, for lists
    SceneOptions defaults;
    /// Throws std::invalid_argument that names the option, its value and what was expected if the scene
    /// cannot be made.
    GeneratedScene (*make)(const SceneOptions& options);
    Replay replay{};              ///< the poses written for benchmarks
    const char* preview = "iso";  ///< the view of the scene's picture
};

// The generators. All scenes are in millimetres, every component is a closed solid, and all coordinates are
// representable in float. A generator throws std::invalid_argument that names the option, its value and what
// was expected when the clearance is out of its range, when a number of triangles is smaller than the shapes
// need (for some scenes at this clearance and seed), or when it is above 4 million.

/// A piano is carried through two doors and a corridor into the music room: the piano mover's problem. Walls,
/// doors, frames and furniture have names that begin with the room's. There is no ceiling, but the problem's
/// volume leaves no room above the walls. The piano, 1500 long and 600 deep, passes both doors lengthwise
/// with the clearance on either side and at most a tenth more; it turns in the corridor. problem.fineness is half
/// a door leaf's thickness.
constexpr SceneOptions kApartment{1, 3000, 8000, 60};  // clearance 5 to 70 mm
GeneratedScene makeApartment(const SceneOptions& options);

/// A box slides along two others, face to face. Very many pairs of triangles of parallel faces are equally
/// near. Each box's faces are cut into grids (see gridBox) and lie exactly in planes x, y or z = constant.
/// The path does not turn the part: it leads along the floor and the wall at a gap of the clearance and a
/// hundredth more, then up the wall at that gap, then away from it. The numbers of triangles are reached up
/// to three. problem.fineness is half the wall's thickness. A part has 12 triangles or more, an environment 24.
constexpr SceneOptions kBoxes{1, 100, 700, 2};  // clearance 0.01 to 20 mm
GeneratedScene makeBoxes(const SceneOptions& options);

/// The box of a control module is drawn out of its guide rails in a crowded engine bay. x points to the left,
/// y to the rear, z up. The module stands in two rails in front of the bulkhead; the part's bounding box has
/// a diagonal of about 390 mm. The path leads straight up along the rails, with a gap of at least the
/// clearance and at most 1.5 times as much until the part has left them; then the part is tilted under the
/// wiper's tube, drawn out over the strut brace, and turned. Beyond the rails nothing is nearer than 1.5
/// times the clearance, or 3 times once the part is above the rails. problem.fineness is half the thinnest sheet.
///
/// Larger numbers of triangles give more and finer details. Neighbours may reach into each other a little
/// where sheets are joined or screws are driven in. If fewer triangles are asked for than the coarsest
/// components have, small components are left out.
constexpr SceneOptions kCembox{1, 30000, 500000, 4};  // clearance 0.5 to 8 mm
GeneratedScene makeCembox2(const SceneOptions& options);

/// The tray of a sliding roof (0.88 x 0.88 m) is drawn out under the roof of a car body (3.9 x 1.6 x 1.3 m)
/// of fine sheets that follow each other in layers. The path leads to the rear along the roof's curve,
/// between two beaded sheets that follow the tray's own over all of its area, until the tray has left them
/// behind the car; then up and away. In front of the tray's opening the sheets are at least the clearance and
/// less than half as much more away from the tray all along the slot; towards its edges they are a few
/// millimetres farther. problem.fineness is half the thinnest sheet. If fewer triangles are asked for than all
/// components have when coarsest, small components are left out.
constexpr SceneOptions kLargeEnvironment2{1, 120000, 1700000, 10};  // clearance 1 to 12 mm
GeneratedScene makeLargeEnvironment2(const SceneOptions& options);

/// A round peg, tilted beside a block, is put into the block's hole. The clearance says how narrow the
/// passage is. The peg, 30 mm thick with a chamfer, carries a head and a square drive; the block is 50 mm
/// high and stands on a base. The path leads straight down the hole's axis once the peg has come upright
/// above it: in the hole it leaves the clearance all round and at most a tenth more. problem.fineness is a
/// quarter of the block's wall. Both meshes have 300 triangles or more.
constexpr SceneOptions kPegInHole{1, 2000, 2000, 1};  // clearance 0.01 to 10 mm
GeneratedScene makePegInHole(const SceneOptions& options);

/// Two interlocked bent bars: the part runs through the eye at the other's end and must be slid through it,
/// bend after bend, to come free. Both bars are round and 10 mm thick; the part measures about 200 mm. It has
/// a loop at one end that does not pass the eye, and bends in several planes. In version 1 the beginning of a
/// loop runs into the bar behind its end; in version 2 no bar meets itself: both loops are slightly open, but
/// their gaps are narrower than a bar. The path keeps the part's middle line on the eye's axis, where it
/// leaves the clearance and less than half as much more; when the end has come through, the path pulls and
/// turns the part clear of the other bar. problem.fineness is a quarter of a bar's thickness.
constexpr SceneOptions kPuzzle{1, 2000, 2000, 2};  // clearance 0.1 to 10 mm
GeneratedScene makePuzzle(const SceneOptions& options);
GeneratedScene makePuzzle2(const SceneOptions& options);

/// A box passes the windows of three walls, which stand aside of each other. The walls of `sheets` are 2 mm thick, those of `slabs`
/// 40 mm, and nothing else differs: both have equally many triangles, about as many in each face. The path does not turn the part;
/// in a window it leaves the clearance and a hundredth more on all sides. problem.fineness is half a wall's thickness. The seed varies
/// nothing. An environment has 1200 triangles or more.
constexpr SceneOptions kSheets{1, 20000, 60000, 25};  // clearance 1 to 28 mm
GeneratedScene makeSheets(const SceneOptions& options);
GeneratedScene makeSlabs(const SceneOptions& options);

/// A centre console is threaded out of the bent tunnel it just fits. Part and tunnel are swept along one
/// screw (see Screw), so that the part can be turned out of the tunnel at a constant gap: at least the
/// clearance, and less than half as much more as long as the part is in one of the ribs. The path is that
/// motion, in chords, then one more motion through the free room to the goal. The part's bounding box has a
/// diagonal of about 900 mm. problem.fineness is half the thinnest sheet.
///
/// As in a car, floor, walls and roof keep farther off than the gap, at least twice the clearance (four times
/// at 10 mm, and at least 14 mm), and only some places are at the gap: mounts on the floor, guides on the
/// walls and some ribs, each on one side. The other mounts, guides and ribs keep farther off, by different
/// lengths. There are sheets with beads, flanges and holes, flanged ribs, bolts, brackets, pipes, hoses,
/// cables, propeller shaft and exhaust; a console with bin, lid, gear lever, vents, ribs and cables. The
/// numbers of triangles are by default those of a car maker's meshes.
constexpr SceneOptions kTunnelConsole3{1, 73425, 300401, 10};  // clearance 1 to 25 mm
GeneratedScene makeTunnelConsole3(const SceneOptions& options);

/// Three quarters of the poses collide, and the poses stay where the part is in the tunnel.
constexpr Replay kInTunnel{0.75, 0.75, true};
/// The deviation does not turn the part, so faces stay parallel.
constexpr Replay kParallel{0.1, 1, false};

/// The table of all scenes. A new scene is one generator and one row. Among the versions of one scene the
/// newest comes last.
inline constexpr NamedScene kScenes[] = {
    {"tunnel-console-3", "a centre console to be threaded out of a bent tunnel, with the fittings of a car",
     kTunnelConsole3, makeTunnelConsole3, kInTunnel},
    {"cembox-2", "a control module to be drawn out of its rails in an engine bay", kCembox, makeCembox2},
    {"boxes-1", "a box that slides along two others, face to face", kBoxes, makeBoxes, kParallel},
    {"large-environment-2", "the tray of a sliding roof between two sheets that follow it, in a car body",
     kLargeEnvironment2, makeLargeEnvironment2},
    {"puzzle-1", "two interlocked bent bars, one to be slid through the eye of the other", kPuzzle,
     makePuzzle},
    {"puzzle-2", "two interlocked bent bars as in puzzle-1, but with open loops", kPuzzle, makePuzzle2},
    {"peg-in-hole-1", "a round peg to be put into a hole, as narrow as the clearance says", kPegInHole,
     makePegInHole},
    {"sheets-1", "a box that passes the windows of three walls of thin sheet", kSheets, makeSheets},
    {"slabs-1", "the walls of sheets-1 as thick slabs", kSheets, makeSlabs},
    {"apartment-1",
     "a piano to be carried through two doors and a corridor",
     kApartment,
     makeApartment,
     {},
     "top"},
};

/// Finds a scene by its name; a name without version means the newest. Throws std::invalid_argument that
/// lists the names.
const NamedScene& sceneNamed(const std::string& name);

// Definitions that all generators share.

/// Throws std::invalid_argument, naming the value and the range, when the clearance is out of it.
void requireClearance(double clearance, double least, double most);

/// Moves the part so that the mean of its vertices, rounded to whole units, becomes its origin, about which
/// planners turn it, and changes the path's states so that the part's surface stays where it is.
void centrePart(GeneratedScene& scene);

/// Lets the problem start at the path's first state and end at its last. The problem's volume holds all
/// states with `room` around them.
void setProblem(GeneratedScene& scene, double room);

/// Calls centrePart and setProblem.
void statePathAsProblem(GeneratedScene& scene, double room);

/// The names of a scene's files.
struct SceneFiles {
    std::string part;
    std::string environment;
    std::string problem;
    std::string path;
    std::string replay;   ///< poses for benchmarks
    std::string preview;  ///< a picture
};

/// Writes NAME_part.obj, NAME_environment.obj, NAME.cfg and NAME.path into the folder, which is made if
/// needed. OMPL.app moves a part so that the mean of its vertices, as assimp counts them, becomes its origin.
/// So the part is written moved by that mean, and start, goal and path are changed with it. They then hold
/// both for the part as the file has it and for the part as OMPL.app reads it; the two parts differ by float
/// rounding alone. The files `replay` and `preview` are not written here, but are known to be writable.
/// Existing files of these names are removed first, even if another scene made them. Throws
/// std::runtime_error when a file or the folder cannot be written.
SceneFiles writeScene(const GeneratedScene& scene, const std::string& folder);

/// Puts lines, each as "# line", at the top of a .cfg, .path or .poses file. Throws std::runtime_error when
/// the file cannot be read or written.
void addComment(const std::string& file, const std::vector<std::string>& lines);

}  // namespace clearway::scenes
