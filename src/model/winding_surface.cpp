#include "model/winding_surface.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/clean.h"
#include "mesh/topology.h"
#include "model/solids.h"
#include "tree/flat_tree.h"

namespace clearway {
namespace {

using TriangleCorners = std::array<Vector3, 3>;

/// Calls take(component, corners) for the triangles, as far as the tree holds them.
template <class Take>
void eachTriangleOf(const Model& model, const Take& take) {
    const std::vector<Component>& components = model.components();
    std::vector<std::size_t> ofTriangle;
    for (std::size_t i = 0; i < components.size(); ++i)
        ofTriangle.resize(components[i].firstTriangle + std::size_t(components[i].triangleCount), i);
    const FlatTree& tree = model.tree();
    for (const LeafReference leaf : tree.leaves()) {
        for (std::uint32_t n = 0; n < tree.leaf(leaf).triangleCount; ++n) {
            const TriangleAt at{leaf, n};
            take(ofTriangle.at(tree.triangleId(at)), tree.corners(at));
        }
    }
}

/// Whether a ray from the point crosses the triangle, but for rounding. The ray is askew, so that it seldom meets an edge.
bool isCrossed(const TriangleCorners& corners, const Vector3& point) {
    const auto fromRay = [&](const Vector3& corner) -> Vector3 {
        const Vector3 d = corner - point;
        return {d.x(), d.y() - 0.1371 * d.x(), d.z() - 0.0737 * d.x()};
    };
    const TriangleCorners seen{fromRay(corners[0]), fromRay(corners[1]), fromRay(corners[2])};
    int left = 0;
    for (int k = 0; k < 3; ++k) {
        const Vector3 &a = seen[k], &b = seen[(k + 1) % 3];
        left += a.y() * b.z() > a.z() * b.y();
    }
    if (left % 3 != 0) return false;
    const Vector3 normal = (seen[1] - seen[0]).cross(seen[2] - seen[0]);
    return normal.dot(seen[0]) * normal.x() > 0;
}

/// The components that rays cross an odd number of times from one end, and an even number from the other.
std::vector<bool> crossedUnevenly(const Model& model, const PointAtEnds& ends) {
    std::vector<bool> isUneven(model.components().size(), false);
    const Vector3 start = ends.start * ends.point, goal = ends.goal ? *ends.goal * ends.point : start;
    eachTriangleOf(model, [&](std::size_t component, const TriangleCorners& corners) {
        const bool isCrossedFromGoal = ends.goal && isCrossed(corners, goal);
        if (isCrossed(corners, start) != isCrossedFromGoal) isUneven[component] = !isUneven[component];
    });
    return isUneven;
}

Mesh meshOfCorners(const std::vector<TriangleCorners>& triangles) {
    Mesh mesh;
    for (const TriangleCorners& corners : triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// A point beyond the box of the triangles, and of its own rounding, is outside.
bool isInBox(const std::vector<TriangleCorners>& triangles, const Vector3& point) {
    constexpr double kBoxSlack = 1e-9;
    Box box;
    for (const TriangleCorners& corners : triangles)
        for (const Vector3& corner : corners) box.extend(corner);
    const Vector3 slack = Vector3::Constant(kBoxSlack * (box.diagonal().norm() + point.norm()));
    return Box(box.min() - slack, box.max() + slack).contains(point);
}

/// Whether it is the start that a closed shell of the triangles winds around; nothing where none parts the ends.
std::optional<bool> endInside(const std::vector<TriangleCorners>& triangles, const PointAtEnds& ends) {
    const CleanMesh cleaned = clean(meshOfCorners(triangles));
    const Shells shells = findShells(cleaned.triangles);
    std::vector<std::vector<TriangleCorners>> each(shells.count);
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        const TriangleIndices& ids = cleaned.triangles[t];
        each[shells.ofTriangle[t]].push_back(
            {cleaned.vertices[ids[0]], cleaned.vertices[ids[1]], cleaned.vertices[ids[2]]});
    }
    for (const std::vector<TriangleCorners>& shell : each) {
        if (!isInBox(shell, ends.start * ends.point) &&
            !(ends.goal && isInBox(shell, *ends.goal * ends.point)))
            continue;
        try {
            const Solid solid(meshOfCorners(shell), "shell");
            const auto winding = [&](const Pose& X) { return solid.winding(Pose{}, X, ends.point); };
            const int atStart = winding(ends.start), atGoal = ends.goal ? winding(*ends.goal) : 0;
            if (atStart != atGoal) return atStart != 0;
        } catch (const std::invalid_argument&) {  // open: it shuts nothing in
        }
    }
    return std::nullopt;
}

}  // namespace

Vector3 anyPointOf(const Model& model) {
    const FlatTree& tree = model.tree();
    return tree.corners({tree.leaves().at(0), 0})[0];
}

std::optional<WindingSurface> surfaceThatParts(const Model& model, const PointAtEnds& ends) {
    const std::vector<bool> isUneven = crossedUnevenly(model, ends);
    if (std::find(isUneven.begin(), isUneven.end(), true) == isUneven.end()) return std::nullopt;
    std::vector<std::vector<TriangleCorners>> triangles(isUneven.size());
    eachTriangleOf(model, [&](std::size_t component, const TriangleCorners& corners) {
        if (isUneven[component]) triangles[component].push_back(corners);
    });
    for (std::size_t i = 0; i < isUneven.size(); ++i) {
        if (!isUneven[i]) continue;
        const std::optional<bool> isAroundStart = endInside(triangles[i], ends);
        if (!isAroundStart) continue;
        const std::string& name = model.components()[i].name;
        return WindingSurface{name.empty() ? model.origin().file : name, *isAroundStart};
    }
    return std::nullopt;
}

}  // namespace clearway
