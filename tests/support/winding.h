// The winding number of a surface around a point, from the solid angles of its triangles.
#pragma once

#include <algorithm>
#include <cmath>

#include "clearway/mesh.h"

namespace clearway::testing {

inline Mesh reversed(Mesh mesh) {
    for (TriangleIndices& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// For a closed surface that does not contain the point this is an integer up to rounding.
/// Source: van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30, 1983.
inline double windingBySolidAngles(const Mesh& mesh, const Component& of, const Vector3& point) {
    double sum = 0;
    for (std::uint32_t i = 0; i < of.triangleCount; ++i) {
        const TriangleIndices& t = mesh.triangles[of.firstTriangle + i];
        const Vector3 a = mesh.vertices[t[0]] - point, b = mesh.vertices[t[1]] - point,
                      c = mesh.vertices[t[2]] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum +=
            2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4 * M_PI);
}

}  // namespace clearway::testing
