// The values that follow from a problem: poses, bounds, margins and meshes.
#include "clearway/problem.h"

#include <algorithm>
#include <stdexcept>

#include "clearway/obstacle_groups.h"
#include "core/number.h"
#include "problem/config.h"
#include "problem/rotation.h"

namespace clearway {
namespace {

std::string named(const Problem& problem) {
    return problem.file.empty() ? "" : problem.file + ": ";
}

void requireInside(const Problem& problem, const Box& bounds, const char* name, const PartState& state) {
    const int dimensions = problem.space == Space::kSe3 ? 3 : 2;
    for (int i = 0; i < dimensions; ++i) {
        const double value = state.position[i];
        if (value >= bounds.min()[i] && value <= bounds.max()[i]) continue;
        throw std::invalid_argument(named(problem) + name + "." + kAxisNames[i] + " is " +
                                    shortNumber(value) + ", outside the bounds, expected from " +
                                    shortNumber(bounds.min()[i]) + " to " + shortNumber(bounds.max()[i]));
    }
}

void requireExtent(const Problem& problem, const Box& bounds) {
    const int dimensions = problem.space == Space::kSe3 ? 3 : 2;
    for (int i = 0; i < dimensions; ++i) {
        if (bounds.min()[i] < bounds.max()[i]) continue;
        const std::string axis = kAxisNames[i];
        throw std::invalid_argument(named(problem) + "the bounds along " + axis + " are " +
                                    shortNumber(bounds.min()[i]) + " to " + shortNumber(bounds.max()[i]) +
                                    ", expected an extent above 0: state volume.min." + axis +
                                    " and volume.max." + axis);
    }
}

Mesh loadAs(const Problem& problem, const std::string& file, MeshReading omplAppReading,
            const MeshReader& read) {
    LoadOptions options;
    options.reading = problem.asOmplApp ? omplAppReading : MeshReading::kAsStored;
    return read(file, options);
}

}  // namespace

Pose poseOf(const PartState& state) {
    const std::optional<Matrix3> rotation = matrixOf(state.rotation);
    if (!rotation) {
        throw std::invalid_argument(
            "the state's quaternion has length 0 or is not finite, expected one of length 1");
    }
    return {*rotation, state.position};
}

std::vector<std::string> worldFiles(const Problem& problem) {
    std::vector<std::string> files = {problem.world};
    files.insert(files.end(), problem.furtherWorlds.begin(), problem.furtherWorlds.end());
    return files;
}

double largestMargin(const Problem& problem) {
    double largest = problem.margin;
    for (const auto& [name, margin] : problem.rules.margins) largest = std::max(largest, margin);
    return largest;
}

Box boundsOf(const Problem& problem, const Box& environmentBox) {
    Box bounds;
    if (problem.volume) {
        bounds = *problem.volume;
    } else {
        bounds = environmentBox;
        bounds.extend(problem.start.position).extend(problem.goal.position);
    }
    if (problem.space == Space::kSe2) bounds.min().z() = bounds.max().z() = 0;
    requireExtent(problem, bounds);
    requireInside(problem, bounds, "start", problem.start);
    requireInside(problem, bounds, "goal", problem.goal);
    return bounds;
}

Mesh loadPart(const Problem& problem, const MeshReader& read) {
    const bool isSpatial = problem.space == Space::kSe3;
    return loadAs(problem, problem.robot,
                  isSpatial ? MeshReading::kOmplAppRobot : MeshReading::kOmplAppPlanarRobot, read);
}

std::vector<Mesh> loadWorlds(const Problem& problem, const MeshReader& read) {
    std::vector<Mesh> worlds;
    for (const std::string& file : worldFiles(problem)) {
        worlds.push_back(loadAs(problem, file, MeshReading::kOmplAppEnvironment, read));
    }
    return worlds;
}

Mesh loadEnvironment(const Problem& problem) {
    return joinedEnvironment(loadWorlds(problem));
}

}  // namespace clearway
