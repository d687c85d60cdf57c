// A planning problem as OMPL.app's .cfg files state it, and the .path files of its solutions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/obstacle_rules.h"
#include "clearway/scene.h"
#include "clearway/types.h"

namespace clearway {

enum class Space { kSe3, kSe2 };

/// Where the part is, in the environment's frame. In SE(2) z is 0 and the rotation is about z.
struct PartState {
    Vector3 position = Vector3::Zero();
    Eigen::Quaternion<double, Eigen::DontAlign> rotation{
        1, 0, 0, 0};  ///< (w, x, y, z) in the constructor; unit length
};

/// The pose X_environmentPart of a state. The quaternion is normalised first, so that the rotation's defect
/// is rounding. Throws std::invalid_argument when the quaternion has length 0 or is not finite.
Pose poseOf(const PartState& state);

using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// A planner by OMPL's class name in any case ("RRTConnect", "rrtconnect"), and its parameters as OMPL's
/// ParamSet takes them; the parameter "name" is no parameter of OMPL's but how OMPL.app labels the planner.
struct PlannerChoice {
    std::string name;
    NamedTexts parameters{};
    /// Of the problem, for this planner alone (`problem.KEY` in [planner]): as Problem::settings, and
    /// "sampler" and "objective.threshold".
    NamedTexts settings{};
};

enum class SavedPaths { kNone, kAll, kShortest };

struct Problem {
    std::string file;  ///< the .cfg; empty when made in memory
    std::string name;
    std::string
        robot;  ///< mesh file of the part, found in the .cfg's folder or, failing that, the current one
    std::string world;                       ///< mesh file of the environment, likewise
    std::vector<std::string> furtherWorlds;  ///< more of them; see readProblem
    Space space = Space::kSe3;
    PartState start;
    PartState goal;
    std::optional<Box> volume;  ///< bounds of the part's position; without it see boundsOf()
    std::string objective = "length";
    std::optional<double> objectiveThreshold;
    std::string sampler;
    std::optional<double> goalThreshold;  ///< OMPL's distance to the goal that a path may end at
    /// Parameters of OMPL's space ("longest_valid_segment_fraction", "projection.cellsize_factor") and of the
    /// sampler
    /// ("standard_deviation"). They never decide what is valid.
    NamedTexts settings;
    std::vector<PlannerChoice> planners;  ///< in a benchmark each is one, also two of one name

    // [benchmark]
    std::optional<double> timeLimit;    ///< seconds of each run
    std::optional<double> memoryLimit;  ///< megabytes, likewise
    std::optional<int> runCount;        ///< of each planner
    std::string outputFolder;           ///< of the log, from the .cfg's folder; empty: that one itself
    SavedPaths savedPaths = SavedPaths::kNone;  ///< of each planner
    bool simplify = true;                       ///< paths, after each run

    // [clearway]
    double margin = 0;  ///< environment units; of obstacles that no rule names
    ObstacleRules rules;
    std::optional<double>
        step;  ///< how fine the scene is: a planner's edges are 20 times as long, environment units
    bool asOmplApp = true;  ///< meshes read as OMPL.app reads them; `reading = stored` turns it off

    /// Keys that mean nothing here, one line each, to be shown once.
    std::vector<std::string> warnings;
};

/// Reads a .cfg. SE(3) when z and the axis keys are there for start and goal, SE(2) when none is.
/// OMPL.app's `world` is one file. It may name several here, with commas between them, in quotes if need be
/// ("a, b.stl"); a text that as a whole names a file that is there is that file. Throws std::runtime_error
/// when it cannot be read, std::invalid_argument when robot, world, start or goal is missing, a value is
/// wrong, a key stands twice or [clearway] holds an unknown one; both name the file, the key, the value and
/// what was expected. Planner names and parameters are passed on unjudged, in lower case.
Problem readProblem(const std::string& file);

/// Writes what readProblem reads back to the same values (numbers with 17 digits, rotations as axis and
/// angle: to rounding); mesh files by their names relative to the .cfg's folder. Warnings and what they were
/// about are left out. To a temporary name, then renamed. Throws std::runtime_error when it cannot,
/// std::invalid_argument when a text cannot be told from .cfg syntax (# in it, say) or a number is not
/// finite.
void writeProblem(const Problem& problem, const std::string& file);

/// world and furtherWorlds.
std::vector<std::string> worldFiles(const Problem& problem);

/// problem.margin, or the largest one of a rule where that is more.
double largestMargin(const Problem& problem);

/// The part's and the environment's meshes, read the way the problem says (loadMesh with the fitting
/// MeshReading). loadEnvironment joins those of several files (joinedEnvironment).
Mesh loadPart(const Problem& problem);
std::vector<Mesh> loadWorlds(const Problem& problem);
Mesh loadEnvironment(const Problem& problem);

/// A problem's scene, and one line each about what its user should know of it: components turned over because
/// all their triangles faced inwards, and those of the part that enclose nothing.
struct LoadedScene {
    Scene scene;
    std::vector<std::string> notes;
};

/// Loads the meshes and builds their models: the part, and the obstacles with their margins, solids and
/// contact zones as the problem has them. Throws as loadPart, groupObstacles (naming the problem's file) and
/// Model::build do.
LoadedScene loadScene(const Problem& problem, const BuildOptions& options = {});

/// problem.volume, else OMPL.app's rule: the environment's box grown to hold start and goal. Throws
/// std::invalid_argument when the bounds leave the start or the goal out, or have no extent along an axis. In
/// SE(2) z is 0 to 0.
Box boundsOf(const Problem& problem, const Box& environmentBox);

/// One state a line: x y z qx qy qz qw, or x y yaw in SE(2); 17 digits. Written to a temporary name, then
/// renamed.
void writePath(const std::vector<PartState>& path, Space space, const std::string& file);

/// Reads such a file (quaternions are normalised: 6-digit files are off by 3e-7). Blank lines and lines that
/// begin with # are left out. Throws std::runtime_error when it cannot be read, std::invalid_argument naming
/// the file and the line when one is wrong, and naming the file when it holds no state.
std::vector<PartState> readPath(const std::string& file, Space space);

/// Poses X_environmentPart, one a line: 12 numbers (rotation row-major, then translation) or 7 (x y z qx qy
/// qz qw). Blank lines and lines that begin with # are left out. A 12-number rotation off by up to 1e-5 is
/// projected to the nearest one, and counted; the quaternion of a 7-number line is normalised.
struct PoseFile {
    std::vector<Pose> poses;
    std::size_t projected = 0;
};
/// Throws as readPath does.
PoseFile readPoses(const std::string& file);

/// Lines of 12 numbers with 17 digits: readPoses gives back the same poses. Written to a temporary name, then
/// renamed.
void writePoses(const std::vector<Pose>& poses, const std::string& file);

}  // namespace clearway
