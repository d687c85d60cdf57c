#include "build/general_splits.h"

#include <boost/test/unit_test.hpp>

#include "build/sample_meshes.h"
#include "build/split/children.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(sah_test)

/// A patch of n x n cells in the plane of u and v.
void addPatch(std::vector<Corners>& triangles, const Vector3& at, const Vector3& u, const Vector3& v, int n) {
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const auto point = [&](int k, int l) -> Vector3 {
                return at + (double(k) / n) * u + (double(l) / n) * v;
            };
            triangles.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
            triangles.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
        }
    }
}

std::pair<TriangleSet, TriangleSet> cutAt(std::uint32_t first, std::size_t count) {
    std::pair<TriangleSet, TriangleSet> sides;
    for (std::uint32_t i = 0; i < count; ++i) (i < first ? sides.first : sides.second).insert(i);
    return sides;
}

Matrix3 turn() {
    return (Eigen::AngleAxisd(0.7, Vector3::UnitX()) * Eigen::AngleAxisd(0.4, Vector3::UnitZ()))
        .toRotationMatrix();
}

BOOST_AUTO_TEST_CASE(a_dense_cluster_is_parted_from_a_sparse_one_at_the_gap) {
    // The mean lies within the dense patch; the gap between the two is where it is cheap to cut.
    std::vector<Corners> triangles;
    addPatch(triangles, {0, 0, 0}, Vector3::UnitX(), Vector3::UnitY(), 12);
    const std::uint32_t dense = static_cast<std::uint32_t>(triangles.size());
    addPatch(triangles, {1.5, 0, 0}, Vector3::UnitX(), Vector3::UnitY(), 3);
    const CleanMesh mesh = cleanMeshOf(triangles);
    BOOST_TEST((rootChildren(buildBySah, mesh) == cutAt(dense, triangles.size())));
    BOOST_TEST((rootChildren(buildByMeanSplit, mesh) != cutAt(dense, triangles.size())));
}

BOOST_AUTO_TEST_CASE(two_plates_are_parted_whatever_their_turn) {
    for (const Matrix3& R : {Matrix3(Matrix3::Identity()), turn()}) {
        std::vector<Corners> triangles;
        addPatch(triangles, R * Vector3(0, 0, 0), R * Vector3(4, 0, 0), R * Vector3(0, 4, 0), 6);
        addPatch(triangles, R * Vector3(0, 0, 2), R * Vector3(4, 0, 0), R * Vector3(0, 4, 0), 6);
        const CleanMesh mesh = cleanMeshOf(triangles);
        BOOST_TEST((rootChildren(buildBySah, mesh) == cutAt(72, 144)));
    }
}

BOOST_AUTO_TEST_CASE(coordinate_planes_are_tried_where_the_spread_is_oblique) {
    // Along the diagonal the boxes of two axis-aligned plates in a step would be needlessly large.
    std::vector<Corners> triangles;
    addPatch(triangles, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, 5);
    addPatch(triangles, {3, 3, 0}, {0, 3, 0}, {0, 0, 3}, 5);
    const CleanMesh mesh = cleanMeshOf(triangles);
    BOOST_TEST((rootChildren(buildBySah, mesh) == cutAt(50, 100)));
}

BOOST_AUTO_TEST_CASE(triangles_that_coincide_as_floats_are_still_parted_by_place) {
    // Two clusters a millionth of the mesh's size across, whose centres are equal floats.
    std::vector<Corners> triangles = {{Vector3(-1, 0, 0), Vector3(-1, 1, 0), Vector3(-1, 0, 1)},
                                      {Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(1, 0, 1)}};
    for (const double x : {0.5, 0.5 + 1e-10}) {
        for (int i = 0; i < 4; ++i) {
            const Vector3 at(x, 0.3, 0.3 + 1e-12 * i);
            triangles.push_back({at, at + Vector3(0, 1e-12, 0), at + Vector3(0, 0, 1e-12)});
        }
    }
    const CleanMesh mesh = cleanMeshOf(triangles);
    std::vector<std::uint32_t> small = {2, 6, 3, 7, 4, 8, 5, 9};
    const BinaryTree tree = buildBySah(mesh, small, 4);
    BOOST_TEST((trianglesOf(tree, tree.nodes[0].left) == TriangleSet{2, 3, 4, 5} ||
                trianglesOf(tree, tree.nodes[0].right) == TriangleSet{2, 3, 4, 5}));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
