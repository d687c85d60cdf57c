// Where a leaf is exact, its floats are the mesh's vertices bit for bit; where it is not, the tree keeps the vertices.
#include "build/leaf_centre.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>

#include "build/build.h"
#include "build/check_tree.h"
#include "build/flatten.h"
#include "build/sample_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(leaf_centre_test)

std::vector<Corners> changed(std::vector<Corners> triangles, const std::function<double(double)>& change) {
    for (Corners& corners : triangles) {
        for (Vector3& corner : corners) corner = corner.unaryExpr(change);
    }
    return triangles;
}

double toFloat(double x) {
    return static_cast<float>(x);
}

LeafCorners cornersOf(const std::vector<Vector3>& points) {
    LeafCorners corners;
    for (const Vector3& point : points) corners.add(point);
    return corners;
}

/// The same bits, except that -0 is 0.
bool isSame(double a, double b) {
    a += 0.0, b += 0.0;
    return std::memcmp(&a, &b, sizeof a) == 0;
}

struct Kinds {
    std::size_t exact = 0, others = 0;  ///< leaves
    double shareOfExact() const { return double(exact) / double(exact + others); }
};

/// Checks each corner bit for bit, and counts the kinds of leaves.
Kinds checkCorners(const FlatTree& tree, const CleanMesh& mesh) {
    std::size_t wrong = 0;
    for (const TriangleAt triangle : trianglesOf(tree)) {
        const TriangleIndices& original = mesh.triangles.at(tree.triangleId(triangle) - 7);
        const std::array<Vector3, 3> corners = tree.corners(triangle);
        for (std::size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) wrong += !isSame(corners[i][k], mesh.vertices[original[i]][k]);
        }
    }
    BOOST_TEST(wrong == 0u);
    Kinds kinds;
    for (const LeafReference at : tree.leaves()) ++(tree.leaf(at).isExact ? kinds.exact : kinds.others);
    BOOST_TEST((kinds.others == 0) == tree.vertices.empty());
    return kinds;
}

Kinds builtFrom(const std::vector<Corners>& triangles) {
    const CleanMesh mesh = cleanMeshOf(triangles);
    const FlatTree tree = flatten(buildBinaryTree(mesh, {}), mesh, 8);
    checkTree(tree, mesh);
    return checkCorners(tree, mesh);
}

