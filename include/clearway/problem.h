// Planning problems as in OMPL.app's .cfg files, and the .path files of their solutions.
#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/obstacle_groups.h"
#include "clearway/obstacle_rules.h"
#include "clearway/scene.h"
#include "clearway/shrink.h"
#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

/// The space of the part's poses.
enum class Space {
    kSe3,  ///< any position and rotation
    kSe2   ///< positions in the plane z = 0 and rotations about z
};

/// Position and rotation of the part in the environment's frame. In SE(2) z is 0 and the rotation is about z.
struct PartState {
    Vector3 position = Vector3::Zero();  ///< of the origin of the part's coordinates; environment units
    /// Unit length; the constructor's order is (w, x, y, z).
    Eigen::Quaternion<double, Eigen::DontAlign> rotation{1, 0, 0, 0};
};

/// The pose X_environmentPart of a state. The quaternion is normalised first, so that the rotation's defect
/// is only rounding. Throws ArgumentError when the quaternion has length 0 or is not finite.
Pose poseOf(const PartState& state);

/// One of the six sides of a box along the axes.
struct BoxSide {
    int axis = 0;         ///< 0, 1, 2 for x, y, z
    bool isUpper = true;  ///< the side of the larger coordinates
};

/// The name of a side: "+x", "-x", ... "-z".
std::string nameOf(const BoxSide& side);

/// The side of that name; empty for every other text.
std::optional<BoxSide> sideNamed(const std::string& name);

/// The part is outside where its box and that of its surroundings are apart or, with a side, where its box is
/// beyond that side of the other one. Both boxes are along the environment's axes.
struct Outside {
    std::optional<BoxSide> side;  ///< the side to leave by; without it any side will do
};

/// Keys and values as texts, in the order of the file.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// A planner by OMPL's class name in upper or lower case ("RRTConnect", "rrtconnect"), with parameters for
/// OMPL's ParamSet. The parameter "name" is not one of OMPL's: OMPL.app uses it as the planner's label.
struct PlannerChoice {
    std::string name;         ///< OMPL's class name, or one of clearway's planners
    NamedTexts parameters{};  ///< checked when the planner is made, see planning::makePlanner
    /// Settings of the problem for this planner only (`problem.KEY` in [planner]): those of
    /// PlanningSettings::settings, and "sampler" and "objective.threshold".
    NamedTexts settings{};
};

/// Which paths of a benchmark are written to files.
enum class SavedPaths {
    kNone,     ///< none
    kAll,      ///< those of all runs
    kShortest  ///< the shortest one
};

/// The mesh files of a problem, and how they are read.
struct ProblemMeshes {
    /// Mesh file of the part, with its path: in the .cfg's folder or, if it is not there, in the current
    /// folder.
    std::string robot;
    std::string world;                       ///< mesh file of the environment, found like robot
    std::vector<std::string> furtherWorlds;  ///< further mesh files of the environment; see readProblem
    /// `part`: the components that move as one, by names as of obstacle rules, of robot and of the environment's files, of which robot must
    /// be one. All other components stand still. Empty: all of robot moves, and nothing else.
    std::vector<std::string> partNames;
    double partScale = 1;   ///< `robot.scale`: LoadOptions::scale of the part's mesh
    double worldScale = 1;  ///< `world.scale`: LoadOptions::scale of the environment's meshes
    bool asOmplApp = true;  ///< read meshes as OMPL.app does; `reading = stored` turns this off
    /// False for a file without the key `reading`. Without a section [clearway] it is then read as OMPL.app reads
    /// it; otherwise as stored, and a mesh that OMPL.app would place differently is refused when it is loaded.
    bool isReadingStated = true;
};

