// AxisSplit: rates the planes through the mean along three principal axes by the RSS areas of the children.
#include <limits>
#include <utility>

#include "build/fit_rss.h"
#include "build/general_splits.h"
#include "build/top_down.h"

namespace clearway {

namespace {

/// Corners of a node and of the two children that a plane makes, reused from node to node for their storage.
struct Scratch {
    std::vector<Vector3> corners;
    std::vector<Vector3> left;
    std::vector<Vector3> right;
};

/// The sum of the areas of both children; infinite when one side is empty.
double areaOfChildren(const CleanMesh& mesh, TriangleRun run, const Plane& plane, Scratch& scratch) {
    scratch.left.clear();
    scratch.right.clear();
    for (const std::uint32_t triangle : run) {
        appendCorners(mesh, triangle, liesBeyond(mesh, triangle, plane) ? scratch.right : scratch.left);
    }
    if (scratch.left.empty() || scratch.right.empty()) return std::numeric_limits<double>::infinity();
    return fitRss(scratch.left).area() + fitRss(scratch.right).area();
}

std::size_t splitAtBestAxis(const CleanMesh& mesh, TriangleRun run, Scratch& scratch) {
    gatherCorners(mesh, run.first, run.size(), scratch.corners);
    const PrincipalFrame frame = principalFrame(scratch.corners);
    int bestAxis = 0;
    double leastArea = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double area = areaOfChildren(mesh, run, {frame.mean, frame.axes.col(axis)}, scratch);
        if (area < leastArea) {
            leastArea = area;
            bestAxis = axis;
        }
    }
    return partitionByPlane(mesh, run, {frame.mean, frame.axes.col(bestAxis)});
}

}  // namespace

BinaryTree buildByAxisSplit(const CleanMesh& mesh, std::vector<std::uint32_t> triangles,
                            std::size_t largestGroup) {
    return buildTopDown(mesh, std::move(triangles), largestGroup, [&mesh] {
        return [&mesh, scratch = Scratch()](TriangleRun run) mutable {
            return splitAtBestAxis(mesh, run, scratch);
        };
    });
}

}  // namespace clearway
