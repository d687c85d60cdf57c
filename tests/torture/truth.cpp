#include "torture/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/oracle.h"

namespace clearway::testing {
namespace {

void measureMesh(const Mesh& mesh, CaseLengths& lengths) {
    Box box;
    for (const Vector3& p : mesh.vertices) {
        lengths.largest = std::max(lengths.largest, p.cwiseAbs().maxCoeff());
        box.extend(p);
        for (const double x : p) {  // almost a point, or almost in the origin
            if (x != 0 && std::abs(x) < 0x1p-1000)
                lengths.leastSize = std::min(lengths.leastSize, std::abs(x));
        }
    }
    const double size = box.diagonal().stableNorm();
    lengths.scene += size;
    if (size > 0) lengths.leastSize = std::min(lengths.leastSize, size);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = cornersOf(mesh, i);
        const Vector3 edges[3] = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
        const double longest = std::max({edges[0].norm(), edges[1].norm(), edges[2].norm()});
        lengths.edge = std::max(lengths.edge, longest);
        const Vector3 u = edges[0] / longest, v = edges[1] / longest;  // squares might overflow or vanish
        lengths.flattest = longest > 0 ? std::min(lengths.flattest, u.cross(v).norm()) : 0;
    }
}

Triangle pointTriangle(const Vector3& point) {
    return {point, point, point};
}

}  // namespace

ExactDistance exactDistance(const PosedMeshes& posed) {
    ExactDistance least;
    bool isFirst = true;
    for (std::size_t i = 0; i < posed.part.triangles.size(); ++i) {
        for (std::size_t j = 0; j < posed.environment.triangles.size(); ++j) {
            const ExactDistance distance =
                exactDistance(posed.pose, cornersOf(posed.part, i), cornersOf(posed.environment, j));
            if (distance.isZero()) return distance;
            if (isFirst || distance.compare(least) < 0) least = distance;
            isFirst = false;
        }
    }
    return least;
}

ExactDistance exactlyFromPart(const PosedMeshes& posed, std::size_t triangle, const Vector3& point) {
    return exactDistance(posed.pose, cornersOf(posed.part, triangle), pointTriangle(point));
}

ExactDistance exactlyFromEnvironment(const PosedMeshes& posed, std::size_t triangle, const Vector3& point) {
    return exactDistance(Pose{}, pointTriangle(point), cornersOf(posed.environment, triangle));
}

CaseLengths lengthsOf(const PosedMeshes& posed) {
    CaseLengths lengths;
    lengths.leastSize = std::numeric_limits<double>::infinity();
    measureMesh(posed.part, lengths);
    measureMesh(posed.environment, lengths);
    lengths.largest = std::max(lengths.largest, posed.pose.translation.cwiseAbs().maxCoeff());
    for (const Vector3& p : posed.part.vertices) {
        lengths.largest = std::max(lengths.largest, (posed.pose * p).cwiseAbs().maxCoeff());
    }
    return lengths;
}

}  // namespace clearway::testing
