// Problem, path and pose files, and others' formats, are refused with a message that names the file, or give sound
// values. What clearway also writes survives writing and reading.
#include <cmath>
#include <stdexcept>

#include "clearway/problem.h"
#include "fuzz/bytes.h"
#include "support/byu_mesh.h"
#include "support/temporary_folder.h"

namespace clearway::testing {
namespace {

constexpr double kRotationRounding =
    1e-14;  ///< error of a pose written as axis and angle, at angles up to 2 pi

const TemporaryFolder& folder() {
    static const TemporaryFolder made;
    return made;
}

void requireSound(const PartState& state) {
    require(state.position.allFinite(), "a position is finite");
    require(rotationDefect(poseOf(state)) <= 1e-15, "a rotation is one");
}

void requireSame(const PartState& a, const PartState& b, const char* promise) {
    const double turned = (poseOf(a).rotation - poseOf(b).rotation).cwiseAbs().maxCoeff();
    require(a.position == b.position && turned <= kRotationRounding, promise);
}

void requireSame(const std::optional<ContactRule>& a, const std::optional<ContactRule>& b) {
    require(a.has_value() == b.has_value(), "contacts survive");
    if (a) require(a->names == b->names && a->distance == b->distance, "contacts survive");
}

void requireSameRules(const ObstacleRules& a, const ObstacleRules& b) {
    require(a.margins == b.margins, "margins by name survive");
    require(a.ignored == b.ignored, "ignored obstacles survive");
    require(a.isAllSolid == b.isAllSolid && a.solid == b.solid, "solids survive");
    require(a.overlap.common == b.overlap.common && a.overlap.byName == b.overlap.byName, "overlaps survive");
    requireSame(a.startContact, b.startContact);
    requireSame(a.goalContact, b.goalContact);
}

void requireSameAgain(const Problem& problem) {
    const std::string file = folder().file("again.cfg");
    try {
        writeProblem(problem, file);
    } catch (const std::invalid_argument&) {  // the text cannot be written in .cfg syntax
        return;
    }
    const Problem back = readProblem(file);
    require(back.space == problem.space, "the space survives");
    requireSame(back.start, problem.start, "the start survives");
    requireSame(back.goal, problem.goal, "the goal survives");
    require(back.name == problem.name && back.planning.objective == problem.planning.objective &&
                back.planning.sampler == problem.planning.sampler,
            "texts survive");
    require(back.margin == problem.margin && back.fineness == problem.fineness &&
                back.planning.objectiveThreshold == problem.planning.objectiveThreshold &&
                back.benchmark.timeLimit == problem.benchmark.timeLimit &&
                back.benchmark.memoryLimit == problem.benchmark.memoryLimit &&
                back.benchmark.runCount == problem.benchmark.runCount,
            "numbers survive");
    require(back.meshes.asOmplApp == problem.meshes.asOmplApp, "the reading survives");
    require(back.unit == problem.unit && back.meshes.partScale == problem.meshes.partScale &&
                back.meshes.worldScale == problem.meshes.worldScale,
            "unit and scales survive");
    require(back.outside.has_value() == problem.outside.has_value(), "a goal outside survives");
    if (back.outside) {
        require(back.outside->side.has_value() == problem.outside->side.has_value(), "its side survives");
    }
    requireSameRules(back.rules, problem.rules);
    require(worldFiles(back).size() == worldFiles(problem).size(), "worlds survive");
    require(back.volume.has_value() == problem.volume.has_value(), "bounds survive");
    if (back.volume) {
        require(back.volume->min() == problem.volume->min() && back.volume->max() == problem.volume->max(),
                "bounds survive");
    }
    require(back.planning.planners.size() == problem.planning.planners.size(), "planners survive");
    for (std::size_t i = 0; i < back.planning.planners.size(); ++i) {
        require(back.planning.planners[i].name == problem.planning.planners[i].name &&
                    back.planning.planners[i].parameters == problem.planning.planners[i].parameters,
                "planners survive");
    }
    require(back.warnings.empty(), "what is written is understood");
}

void readProblemAndBack(const std::string& file) {
    const Problem problem = readProblem(file);
    requireSound(problem.start);
    requireSound(problem.goal);
    require(problem.margin >= 0 && std::isfinite(problem.margin), "a margin is a length");
    require(!problem.fineness || *problem.fineness > 0, "a fineness is above 0");
    require(!problem.volume || !problem.volume->isEmpty(), "bounds hold something");
    requireSameAgain(problem);
}

void readPathAndBack(const std::string& file, Space space) {
    const std::vector<PartState> path = readPath(file, space);
    for (const PartState& state : path) requireSound(state);
    writePath(path, space, folder().file("again.path"));
    const std::vector<PartState> back = readPath(folder().file("again.path"), space);
    require(back.size() == path.size(), "a path's states survive");
    for (std::size_t i = 0; i < path.size(); ++i) requireSame(path[i], back[i], "a path's states survive");
}

void readByu(const std::string& file) {
    const Mesh mesh = readByuMesh(file);
    require(!mesh.triangles.empty(), "a mesh has triangles");
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle)
            require(vertex < mesh.vertices.size(), "a corner is a vertex");
    }
    for (const Vector3& vertex : mesh.vertices) require(vertex.allFinite(), "a vertex is finite");
    std::uint32_t next = 0;
    for (const Component& component : mesh.components) {
        require(component.firstTriangle == next, "components follow each other");
        next += component.triangleCount;
    }
    require(next == mesh.triangles.size(), "components hold all triangles");
}

