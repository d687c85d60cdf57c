// Checks of a scene for the tests of the scenes: closed components, clearance along a path.
#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/query.h"
#include "demos/scenes/scenes.h"
#include "support/convex_hull.h"
#include "support/oracle.h"

namespace clearway::testing {

using namespace scenes;

/// OMPL's SE(3) interpolation: straight translation, shortest slerp.
inline PartState between(const PartState& from, const PartState& to, double t) {
    PartState state;
    state.position = (1 - t) * from.position + t * to.position;
    state.rotation = from.rotation.slerp(t, to.rotation);
    return state;
}

/// An upper bound on the motion of any point within `radius` of the part's origin between the two states.
/// Between two states on the way, the bound is proportional to the share of the way.
inline double longestMotion(const PartState& from, const PartState& to, double radius) {
    return (to.position - from.position).norm() + radius * from.rotation.angularDistance(to.rotation);
}

/// True if each edge of the component is used once in each direction.
inline bool isClosed(const Mesh& mesh, const Component& component) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (std::uint32_t i = component.firstTriangle; i < component.firstTriangle + component.triangleCount;
         ++i) {
        const TriangleIndices& t = mesh.triangles[i];
        for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, count] : uses) {
        if (count != 1 || uses.count({edge.second, edge.first}) == 0) return false;
    }
    return true;
}

/// Checks that every component is closed, turned outwards and has a unique name, and that together the
/// components are the mesh.
inline void testNamedClosedSolids(const Mesh& mesh) {
    std::set<std::string> names;
    std::uint32_t covered = 0;
    for (const Component& component : mesh.components) {
        BOOST_TEST_INFO(component.name);
        BOOST_TEST(isClosed(mesh, component));
        BOOST_TEST_INFO(component.name);
        BOOST_TEST(signedVolume(mesh, component) > 0);
        BOOST_TEST(component.firstTriangle == covered);
        covered += component.triangleCount;
        names.insert(component.name);
    }
    BOOST_TEST(covered == mesh.triangles.size());
    BOOST_TEST(names.size() == mesh.components.size());
    BOOST_TEST(names.count("") == 0);
}

/// Checks that the mesh is tessellated like CAD meshes: short edges and thin triangles, but none without
/// area. Millimetres.
inline void testSlivers(const Mesh& mesh) {
    double leastEdge = 1e9, thinnest = 1e9;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = cornersOf(mesh, i);
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        leastEdge = std::min({leastEdge, (b - a).norm(), (c - b).norm(), (a - c).norm()});
        thinnest = std::min(thinnest, (b - a).cross(c - a).norm() / longest / longest);
    }
    BOOST_TEST(leastEdge < 3);
    BOOST_TEST(thinnest < 1.0 / 25);  // height over longest edge
    BOOST_TEST(thinnest > 0);
}

struct PathClearance {
    double least = std::numeric_limits<double>::infinity();  ///< least clearance over the samples
    double length = 0;                                       ///< sum of longestMotion
    double tightLength = 0;                                  ///< part of the length with a clearance <= tight
    bool proven = true;  ///< the distance is > `never` everywhere on the way, not only at the samples
    std::size_t samples = 0;
};

/// Walks along the path in steps of at most `longestStep`. At a step's beginning the clearance above `never`
/// is at least the farthest that the step moves a point of the part. So the distance cannot fall to `never`
/// in between.
inline PathClearance walkPath(const Model& part, const Model& environment, const std::vector<PartState>& path,
                              double never, double tight, double longestStep) {
    Workspace workspace;
    PathClearance result;
    const auto lowerAt = [&](const PartState& state) {
        const double lower = distance(part, environment, poseOf(state), {}, workspace).lower;
        result.least = std::min(result.least, lower);
        ++result.samples;
        return lower;
    };
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const PartState &from = path[i], &to = path[i + 1];
        const double motion = longestMotion(from, to, part.radiusAboutOrigin());
        for (double done = 0; done < motion;) {
            const double lower = lowerAt(between(from, to, done / motion));
            if (lower <= never) {
                result.proven = false;
                return result;
            }
            const double step = std::min({lower - never, longestStep, motion - done});
            if (lower <= tight) result.tightLength += step;
            done = motion - done <= step ? motion : done + step;
            result.length += step;
        }
    }
    result.proven = lowerAt(path.back()) > never;
    return result;
}

/// The share of 200 poses on the way from one state to the other that collide.
inline double collidingShare(const Model& part, const Model& environment, const PartState& from,
                             const PartState& to) {
    constexpr int kSamples = 200;
    Workspace workspace;
    int colliding = 0;
    for (int i = 0; i < kSamples; ++i) {
        const PartState state = between(from, to, (i + 0.5) / kSamples);
        colliding += collides(part, environment, poseOf(state), workspace);
    }
    return static_cast<double>(colliding) / kSamples;
}

inline PathClearance walkPath(const GeneratedScene& scene, double never, double tight, double longestStep) {
    return walkPath(Model::build(scene.part), Model::build(scene.environment), scene.path, never, tight,
                    longestStep);
}

}  // namespace clearway::testing