/// How a problem is planned for: OMPL's objective, sampler and planners.
struct PlanningSettings {
    std::string objective = "length";  ///< the cost to improve, by its name; see planning::makeObjective
    std::optional<double>
        objectiveThreshold;  ///< a cost that is good enough to stop, in the objective's unit
    std::string sampler;     ///< how planners draw valid states, by its name; empty: OMPL's default
    std::optional<double> goalThreshold;  ///< OMPL's distance from the goal within which a path may end
    /// Parameters of OMPL's space ("longest_valid_segment_fraction", "projection.cellsize_factor") and of the
    /// sampler ("standard_deviation"). They never decide validity.
    NamedTexts settings;
    std::vector<PlannerChoice> planners;  ///< a benchmark runs each entry, also two of equal name
};

/// How a problem's planners are compared: the section [benchmark].
struct BenchmarkSettings {
    std::optional<double> timeLimit;    ///< seconds of each run
    std::optional<double> memoryLimit;  ///< megabytes of each run
    std::optional<int> runCount;        ///< of each planner
    std::string outputFolder;           ///< of the log, relative to the .cfg's folder; empty: that folder
    SavedPaths savedPaths = SavedPaths::kNone;  ///< for each planner
    bool simplify = true;                       ///< whether paths are simplified after each run
};

/// A planning problem: where the part begins and ends, the space of its poses and the rules for obstacles; and the
/// files and settings that a .cfg holds besides. Lengths in environment units, unless `unit` is about their display
/// alone.
struct Problem {
    std::string file;                ///< the .cfg; empty when made in memory
    std::string name;                ///< what reports and logs call the problem; may be empty
    Space space = Space::kSe3;       ///< what part states may be
    PartState start;                 ///< where the path begins
    PartState goal;                  ///< has no meaning when the goal is `outside`
    std::optional<Outside> outside;  ///< the goal is any pose outside of the environment's box, not `goal`
    std::optional<Box> volume;       ///< bounds of the part's position; without them see boundsOf()
    Box knownPath;        ///< positions of a known path, which derived bounds hold too; no key of the file
    double margin = 0;    ///< of obstacles that no rule names, environment units
    ObstacleRules rules;  ///< margins, solids, contacts and overlaps by the obstacles' names
    std::optional<double>
        fineness;      ///< of the scene, environment units: planners' edges are 20 times as long
    std::string unit;  ///< of all lengths, one of lengthUnits(), to be shown beside them; empty: not stated

    ProblemMeshes meshes;         ///< the mesh files; a problem with a Scene needs none
    PlanningSettings planning;    ///< OMPL's settings
    BenchmarkSettings benchmark;  ///< settings of benchmarks

    /// One line for each key that has no effect, to be shown once.
    std::vector<std::string> warnings;

    /// How far the triangles may be from the surfaces that they were made for, environment units; 0: not known. To be shown beside
    /// clearances, which it does not change: `margin = deflection` makes margin 2 * deflection.
    double deflection = 0;
};

/// Reads a .cfg. The space is SE(3) if start and goal have z and the axis keys, SE(2) if they have none of
/// them. A goal outside has no pose. OMPL.app's `world` is one file; here it may list several, separated by commas and in quotes where
/// necessary ("a, b.stl"). If the whole text is the name of an existing file, it is that one file. Planner
/// names and parameters are kept unchecked, in lower case.
///
/// Throws FileError when the file cannot be read. Throws ArgumentError when robot, world,
/// start or goal is missing (with [clearway] part, world may be missing: the part's file then has it all), a value is wrong, a key stands twice, a goal outside has a pose or contacts, or
/// [clearway] has an unknown key. The messages name the file, the key, the value and what was expected.
Problem readProblem(const std::string& file);

/// Writes a .cfg that readProblem reads back to equal values: numbers have 17 digits; rotations, as axis and
/// angle, agree to rounding. Mesh files are named relative to the .cfg's folder. Warnings and the keys they
/// are about are left out. The file is written under a temporary name, then renamed. Throws
/// FileError when it cannot be written, and ArgumentError when a text would be read as .cfg
/// syntax (for example with #) or a number is not finite.
void writeProblem(const Problem& problem, const std::string& file);

