#include "build/general_splits.h"

#include <boost/test/unit_test.hpp>

#include "build/fit_rss.h"
#include "build/sample_meshes.h"
#include "build/split/children.h"
#include "tree/rss.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(axis_test)

/// Two long plates, one above the other: the spread is greatest along them.
std::vector<Corners> twoPlates() {
    std::vector<Corners> triangles;
    for (const double z : {0.0, 3.0}) {
        for (int i = 0; i < 20; ++i) {
            const double x = 0.5 * i;
            triangles.push_back({Vector3(x, 0, z), Vector3(x + 0.5, 0, z), Vector3(x + 0.5, 1, z)});
            triangles.push_back({Vector3(x, 0, z), Vector3(x + 0.5, 1, z), Vector3(x, 1, z)});
        }
    }
    return triangles;
}

BOOST_AUTO_TEST_CASE(the_axis_of_least_area_wins_over_that_of_greatest_spread) {
    const CleanMesh mesh = cleanMeshOf(twoPlates());
    TriangleSet lower;
    TriangleSet upper;
    for (std::uint32_t i = 0; i < 40; ++i) {
        lower.insert(i);
        upper.insert(40 + i);
    }
    BOOST_TEST((rootChildren(buildByAxisSplit, mesh) == std::make_pair(lower, upper)));
    BOOST_TEST((rootChildren(buildByMeanSplit, mesh) != std::make_pair(lower, upper)));
}

double areaOf(const CleanMesh& mesh, const TriangleSet& triangles) {
    std::vector<Vector3> corners;
    for (const std::uint32_t triangle : triangles) {
        for (const std::uint32_t vertex : mesh.triangles[triangle]) corners.push_back(mesh.vertices[vertex]);
    }
    return fitRss(corners).area();
}

BOOST_AUTO_TEST_CASE(no_other_principal_axis_would_have_given_less_area) {
    for (std::uint64_t seed = 41; seed < 61; ++seed) {
        BOOST_TEST_CONTEXT("seed " << seed) {
            const CleanMesh mesh = cleanMeshOf(soup(60, seed));
            const auto [left, right] = rootChildren(buildByAxisSplit, mesh);
            const double area = areaOf(mesh, left) + areaOf(mesh, right);
            std::vector<Vector3> corners;
            for (const TriangleIndices& triangle : mesh.triangles) {
                for (const std::uint32_t vertex : triangle) corners.push_back(mesh.vertices[vertex]);
            }
            const PrincipalFrame frame = principalFrame(corners);
            double least = std::numeric_limits<double>::infinity();
            for (int axis = 0; axis < 3; ++axis) {
                TriangleSet sides[2];
                for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
                    Vector3 sum = Vector3::Zero();
                    for (const std::uint32_t vertex : mesh.triangles[i])
                        sum += mesh.vertices[vertex] - frame.mean;
                    sides[sum.dot(frame.axes.col(axis)) > 0].insert(i);
                }
                least = std::min(least, areaOf(mesh, sides[0]) + areaOf(mesh, sides[1]));
            }
            BOOST_TEST(area == least, boost::test_tools::tolerance(1e-12));
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
