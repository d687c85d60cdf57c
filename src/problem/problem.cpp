// The values that follow from a problem: poses, bounds, margins and meshes.
#include "clearway/problem.h"

#include <algorithm>
#include <limits>
#include <set>

#include "clearway/errors.h"
#include "clearway/obstacle_groups.h"
#include "core/number.h"
#include "mesh/components.h"
#include "model/obstacle_names.h"
#include "problem/config.h"
#include "problem/outside.h"
#include "problem/rotation.h"

namespace clearway {
namespace {

/// Derived bounds let the part's position go this far beyond the environment, in radii of the part about its origin: one
/// radius lets any rotation be outside, the rest is room to draw poses from.
constexpr double kRoomInRadii = 1.25;

/// Poses and bounds lie at most this many sizes of the scene beyond the environment. The farther away, the more the rounding of
/// positions hides clearances: a motion that was tried at 1e13 sizes was not decided within minutes.
constexpr double kFarthestInSizes = 1e6;

constexpr double kSamePlace = 1e-6;  ///< of a mesh's size: readings that differ by less are alike

std::string named(const Problem& problem) {
    return problem.file.empty() ? "" : problem.file + ": ";
}

int dimensionsOf(const Problem& problem) {
    return problem.space == Space::kSe3 ? 3 : 2;
}

void requireInside(const Problem& problem, const Box& bounds, const char* name, const PartState& state) {
    const int dimensions = dimensionsOf(problem);
    for (int i = 0; i < dimensions; ++i) {
        const double value = state.position[i];
        if (value >= bounds.min()[i] && value <= bounds.max()[i]) continue;
        throw ArgumentError(named(problem) + name + "." + kAxisNames[i] + " is " + shortNumber(value) +
                            ", outside the bounds, expected from " + shortNumber(bounds.min()[i]) + " to " +
                            shortNumber(bounds.max()[i]));
    }
}

void requireExtent(const Problem& problem, const Box& bounds) {
    const int dimensions = dimensionsOf(problem);
    for (int i = 0; i < dimensions; ++i) {
        if (bounds.min()[i] < bounds.max()[i]) continue;
        const std::string axis = kAxisNames[i];
        throw ArgumentError(named(problem) + "the bounds along " + axis + " are " +
                            shortNumber(bounds.min()[i]) + " to " + shortNumber(bounds.max()[i]) +
                            ", expected an extent above 0: state volume.min." + axis + " and volume.max." +
                            axis);
    }
}

void requireNear(const Problem& problem, const Box& environmentBox, const Box& partBox) {
    const double partSize = partBox.isEmpty() ? 0 : partBox.diagonal().norm();
    const double farthest = kFarthestInSizes * (environmentBox.diagonal().norm() + partSize);
    if (environmentBox.isEmpty() || farthest == 0) return;
    const auto require = [&](const std::string& name, const Vector3& point) {
        for (int i = 0; i < dimensionsOf(problem); ++i) {
            const double least = environmentBox.min()[i] - farthest,
                         most = environmentBox.max()[i] + farthest;
            if (point[i] >= least && point[i] <= most) continue;
            throw ArgumentError(
                named(problem) + name + kAxisNames[i] + " is " + shortNumber(point[i]) +
                ", more than a million times the scene's size from the environment, expected from " +
                roundedNumber(least) + " to " + roundedNumber(most));
        }
    };
    require("start.", problem.start.position);
    if (!problem.outside) require("goal.", problem.goal.position);
    if (problem.volume) {
        require("volume.min.", problem.volume->min());
        require("volume.max.", problem.volume->max());
    }
}

/// Makes room for the part beyond the goal's sides, whatever its rotation.
void growForPart(Box& bounds, const Problem& problem, const Box& environmentBox, const Box& partBox) {
    if (environmentBox.isEmpty()) return;
    const Vector3 farthest = partBox.min().cwiseAbs().cwiseMax(partBox.max().cwiseAbs());
    const double room = kRoomInRadii * farthest.norm() + largestMargin(problem);
    const double largest = kFarthestInSizes * (environmentBox.diagonal().norm() + partBox.diagonal().norm());
    if (largestMargin(problem) > largest) {
        throw ArgumentError(named(problem) + "a margin is " + shortNumber(largestMargin(problem)) +
                            ", more than a million times the scene's size, expected at most " +
                            roundedNumber(largest));
    }
    for (const BoxSide& side : sidesOf(*problem.outside)) {
        if (side.axis >= dimensionsOf(problem)) continue;
        Vector3 point = environmentBox.center();
        point[side.axis] =
            side.isUpper ? environmentBox.max()[side.axis] + room : environmentBox.min()[side.axis] - room;
        bounds.extend(point);
    }
}

void requirePlaceOutside(const Problem& problem, const Box& bounds, const Box& environmentBox,
                         const Box& partBox) {
    const double least = supportAlong(flattestDirection(partBox, dimensionsOf(problem)), partBox);
    std::string expected;
    for (const BoxSide& side : sidesOf(*problem.outside)) {
        if (overlapAt(side, partBox, environmentBox) == -std::numeric_limits<double>::infinity()) return;
        if (side.axis >= dimensionsOf(problem)) {
            if (overlapAt(side, partBox, environmentBox) < 0) return;
            continue;
        }
        const int axis = side.axis;
        const double limit =
            side.isUpper ? environmentBox.max()[axis] + least : environmentBox.min()[axis] - least;
        if (side.isUpper ? bounds.max()[axis] > limit : bounds.min()[axis] < limit) return;
        expected += std::string(expected.empty() ? "" : " or ") +
                    (side.isUpper ? "volume.max." : "volume.min.") + kAxisNames[axis] +
                    (side.isUpper ? " above " : " below ") + shortNumber(limit);
    }
    throw ArgumentError(named(problem) + "the bounds leave no room for the part outside, expected " +
                        (expected.empty() ? "a side along x or y" : expected));
}

void requirePartExtent(const Mesh& part) {
    const Box box = boundingBox(part);
    if (box.diagonal().norm() > 0) return;
    throw ArgumentError("the part " + part.origin.file + " has no extent: all of it is at " +
                        roundedPoint(box.min()) + ", expected a mesh with some length");
}

std::string boxText(const Box& box) {
    return roundedPoint(box.min()) + " to " + roundedPoint(box.max());
}

/// Refuses a file whose readings differ. omplAppMesh: the mesh as OMPL.app reads it.
void requireAlike(const Problem& problem, const std::string& file, const Box& stored,
                  const Mesh& omplAppMesh) {
    const Box asOmplApp = boundingBox(omplAppMesh);
    const Vector3& shift = omplAppMesh.origin.shift;
    const double size = stored.diagonal().norm();
    const double most = std::max((stored.min() - asOmplApp.min()).cwiseAbs().maxCoeff(),
                                 (stored.max() - asOmplApp.max()).cwiseAbs().maxCoeff());
    if (most <= kSamePlace * size) return;
    throw ArgumentError(named(problem) + "[clearway] does not say how to read " + file + ": its box is " +
                        boxText(stored) + " as the file stores it, and " + boxText(asOmplApp) +
                        " as OMPL.app reads it" +
                        (shift.isZero() ? "" : ", moved by " + withUnit(roundedPoint(shift), problem.unit)) +
                        "; expected reading = stored or reading = omplapp");
}

Mesh loadAs(const Problem& problem, const std::string& file, double scale, MeshReading omplAppReading,
            const MeshReader& read) {
    LoadOptions options;
    options.scale = scale;
    options.reading = problem.meshes.asOmplApp ? omplAppReading : MeshReading::kAsStored;
    Mesh mesh = read(file, options);
    if (problem.meshes.isReadingStated || problem.meshes.asOmplApp) return mesh;
    options.reading = omplAppReading;
    requireAlike(problem, file, boundingBox(mesh), read(file, options));
    return mesh;
}

/// The files of an assembly, divided. `still` has all of them, with the components that move, but without their triangles: so all components
/// keep the names that they have in the whole assembly, by which rules call them.
struct DividedFiles {
    std::vector<Mesh> moving, still;
};

/// The file without the triangles of the components that are not in `rest`.
Mesh withTrianglesOf(const Mesh& file, const std::vector<std::size_t>& rest) {
    Mesh mesh = meshOfComponents(file, rest);
    std::vector<Component> components = componentsOf(file);
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (std::find(rest.begin(), rest.end(), i) == rest.end()) components[i].triangleCount = 0;
        components[i].firstTriangle = first;
        first += components[i].triangleCount;
    }
    mesh.components = components;
    return mesh;
}

std::vector<Mesh> loadWorldFiles(const Problem& problem, const MeshReader& read) {
    std::vector<Mesh> worlds;
    for (const std::string& file : worldFiles(problem)) {
        worlds.push_back(
            loadAs(problem, file, problem.meshes.worldScale, MeshReading::kOmplAppEnvironment, read));
    }
    return worlds;
}

DividedFiles divideFiles(const Problem& problem, const MeshReader& read) {
    const std::vector<std::string> files = worldFiles(problem);
    if (std::find(files.begin(), files.end(), problem.meshes.robot) == files.end())
        throw ArgumentError(
            "part names components of '" + problem.meshes.robot +
            "', expected this file among the environment's, too: its other components stand still");
    const std::vector<Mesh> meshes = loadWorldFiles(problem, read);
    const ObstacleNames names(meshes);
    std::set<std::size_t> moving;
    for (const std::string& name : problem.meshes.partNames) {
        for (const std::size_t component : names.find("part", name)) moving.insert(component);
    }
    DividedFiles divided;
    std::size_t component = 0;
    for (const Mesh& mesh : meshes) {
        std::vector<std::size_t> chosen, rest;
        for (std::size_t i = 0; i < componentsOf(mesh).size(); ++i, ++component)
            (moving.count(component) > 0 ? chosen : rest).push_back(i);
        if (!chosen.empty()) divided.moving.push_back(meshOfComponents(mesh, chosen));
        divided.still.push_back(withTrianglesOf(mesh, rest));
    }
    if (moving.size() == names.components().size())
        throw ArgumentError("part names all components of '" + problem.meshes.robot +
                            "', expected one that stands still, or a further file in [problem] world");
    return divided;
}

}  // namespace