BOOST_AUTO_TEST_CASE(leaves_of_floats_are_exact) {
    for (const double scale : {1.0, 1e3, 1e-3, 0x1p-100, 0x1p100, 25.4}) {
        for (const Vector3& shift : {Vector3(0, 0, 0), Vector3(0.3, -7, 90), Vector3(2000, 0.01, -1e5)}) {
            BOOST_TEST_CONTEXT("scale " << scale << ", shift " << shift.transpose()) {
                for (const auto& shape : {soup(700, 31), bentSheet(40, 9)}) {
                    const Kinds kinds = builtFrom(changed(transformed(shape, scale, scale * shift), toFloat));
                    BOOST_TEST(kinds.shareOfExact() > 0.99);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(leaves_of_whole_numbers_are_exact_at_any_place) {
    for (const double away : {0.0, 1e3, 1e9, 1e15}) {
        const auto whole = changed(soup(300, 32), [&](double x) { return std::round(1000 * x) + away; });
        BOOST_TEST(builtFrom(whole).others == 0u);
    }
}

BOOST_AUTO_TEST_CASE(a_leaf_across_zero_is_exact_beside_coordinates_that_are_nearly_zero) {
    // Noise of 24 bits far below the size of the triangles, as turned CAD models have it in their planes.
    std::vector<Corners> triangles = soup(400, 33);
    Random random(34);
    for (Corners& corners : triangles) {
        for (Vector3& corner : corners) corner[random.below(3)] = random.uniform(-1, 1) * 1e-9;
    }
    BOOST_TEST(builtFrom(changed(triangles, toFloat)).shareOfExact() > 0.9);
}

BOOST_AUTO_TEST_CASE(leaves_of_doubles_keep_their_vertices) {
    BOOST_TEST(builtFrom(soup(700, 35)).exact == 0u);
    BOOST_TEST(builtFrom(transformed(soup(90, 36), 1, {5, -7, 1})).exact == 0u);
}

BOOST_AUTO_TEST_CASE(doubles_far_from_the_origin_are_exact_where_few_bits_are_left_of_a_leaf) {
    // Coordinates are whole multiples of 2^-30, and a leaf's size is some 2^20 of them.
    BOOST_TEST(builtFrom(transformed(soup(90, 36), 1e-3, {5e6, -7e6, 5e6})).others == 0u);
}

BOOST_AUTO_TEST_CASE(leaves_of_both_kinds_stand_in_one_tree) {
    std::vector<Corners> triangles = changed(soup(400, 37), toFloat);
    for (const Corners& corners : transformed(soup(400, 38), 1, {0.7, 0, 0})) triangles.push_back(corners);
    const Kinds kinds = builtFrom(triangles);
    BOOST_TEST(kinds.exact > 50u);
    BOOST_TEST(kinds.others > 50u);
}

BOOST_AUTO_TEST_CASE(one_double_among_floats_makes_one_leaf_inexact) {
    std::vector<Corners> triangles = changed(soup(400, 39), toFloat);
    triangles[123][1].y() = std::nextafter(triangles[123][1].y(), 2.0);
    BOOST_TEST(builtFrom(triangles).others == 1u);
}

BOOST_AUTO_TEST_CASE(subnormal_and_huge_coordinates_keep_their_bits) {
    builtFrom(transformed(changed(soup(60, 40), toFloat), 0x1p-1000, {0, 0, 0}));
    builtFrom(transformed(changed(soup(60, 41), toFloat), 0x1p990, {0, 0, 0}));
    // Queries refuse coordinates as small as these.
    const CleanMesh subnormal =
        cleanMeshOf(transformed(changed(soup(60, 43), toFloat), 0x1p-1050, {0, 0, 0}));
    checkCorners(flatten(buildBinaryTree(subnormal, {}), subnormal, 8), subnormal);
    // Each triangle four times as far out as the one before: float cannot hold the nearest ones in the tree's unit.
    std::vector<Corners> triangles;
    for (int i = -250; i < 250; ++i) {
        const double size = std::ldexp(1.0, 2 * i);
        triangles.push_back({size * Vector3(1, 0, 0), size * Vector3(1.1, 0, 0), size * Vector3(1, 0.1, 0)});
    }
    builtFrom(triangles);
}

BOOST_AUTO_TEST_CASE(no_offset_of_an_exact_leaf_is_denormal) {
    const double tiny = 0x1p-130;
    const LeafCentre centre = chooseLeafCentre(cornersOf({{0, 0, 0}, {tiny, 0, 0}, {1, 0, 0}}), {0, 0, 0}, 1);
    BOOST_TEST(!centre.isExact);
    BOOST_TEST(chooseLeafCentre(cornersOf({{0, 0, 0}, {0x1p-120, 0, 0}, {1, 0, 0}}), {0, 0, 0}, 1).isExact);
}

BOOST_AUTO_TEST_CASE(a_centre_is_near_the_middle) {
    Random random(42);
    for (int draw = 0; draw < 2000; ++draw) {
        const Vector3 at = random.inBox(1);
        const double size = std::pow(10.0, random.uniform(-3, 0));
        std::vector<Vector3> corners;
        Box box;
        for (int i = 0; i < 12; ++i) {
            corners.push_back((at + random.inBox(size)).unaryExpr(std::function<double(double)>(toFloat)));
            box.extend(corners.back());
        }
        const LeafCentre centre = chooseLeafCentre(cornersOf(corners), {0.25, 0, -0.5}, 2);
        BOOST_REQUIRE(centre.isExact);
        const double least = 0.5 * box.diagonal().norm();
        for (const Vector3& corner : corners) {
            BOOST_REQUIRE((corner - centre.point).norm() <= 4.1 * least);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
