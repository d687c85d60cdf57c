#include "program/report/page_edges.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "clearway/mesh.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(page_edges_test)

using namespace report;

std::vector<OwnedTriangle> owned(const std::vector<TriangleIndices>& triangles) {
    std::vector<OwnedTriangle> result;
    for (const TriangleIndices& triangle : triangles) result.emplace_back(0, triangle);
    return result;
}

/// The side of a prism with so many sides, without its ends.
Mesh tube(std::uint32_t sides) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = 2 * M_PI * i / sides;
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        for (const double z : {0.0, 1.0}) mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), z);
        mesh.triangles.push_back({a, b, a + 1});
        mesh.triangles.push_back({b, b + 1, a + 1});
    }
    return mesh;
}

std::size_t edgesOf(const Mesh& mesh) {
    return featureEdges(mesh.vertices, owned(mesh.triangles)).size();
}

BOOST_AUTO_TEST_CASE(a_box_shows_its_12_edges_and_no_diagonals) {
    const Mesh box = boxMesh(Box(Vector3(0, 0, 0), Vector3(1, 2, 3)));
    const auto edges = featureEdges(box.vertices, owned(box.triangles));
    BOOST_TEST(edges.size() == 12u);
    for (const OwnedEdge& edge : edges) {
        const Vector3 way = box.vertices[edge.ends[1]] - box.vertices[edge.ends[0]];
        BOOST_TEST(way.norm() == way.lpNorm<1>());  // along an axis
    }
}

BOOST_AUTO_TEST_CASE(the_order_of_a_triangles_corners_does_not_matter) {
    Mesh box = boxMesh(Box(Vector3(0, 0, 0), Vector3(1, 2, 3)));
    for (std::size_t i = 0; i < box.triangles.size(); i += 3)
        std::swap(box.triangles[i][0], box.triangles[i][1]);
    BOOST_TEST(edgesOf(box) == 12u);
}

BOOST_AUTO_TEST_CASE(round_sides_show_no_edge_but_borders_do) {
    BOOST_TEST(edgesOf(tube(16)) == 32u);      // the borders at both ends
    BOOST_TEST(edgesOf(tube(6)) == 12u + 6u);  // and the sides' edges
}

BOOST_AUTO_TEST_CASE(an_edge_of_three_triangles_is_shown) {
    const std::vector<Vector3> vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    const auto edges = featureEdges(vertices, owned({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
    BOOST_TEST(edges.size() == 7u);
    BOOST_TEST(featureEdges(vertices, owned({{0, 1, 2}, {0, 1, 3}, {0, 0, 4}})).size() == 4u);
}

BOOST_AUTO_TEST_CASE(components_share_no_edge) {
    const std::vector<Vector3> vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}};
    const auto edges = featureEdges(vertices, {{0, {0, 1, 2}}, {1, {0, 1, 3}}});
    BOOST_TEST_REQUIRE(edges.size() == 6u);
    for (std::size_t i = 0; i < 6; ++i) BOOST_TEST(edges[i].owner == i / 3);
}

BOOST_AUTO_TEST_CASE(the_longest_edges_are_kept) {
    const Mesh box = boxMesh(Box(Vector3(0, 0, 0), Vector3(1, 2, 3)));
    auto edges = featureEdges(box.vertices, owned(box.triangles));
    keepLongest(edges, box.vertices, 20);
    BOOST_TEST(edges.size() == 12u);
    keepLongest(edges, box.vertices, 5);
    BOOST_TEST(edges.size() == 4u);  // of the four edges of length 2 none is longer than another
    for (const OwnedEdge& edge : edges)
        BOOST_TEST((box.vertices[edge.ends[1]] - box.vertices[edge.ends[0]]).norm() == 3);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
