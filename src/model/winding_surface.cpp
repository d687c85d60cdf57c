#include "model/winding_surface.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/clean.h"
#include "mesh/topology.h"
#include "model/model_data.h"
#include "model/solids.h"
#include "model/triangles_of.h"

namespace clearway {
namespace {

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

/// Counts the triangles that rays from both ends cross. A closed shell parts the ends only where the sum is odd.
class Crossings {
  public:
    explicit Crossings(const PointAtEnds& ends) : points_{ends.start * ends.point} {
        if (ends.goal) points_.push_back(*ends.goal * ends.point);
    }

    int of(const TriangleCorners& corners) const {
        const auto crosses = [&](const Vector3& point) { return isCrossed(corners, point); };
        return static_cast<int>(std::count_if(points_.begin(), points_.end(), crosses));
    }

  private:
    std::vector<Vector3> points_;
};

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

/// Nothing winds around a point outside of its box.
bool isEndInBox(const std::vector<TriangleCorners>& triangles, const PointAtEnds& ends) {
    return isInBox(triangles, ends.start * ends.point) ||
           (ends.goal && isInBox(triangles, *ends.goal * ends.point));
}

/// Whether it is the start that a closed shell of the triangles winds around; nothing where none parts the ends.
std::optional<bool> endInside(const std::vector<TriangleCorners>& triangles, const PointAtEnds& ends) {
    const Crossings crossings(ends);
    const CleanMesh cleaned = clean(meshOfCorners(triangles));
    const Shells shells = findShells(cleaned.triangles);
    std::vector<std::vector<TriangleCorners>> each(shells.count);
    std::vector<int> crossed(shells.count);
    for (std::size_t t = 0; t < cleaned.triangles.size(); ++t) {
        const TriangleIndices& ids = cleaned.triangles[t];
        const std::uint32_t shell = shells.ofTriangle[t];
        each[shell].push_back({cleaned.vertices[ids[0]], cleaned.vertices[ids[1]], cleaned.vertices[ids[2]]});
        crossed[shell] += crossings.of(each[shell].back());
    }
    for (std::uint32_t i = 0; i < shells.count; ++i) {
        const std::vector<TriangleCorners>& shell = each[i];
        if (crossed[i] % 2 == 0 || !isEndInBox(shell, ends)) continue;
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
    const FlatTree& tree = treeOf(model);
    return tree.corners({tree.leaves().at(0), 0})[0];
}

std::optional<WindingSurface> surfaceThatParts(const Model& model, const PointAtEnds& ends) {
    const Crossings crossings(ends);
    std::vector<bool> isMet(model.components().size(), false);
    eachTriangleOf(model, [&](std::size_t component, const TriangleCorners& corners) {
        if (crossings.of(corners) > 0) isMet[component] = true;
    });
    std::vector<std::vector<TriangleCorners>> triangles(isMet.size());
    eachTriangleOf(model, [&](std::size_t component, const TriangleCorners& corners) {
        if (isMet[component]) triangles[component].push_back(corners);
    });
    for (std::size_t i = 0; i < isMet.size(); ++i) {
        if (!isMet[i] || !isEndInBox(triangles[i], ends))
            continue;  // finding shells takes half a second for a million triangles
        const std::optional<bool> isAroundStart = endInside(triangles[i], ends);
        if (!isAroundStart) continue;
        const std::string& name = model.components()[i].name;
        return WindingSurface{name.empty() ? model.origin().file : name, *isAroundStart};
    }
    return std::nullopt;
}

}  // namespace clearway
