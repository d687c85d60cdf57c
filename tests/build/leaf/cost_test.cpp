#include <boost/test/unit_test.hpp>
#include <numeric>
#include <set>

#include "build/collapse.h"
#include "build/leaf/groups.h"
#include "build/leaf_splits.h"
#include "build/sample_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(cost_test)

using Parts = std::set<std::set<std::uint32_t>>;

/// The parts that the triangles, at most `together`, are divided into.
Parts partsOf(const std::vector<Corners>& triangles, std::size_t together = 4) {
    const CleanMesh mesh = cleanMeshOf(triangles);
    std::vector<std::uint32_t> all(triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    BinaryTree tree = buildBySah(mesh, all, together);
    splitByCost(tree, mesh, buildBySah);
    Parts parts;
    for (const auto& leaf : leavesOf(tree)) parts.emplace(leaf.begin(), leaf.end());
    return parts;
}

/// Two triangles.
void addRectangle(std::vector<Corners>& triangles, const Vector3& at, const Vector3& u, const Vector3& v) {
    triangles.push_back({at, at + u, at + u + v});
    triangles.push_back({at, at + u + v, at + v});
}

std::vector<Corners> turned(std::vector<Corners> triangles, const Vector3& axis) {
    const Matrix3 R = Eigen::AngleAxisd(0.7, axis.normalized()).toRotationMatrix();
    for (Corners& corners : triangles) {
        for (Vector3& corner : corners) corner = R * corner;
    }
    return triangles;
}

/// Both faces of a sheet. Their triangles, 0 and 2, 1 and 3, take turns.
std::vector<Corners> sheet(double thickness) {
    std::vector<Corners> triangles;
    addRectangle(triangles, {0, 0, 0}, {3, 0, 0}, {0, 2, 0});
    addRectangle(triangles, {0, 0, thickness}, {3, 0, 0}, {0, 2, 0});
    std::swap(triangles[1], triangles[2]);
    return triangles;
}

BOOST_AUTO_TEST_CASE(both_faces_of_a_sheet_are_parted) {
    const Parts faces = {{0, 2}, {1, 3}};
    for (const auto& axis : {Vector3(1, 2, 3), Vector3(0, 0, 1)}) {
        const std::vector<Corners> oblique = turned(sheet(0.3), axis);
        BOOST_TEST((partsOf(oblique) == faces));
        for (const double scale : {1e-12, 1e12})
            BOOST_TEST((partsOf(transformed(oblique, scale, Vector3::Zero())) == faces));
        BOOST_TEST((partsOf(transformed(oblique, 1, {1e6, -2e6, 3e6})) == faces));
    }
}

BOOST_AUTO_TEST_CASE(faces_so_near_that_one_volume_is_hardly_larger_stay_together) {
    BOOST_TEST((partsOf(turned(sheet(0.03), {1, 2, 3})) == Parts{{0, 1, 2, 3}}));
}

BOOST_AUTO_TEST_CASE(what_lies_together_in_a_plane_stays_together) {
    std::vector<Corners> strip;
    addRectangle(strip, {0, 0, 0}, {1, 0, 0}, {0, 2, 0});
    addRectangle(strip, {1, 0, 0}, {1, 0, 0}, {0, 2, 0});
    BOOST_TEST((partsOf(strip) == Parts{{0, 1, 2, 3}}));
    BOOST_TEST((partsOf(turned(strip, {3, 2, 1})) == Parts{{0, 1, 2, 3}}));
    strip.pop_back();
    BOOST_TEST((partsOf({strip[0], strip[1]}) == Parts{{0, 1}}));
}

BOOST_AUTO_TEST_CASE(no_division_of_equals_or_of_points_gains) {
    const Corners triangle = {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0.3)};
    BOOST_TEST((partsOf({triangle, triangle, triangle, triangle}) == Parts{{0, 1, 2, 3}}));
    const Corners point = {Vector3(1, 2, 3), Vector3(1, 2, 3), Vector3(1, 2, 3)};
    BOOST_TEST((partsOf({point, point, point}) == Parts{{0, 1, 2}}));
    BOOST_TEST((partsOf({triangle}) == Parts{{0}}));
}

BOOST_AUTO_TEST_CASE(distant_triangles_are_parted_needles_and_points_too) {
    const Corners needle = {Vector3(0, 0, 0), Vector3(1, 1, 0), Vector3(2, 2, 0)};
    const Corners point = {Vector3(5, 0, 9), Vector3(5, 0, 9), Vector3(5, 0, 9)};
    const Corners triangle = {Vector3(-9, 7, 0), Vector3(-8, 7, 0), Vector3(-9, 8, 1)};
    BOOST_TEST((partsOf({needle, point, triangle}) == Parts{{0}, {1}, {2}}));
}

BOOST_AUTO_TEST_CASE(large_groups_are_made_small_first) {
    for (const std::size_t together : {5u, 8u, 16u}) {
        const std::vector<Corners> triangles = soup(200, 77);
        std::size_t count = 0;
        for (const auto& part : partsOf(triangles, together)) {
            BOOST_TEST(part.size() <= kMostByCost);
            count += part.size();
        }
        BOOST_TEST(count == 200u);
    }
}

BOOST_AUTO_TEST_CASE(parts_cost_less_than_what_they_are_parts_of_and_all_nodes_are_rated) {
    const CleanMesh mesh = cleanMeshOf(soup(500, 78));
    for (const NamedGeneralSplit& general : kGeneralSplits) {
        std::vector<std::uint32_t> all(mesh.triangles.size());
        std::iota(all.begin(), all.end(), 0u);
        BinaryTree tree = general.build(mesh, all, 4);
        splitByCost(tree, mesh, general.build);
        const float ofOneMore = tree.nodes[0].area / 500;
        for (const BinaryNode& node : tree.nodes) {
            BOOST_TEST((node.costAsLeaf > 0) == (node.triangleCount <= 4));
            if (node.isLeaf()) continue;
            BOOST_TEST(node.area >= 0);
            if (node.costAsLeaf <= 0) continue;
            const float apart = tree.nodes[node.left].costAsLeaf + tree.nodes[node.right].costAsLeaf;
            const bool areLeaves = tree.nodes[node.left].isLeaf() && tree.nodes[node.right].isLeaf();
            if (areLeaves) BOOST_TEST(apart - ofOneMore < node.costAsLeaf * 1.0001f);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
