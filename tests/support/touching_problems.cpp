#include "support/assembled_problems.h"

#include <cmath>
#include <fstream>

#include "demos/scenes/section.h"
#include "demos/scenes/solids.h"
#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

using scenes::Polyline;

Mesh oneSolid(const std::string& name, const scenes::Piece& piece) {
    scenes::Assembly assembly;
    assembly.add(name, piece);
    return assembly.mesh();
}

Polyline rectangle(double x, double y) {
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// Boxes between two corners.
Mesh blocks(const std::vector<std::pair<Vector3, Vector3>>& corners) {
    std::vector<Mesh> all;
    for (const auto& [low, high] : corners)
        all.push_back(boxMesh({low, high}, "block" + std::to_string(all.size() + 1)));
    return assembled(all);
}

/// A ribbed plug that is pressed 0.3 deep into its socket.
AssembledProblem plug() {
    const Polyline plug{{0, -20},   {8, -20},  {10.3, -18}, {10.3, -14}, {9.5, -13}, {9.5, -9}, {10.3, -8},
                        {10.3, -4}, {9.5, -3}, {9.5, 0},    {14, 0},     {14, 8},    {0, 8}};
    const Polyline socket{{0, -26}, {16, -26}, {16, 0}, {10, 0}, {10, -20}, {0, -20}};
    return {"plug", oneSolid("plug", scenes::turned(plug, 20)),
            oneSolid("socket", scenes::turned(socket, 20))};
}

/// All faces between the lid and the jar coincide.
AssembledProblem lid() {
    const Polyline lid{{0, 8}, {10, 8}, {10, 0}, {12, 0}, {12, 10}, {0, 10}};
    const Polyline jar{{0, -20}, {12, -20}, {12, 0}, {10, 0}, {10, 8}, {0, 8}};
    return {"lid", oneSolid("lid", scenes::turned(lid, 36)), oneSolid("jar", scenes::turned(jar, 36))};
}

/// The ring sits on a shaft and in a housing. Its facets stand across theirs, and so reach into them.
AssembledProblem bearing() {
    constexpr int kFacets = 48;
    const Polyline ring{{10, 0}, {18, 0}, {18, 8}, {10, 8}};
    const Polyline housing{{0, -10}, {22, -10}, {22, 8}, {18, 8}, {18, 0},
                           {10, 0},  {10, 9},   {9, 10}, {9, 20}, {0, 20}};
    const scenes::Placement turnedByHalfAFacet = scenes::standingAt({0, 0, 0}, {0, 0, 1}, M_PI / kFacets);
    return {"bearing", oneSolid("ring", scenes::placed(scenes::ring(ring, kFacets), turnedByHalfAFacet)),
            oneSolid("housing", scenes::turned(housing, kFacets))};
}

/// The slider leaves its groove along y.
AssembledProblem dovetail() {
    const std::vector<double> ends{-10, 10};
    const auto along = [&](const Polyline& loop) {
        return scenes::sweepAlongY(scenes::fullSection(loop), ends);
    };
    scenes::Assembly rails;
    rails.add("left", along({{-10, 0}, {-6, 0}, {-4, 5}, {-10, 5}}));
    rails.add("right", along({{6, 0}, {10, 0}, {10, 5}, {4, 5}}));
    rails.add("floor", along({{-10, -4}, {10, -4}, {10, 0}, {-10, 0}}));
    return {"dovetail", oneSolid("slider", along({{-6, 0}, {6, 0}, {4, 5}, {-4, 5}})), rails.mesh()};
}

/// A headed pin slides along a slot to an opening as wide as its head.
AssembledProblem keyhole() {
    const Polyline pin{{0, -6}, {4, -6}, {4, -3}, {2, -3}, {2, 6}, {0, 6}};
    const Mesh plate = blocks({{{-10, 2, -3}, {8, 10, 0}},
                               {{-10, -10, -3}, {8, -2, 0}},
                               {{-10, -2, -3}, {-2, 2, 0}},
                               {{8, 4, -3}, {16, 10, 0}},
                               {{8, -10, -3}, {16, -4, 0}},
                               {{16, -10, -3}, {20, 10, 0}},
                               {{-10, -10, -8}, {20, 10, -6}}});
    return {"keyhole", oneSolid("pin", scenes::turned(pin, 24)), plate};
}

/// A crossbar behind a slot turns a quarter, and then fits.
AssembledProblem crossbar() {
    const scenes::Piece key = scenes::stacked(
        {{rectangle(6, 1.5), -6}, {rectangle(6, 1.5), -3}, {rectangle(1, 1), -3}, {rectangle(1, 1), 8}});
    const Mesh plate = blocks({{{-12, -12, -3}, {-1.6, 12, 0}},
                               {{1.6, -12, -3}, {12, 12, 0}},
                               {{-1.6, 6.2, -3}, {1.6, 12, 0}},
                               {{-1.6, -12, -3}, {1.6, -6.2, 0}},
                               {{-12, -12, -9}, {12, 12, -7}}});
    return {"crossbar", oneSolid("key", key), plate};
}

}  // namespace

std::vector<AssembledProblem> touchingProblems() {
    return {plug(), lid(), bearing(), dovetail(), keyhole(), crossbar()};
}

std::string writeAssembledProblem(const AssembledProblem& problem, const std::string& folder,
                                  const std::string& keys) {
    const std::string stem = folder + "/" + problem.name;
    saveMesh(problem.part, stem + "_part.obj");
    saveMesh(problem.environment, stem + "_environment.obj");
    std::ofstream(stem + ".cfg")
        << "[problem]\nrobot = " << problem.name << "_part.obj\nworld = " << problem.name
        << "_environment.obj\nstart.x = 0\nstart.y = 0\nstart.z = 0\nstart.axis.x = 0\n"
           "start.axis.y = 0\nstart.axis.z = 1\nstart.theta = 0\n[clearway]\n"
           "reading = stored\ngoal = outside\n"
        << keys;
    return stem + ".cfg";
}

}  // namespace clearway::testing
