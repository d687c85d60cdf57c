#include "build/top_down.h"

#include <boost/test/unit_test.hpp>
#include <numeric>

#include "build/sample_meshes.h"
#include "build/split/children.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(halves_test)

TriangleSet leftHalf(const CleanMesh& mesh) {
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.rbegin(), order.rend(), 0u);  // backwards: the result must not depend on it
    const std::size_t count = splitInHalves(mesh, {order.data(), order.data() + order.size()});
    return {order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count)};
}

BOOST_AUTO_TEST_CASE(the_median_along_the_longest_side_parts_the_triangles) {
    std::vector<Corners> triangles;
    for (int i = 0; i < 9; ++i) {
        const Vector3 at((i * 5) % 9, 0.1 * i, 0);
        triangles.push_back({at, at + Vector3(0.1, 0, 0), at + Vector3(0, 0.1, 0)});
    }
    BOOST_TEST(
        (leftHalf(cleanMeshOf(triangles)) == TriangleSet{0, 2, 4, 6}));  // x = 0, 1, 2, 3 at i = 0, 2, 4, 6
}

BOOST_AUTO_TEST_CASE(coinciding_centroids_are_parted_by_position) {
    const Vector3 x = Vector3::UnitX();
    const Vector3 y = Vector3::UnitY();
    BOOST_TEST((leftHalf(cleanMeshOf(std::vector<Corners>(6, {x, y, x + y}))) == TriangleSet{0, 1, 2}));
    BOOST_TEST((leftHalf(cleanMeshOf(std::vector<Corners>(2, {x, x, x}))) == TriangleSet{0}));
    BOOST_TEST((leftHalf(cleanMeshOf(std::vector<Corners>(3, {x, x, x}))) == TriangleSet{0}));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