void read(std::size_t kind, const std::string& file) {
    if (kind == 0) readProblemAndBack(file);
    if (kind == 1) readPathAndBack(file, Space::kSe3);
    if (kind == 2) readPathAndBack(file, Space::kSe2);
    if (kind == 3) {
        for (const Pose& pose : readPoses(file).poses) requirePose(pose);
    }
    if (kind == 4) readByu(file);
}

void requireNamed(const std::exception& error, const std::string& file) {
    const std::string message = error.what();
    require(message.find(file) != std::string::npos, "a refusal names the file: " + message);
    require(message.find('\n') == std::string::npos, "a refusal is one line: " + message);
}

}  // namespace

void fuzzOne(std::string_view input) {
    Bytes bytes(input);
    const std::size_t kind = bytes.below(5);
    const std::string file = folder().write("given", std::string(bytes.rest()));
    try {
        read(kind, file);
    } catch (const std::invalid_argument& error) {
        requireNamed(error, file);
    } catch (const std::runtime_error& error) {
        requireNamed(error, file);
    }
}

std::vector<std::string> seeds() {
    const std::string meshes =
        "[problem]\nname = a\nrobot = p.stl\nworld = w.stl, \"v, u.stl\"\nstart.x = 1\nstart.y = 2\n";
    const std::string spatial =
        "start.z = 3\nstart.axis.x = 0\nstart.axis.y = 0.6\nstart.axis.z = 1\nstart.theta = 1.5\ngoal.x = 1\n"
        "goal.y = 2\ngoal.z = 3\ngoal.axis.x = 0\ngoal.axis.y = 0\ngoal.axis.z = 1\ngoal.theta = -1e-3\n"
        "volume.min.x = -9\nvolume.min.y = -9\nvolume.min.z = -9\nvolume.max.x = 9\nvolume.max.y = 9\n"
        "volume.max.z = 9\nobjective = length\nobjective.threshold = 5.5\nsampler = uniform\n";
    const std::string rest =
        "[benchmark]\ntime_limit = 2.5\nmem_limit = 1000\nrun_count = 5\n[planner]\nrrt=\nrrt.range = "
        "5\nprm=\n"
        "[clearway]\nmargin = 0.1\nstep = 2\nreading = stored\nmargin.a b = 2\nmargin.\"c#2\" = 0 # d\n"
        "ignore = e, \"f, g\"\nsolid = all\ncontact.start = h, 3\ncontact.goal = i, j, 0.5\n"
        "overlap = 0.5\noverlap.k = 0\noverlap.\"thin\" = 2\n";
    return {'\0' + meshes + spatial + rest,
            '\0' + meshes + "start.theta = 0.5\ngoal.x = 4\ngoal.y = 5\ngoal.theta = 6\n" + rest,
            '\0' + meshes + "start.theta = 0.5\n[clearway]\ngoal = outside\noutside = -y\n",
            '\0' + meshes +
                "goal.x = 4\ngoal.y = 5\n[clearway]\nstart.degrees = 30\ngoal.degrees = -400\nunit = mm\n"
                "robot.scale = 25.4\nworld.scale = 1e-3\nfineness = 0.5\nreading = omplapp\n",
            "\1"
            "1 2.5 -3e2 0.1 0.2 0.3 0.9\n# x\n1 2 3 0 0 0 1\n",
            "\2"
            "1 2.5 0.3\n\n-1e2 7 3.14\n",
            "\3"
            "1 0 0 0 1 0 0 0 1 7 8 9\n1 2 3 0 0 0 1\n0 -1 0 1 0 0 0 0 1 1e3 0 0\n",
            "\4"
            "2 4 2 7\n1 1\n2 2\n0 0 0 1 0 0\n0 1 0 0 0 1.5e0\n1 2 -3\n1 2 3 -4\n"};
}

}  // namespace clearway::testing