const std::vector<LengthUnit>& lengthUnits() {
    static const std::vector<LengthUnit> all = {{"um", 1e-6}, {"mm", 1e-3},   {"cm", 1e-2},  {"m", 1},
                                                {"km", 1e3},  {"in", 0.0254}, {"ft", 0.3048}};
    return all;
}

std::optional<double> metresPerUnit(const Problem& problem) {
    for (const LengthUnit& unit : lengthUnits()) {
        if (unit.name == problem.unit) return unit.metres;
    }
    return std::nullopt;
}

Pose poseOf(const PartState& state) {
    const std::optional<Matrix3> rotation = matrixOf(state.rotation);
    if (!rotation) {
        throw ArgumentError("the state's quaternion has length 0 or is not finite, expected one of length 1");
    }
    return {*rotation, state.position};
}

std::vector<std::string> worldFiles(const Problem& problem) {
    std::vector<std::string> files = {problem.meshes.world};
    files.insert(files.end(), problem.meshes.furtherWorlds.begin(), problem.meshes.furtherWorlds.end());
    return files;
}

double largestMargin(const Problem& problem) {
    double largest = problem.margin;
    for (const auto& [name, margin] : problem.rules.margins) largest = std::max(largest, margin);
    return largest;
}

Box boundsOf(const Problem& problem, const Box& environmentBox, const Box& partBox) {
    if (problem.outside && partBox.isEmpty()) {
        throw ArgumentError(named(problem) + "the goal is outside, expected the part's box too");
    }
    Box bounds;
    if (problem.volume) {
        bounds = *problem.volume;
    } else {
        bounds = environmentBox;
        bounds.extend(problem.knownPath);
        bounds.extend(problem.start.position);
        if (problem.outside) {
            growForPart(bounds, problem, environmentBox, partBox);
        } else {
            bounds.extend(problem.goal.position);
        }
    }
    if (problem.space == Space::kSe2) bounds.min().z() = bounds.max().z() = 0;
    requireExtent(problem, bounds);
    requireNear(problem, environmentBox, partBox);
    requireInside(problem, bounds, "start", problem.start);
    if (problem.outside) {
        requirePlaceOutside(problem, bounds, environmentBox, partBox);
    } else {
        requireInside(problem, bounds, "goal", problem.goal);
    }
    return bounds;
}