/// A unit of length that a problem may state.
struct LengthUnit {
    const char* name;  ///< as the key `unit` has it
    double metres;     ///< in one of the unit
};

/// All units that a problem may state: um, mm, cm, m, km, in, ft.
const std::vector<LengthUnit>& lengthUnits();

/// Metres in one of the problem's unit; empty without a unit.
std::optional<double> metresPerUnit(const Problem& problem);

/// The mesh files of the environment: meshes.world and meshes.furtherWorlds.
std::vector<std::string> worldFiles(const Problem& problem);

/// The larger one of problem.margin and the largest margin of a rule.
double largestMargin(const Problem& problem);

/// Reads a mesh file as loadMesh does, which is the default wherever a MeshReader is taken.
using MeshReader = std::function<Mesh(const std::string& file, const LoadOptions& options)>;

/// Loads the mesh of the part with the MeshReading and the scale that fit the problem. Throws what `read`
/// throws, and ArgumentError when the problem does not state its reading and the readings differ (see
/// ProblemMeshes::isReadingStated), or partNames names no component, or all of them.
Mesh loadPart(const Problem& problem, const MeshReader& read = loadMesh);

/// Loads the meshes of the environment, one for each of worldFiles(). Components of partNames have no triangles in
/// them. Reads and throws as loadPart does.
std::vector<Mesh> loadWorlds(const Problem& problem, const MeshReader& read = loadMesh);

/// Loads the meshes of the environment and joins them (joinedEnvironment). Throws as loadWorlds does.
Mesh loadEnvironment(const Problem& problem);

/// The meshes of a problem's files.
struct SceneMeshes {
    Mesh part;                 ///< see loadPart
    std::vector<Mesh> worlds;  ///< see loadWorlds
};

/// Loads all meshes of a problem. Throws as loadPart and loadWorlds do.
SceneMeshes loadMeshes(const Problem& problem, const MeshReader& read = loadMesh);

/// The mesh files of an assembly: the path itself, or those of the formats that clearway checks that lie in the folder of this path, by name.
/// Folders in it are not read. Throws FileError when the folder holds none, or a file of a CAD format without a mesh of its
/// name beside it: that part would be missing.
std::vector<std::string> assemblyFiles(const std::string& path);

/// Reads an assembly's files as one mesh, as stored; see assemblyFiles() and joinedEnvironment(). Throws as these and `read` do.
Mesh loadAssembly(const std::string& path, const MeshReader& read = loadMesh);

/// A note on how far reading as OMPL.app does has moved the part, if the problem has no key `reading`; otherwise
/// empty. part: from loadPart.
std::string readingNote(const Problem& problem, const Mesh& part);

/// A warning when the sizes of part and surroundings suggest that their files have different units; otherwise empty.
/// unit: of the boxes; empty: unknown.
std::string unitNote(const Box& part, const Box& environment, const std::string& unit);

/// Groups the environment's files by the problem's margin and rules. Throws as groupObstacles does, naming
/// the problem's file, and when the goal is outside but has contacts, which lie around a pose.
ObstacleGroups obstaclesOf(const Problem& problem, const std::vector<Mesh>& worlds);

/// The steps of loadScene that a caller may replace.
struct SceneLoading {
    MeshReader read = loadMesh;  ///< reads each mesh file
    /// Builds the part's model (without a range) and each obstacle's. A cache calls buildCached here.
    std::function<Model(const Mesh& mesh, const BuildOptions& options,
                        const std::optional<QueryRange>& range)>
        build = Model::build;
    /// Returns how much of the environment the obstacles' models need to hold; null: all of it. environmentBox holds
    /// the whole environment, ignored obstacles included.
    std::function<std::optional<QueryRange>(const Model& part, const Box& environmentBox)> range = nullptr;
    /// Shrinks the part, or obstacles in its place, by each overlap of the rules. A caller may keep results, or show progress.
    std::function<ShrunkPart(const Mesh& part, const ShrinkOptions& options)> shrink = clearway::shrink;
};

