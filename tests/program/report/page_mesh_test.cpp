#include "program/report/page_mesh.h"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "mesh/components.h"
#include "support/window_scene.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(page_mesh_test)

using namespace report;

const Mesh wall = windowScene().wallMesh;  // 432 triangles

Vector3 vertexOf(const PageMesh& page, std::size_t i) {
    return page.placeOf(page.positions[i]);
}

constexpr std::size_t kAllEdges = 10000;

/// The largest distance of a vertex in the page from one of the mesh's.
double largestError(const PageMesh& page, const Mesh& mesh) {
    double largest = 0;
    for (std::size_t i = 0; i < page.positions.size(); ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vector3& vertex : mesh.vertices)
            nearest = std::min(nearest, (vertexOf(page, i) - vertex).norm());
        largest = std::max(largest, nearest);
    }
    return largest;
}

BOOST_AUTO_TEST_CASE(a_small_mesh_is_kept_whole_but_for_16_bits) {
    const PageMesh page = pageMeshOf(wall, {432, kAllEdges});
    BOOST_TEST(page.triangles.size() == 432u);
    BOOST_TEST(page.error < 1e-5 * boundingBox(wall).diagonal().norm());
    BOOST_TEST(largestError(page, wall) <= page.error);
    for (std::size_t t = 0; t < page.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const Vector3& vertex = wall.vertices[wall.triangles[t][i]];
            BOOST_TEST((vertexOf(page, page.triangles[t][i]) - vertex).norm() <= page.error);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_large_mesh_is_thinned_to_the_number_asked_for_and_its_error_told) {
    for (const std::size_t most : {400u, 200u, 60u}) {
        const PageMesh page = pageMeshOf(wall, {most, kAllEdges});
        BOOST_TEST(page.triangles.size() <= most);
        BOOST_TEST(page.triangles.size() > 0u);
        BOOST_TEST(largestError(page, wall) <= page.error);
        BOOST_TEST(page.error > 1e-3 * boundingBox(wall).diagonal().norm());
    }
}

BOOST_AUTO_TEST_CASE(each_component_owns_its_triangles_and_edges) {
    for (const std::size_t most : {432u, 200u}) {
        const PageMesh page = pageMeshOf(wall, {most, kAllEdges});
        BOOST_TEST_REQUIRE(page.triangleCounts.size() == 4u);
        std::size_t triangle = 0, edge = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const Box box = boundingBox(meshOfComponents(wall, {i}));
            for (std::size_t end = triangle + page.triangleCounts[i]; triangle < end; ++triangle) {
                for (const std::uint32_t v : page.triangles[triangle])
                    BOOST_TEST(box.exteriorDistance(vertexOf(page, v)) <= page.error);
            }
            for (std::size_t end = edge + page.edgeCounts[i]; edge < end; ++edge) {
                for (const std::uint32_t v : page.edges[edge])
                    BOOST_TEST(box.exteriorDistance(vertexOf(page, v)) <= page.error);
            }
        }
        BOOST_TEST(triangle == page.triangles.size());
        BOOST_TEST(edge == page.edges.size());
        BOOST_TEST(edge == page.allEdges);
    }
}

BOOST_AUTO_TEST_CASE(of_too_many_edges_a_limit_keeps_some) {
    const PageMesh page = pageMeshOf(wall, {432, 20});
    BOOST_TEST(page.edges.size() <= 20u);
    BOOST_TEST(page.allEdges > 20u);
}

BOOST_AUTO_TEST_CASE(a_flat_mesh_has_a_place_in_its_plane) {
    Mesh flat;
    flat.vertices = {{0, 0, 7}, {1, 0, 7}, {0, 1, 7}};
    flat.triangles = {{0, 1, 2}};
    const PageMesh page = pageMeshOf(flat, {10, 10});
    BOOST_TEST(page.triangles.size() == 1u);
    for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(vertexOf(page, i).z() == 7);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