Mesh loadPart(const Problem& problem, const MeshReader& read) {
    Mesh part;
    if (problem.meshes.partNames.empty()) {
        const bool isSpatial = problem.space == Space::kSe3;
        part = loadAs(problem, problem.meshes.robot, problem.meshes.partScale,
                      isSpatial ? MeshReading::kOmplAppRobot : MeshReading::kOmplAppPlanarRobot, read);
    } else {
        part = joinedEnvironment(divideFiles(problem, read).moving);
    }
    requirePartExtent(part);
    return part;
}

std::vector<Mesh> loadWorlds(const Problem& problem, const MeshReader& read) {
    return problem.meshes.partNames.empty() ? loadWorldFiles(problem, read)
                                            : divideFiles(problem, read).still;
}

std::string readingNote(const Problem& problem, const Mesh& part) {
    const Vector3& shift = part.origin.shift;
    if (problem.meshes.isReadingStated || !problem.meshes.asOmplApp ||
        shift.norm() <= kSamePlace * boundingBox(part).diagonal().norm())
        return "";
    return "the part is moved by " + withUnit(roundedPoint(shift), problem.unit) +
           " on reading, as OMPL.app does, so that the mean of its vertices is its origin; [clearway] "
           "reading = "
           "stored keeps the file's coordinates";
}

Mesh loadEnvironment(const Problem& problem) {
    return joinedEnvironment(loadWorlds(problem));
}

SceneMeshes loadMeshes(const Problem& problem, const MeshReader& read) {
    Mesh part = loadPart(problem, read);
    return {std::move(part), loadWorlds(problem, read)};
}

}  // namespace clearway