/// A problem's scene, and notes for its user, one line each: the meshes' warnings (MeshOrigin::warnings), components
/// turned over because all their triangles faced inwards, readingNote, unitNote, components of the part that enclose
/// nothing, and thin places of what is shrunk.
struct LoadedScene {
    Scene scene;                     ///< in the environment's frame and unit
    std::vector<std::string> notes;  ///< empty in most cases
};

/// Returns the part shrunk by each overlap of the obstacles, with loading.shrink. If a component of the part is open, it shrinks the
/// closed obstacles in its place, and returns nothing; open obstacles then get no overlap. Adds a note for each mesh with thin places. Throws as shrink() does, naming the problem's file.
std::vector<ShrunkPart> shrinkForOverlaps(const Problem& problem, const Mesh& part, ObstacleGroups& obstacles,
                                          std::vector<std::string>& notes, const SceneLoading& loading = {});

/// Loads the meshes and builds their models: the part, and the obstacles with their margins, solids and
/// contact zones as the problem has them. Throws as loadPart, obstaclesOf and Model::build do, and what the
/// steps of `loading` throw.
LoadedScene loadScene(const Problem& problem, const BuildOptions& options = {},
                      const SceneLoading& loading = {});

/// Builds the scene of meshes from loadMeshes, of this problem or of one that differs in its rules. loading.read is not called. Throws
/// as loadScene does, but for reading.
LoadedScene buildScene(const Problem& problem, const SceneMeshes& meshes, const BuildOptions& options = {},
                       const SceneLoading& loading = {});

/// Bounds of the part's position, in the environment's frame: problem.volume, or else OMPL.app's rule: the
/// environment's box grown to hold start and goal, and problem.knownPath. For a goal outside, the box is extended on
/// each of the goal's sides until the part fits there in any rotation. In SE(2) z is 0 to 0. partBox: the part's box
/// in its own coordinates, needed for a goal outside. Throws ArgumentError when the bounds leave out the
/// start or the goal, leave the part no place outside in any rotation, or have no extent along an axis, and when the
/// start, the goal or the volume is more than a million sizes of the scene from the environment.
Box boundsOf(const Problem& problem, const Box& environmentBox, const Box& partBox);

/// Writes one state a line with 17 digits: x y z qx qy qz qw, or x y yaw in SE(2). The file is written under
/// a temporary name, then renamed. Throws FileError when it cannot be written.
void writePath(const std::vector<PartState>& path, Space space, const std::string& file);

/// Writes the lines of a path file to a stream.
void writePath(const std::vector<PartState>& path, Space space, std::ostream& stream);

/// Reads a file with one state a line, as writePath writes it. Quaternions are normalised, because files with
/// 6 digits are off by 3e-7. Blank lines and lines that begin with # are skipped. Throws FileError
/// when the file cannot be read, and ArgumentError when a line is wrong (naming file and line) or the
/// file holds no state.
std::vector<PartState> readPath(const std::string& file, Space space);

/// The poses X_environmentPart of a file.
struct PoseFile {
    std::vector<Pose> poses;    ///< in the order of the lines
    std::size_t projected = 0;  ///< number of rotations that were projected to the nearest rotation
};

/// Reads one pose a line: 12 numbers (rotation row-major, then translation) or 7 (x y z qx qy qz qw). Blank
/// lines and lines that begin with # are skipped. A 12-number rotation with a defect up to 1e-5 is projected
/// to the nearest rotation; the quaternion of a 7-number line is normalised. Throws as readPath does.
PoseFile readPoses(const std::string& file);

/// Writes lines of 12 numbers with 17 digits, which readPoses reads back to equal poses. The file is written
/// under a temporary name, then renamed.
void writePoses(const std::vector<Pose>& poses, const std::string& file);

}  // namespace clearway

#pragma GCC visibility pop
