#include "mesh/topology.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

namespace clearway {
BOOST_AUTO_TEST_SUITE(topology_test)

/// Counter-clockwise seen from outside.
const std::vector<TriangleIndices> kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

void requireCounts(const EdgeReport& report, std::size_t closed, std::size_t open, std::size_t twisted,
                   std::size_t overfull) {
    BOOST_TEST(report.closedEdges == closed);
    BOOST_TEST(report.openEdges == open);
    BOOST_TEST(report.twistedEdges == twisted);
    BOOST_TEST(report.overfullEdges == overfull);
    BOOST_TEST(report.isClosed() == (open + twisted + overfull == 0));
}

BOOST_AUTO_TEST_CASE(a_closed_surface_is_closed_inside_out_and_in_any_order_too) {
    requireCounts(checkEdges(kTetrahedron), 6, 0, 0, 0);
    std::vector<TriangleIndices> changed = kTetrahedron;
    for (TriangleIndices& t : changed) std::swap(t[0], t[1]);
    requireCounts(checkEdges(changed), 6, 0, 0, 0);
    constexpr unsigned kSeed = 1;
    BOOST_TEST_MESSAGE("seed " << kSeed);
    std::mt19937 random(kSeed);
    for (int i = 0; i < 20; ++i) {
        std::shuffle(changed.begin(), changed.end(), random);
        std::rotate(changed[0].begin(), changed[0].begin() + 1, changed[0].end());
        requireCounts(checkEdges(changed), 6, 0, 0, 0);
    }
}

BOOST_AUTO_TEST_CASE(a_missing_triangle_opens_its_three_edges) {
    requireCounts(checkEdges({kTetrahedron.begin(), kTetrahedron.end() - 1}), 3, 3, 0, 0);
    requireCounts(checkEdges({{0, 1, 2}}), 0, 3, 0, 0);
}

BOOST_AUTO_TEST_CASE(a_triangle_turned_over_twists_its_three_edges) {
    std::vector<TriangleIndices> turned = kTetrahedron;
    std::swap(turned[2][0], turned[2][1]);
    requireCounts(checkEdges(turned), 3, 0, 3, 0);
}

BOOST_AUTO_TEST_CASE(an_edge_of_three_triangles_is_overfull_and_their_borders_are_open) {
    requireCounts(checkEdges({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), 0, 6, 0, 1);
}

BOOST_AUTO_TEST_CASE(solids_that_touch_along_an_edge_are_closed_unless_one_has_a_triangle_turned_over) {
    std::vector<TriangleIndices> both = kTetrahedron;
    for (const TriangleIndices& t : kTetrahedron) {
        TriangleIndices other;  // shares the vertices 0 and 1
        std::transform(t.begin(), t.end(), other.begin(), [](std::uint32_t v) { return v < 2 ? v : v + 2; });
        both.push_back(other);
    }
    requireCounts(checkEdges(both), 10, 0, 0, 0);
    BOOST_TEST(checkEdges(both).touchingEdges == 1u);
    std::vector<TriangleIndices> turned = both;  // edge 0 1 is one of its sides
    std::swap(turned[0][0], turned[0][1]);
    requireCounts(checkEdges(turned), 8, 0, 2, 1);
    BOOST_TEST(checkEdges(turned).touchingEdges == 0u);
    for (TriangleIndices& t : both) std::swap(t[0], t[1]);
    requireCounts(checkEdges(both), 10, 0, 0, 0);
}

BOOST_AUTO_TEST_CASE(a_triangle_collapsed_to_an_edge_opens_nothing) {
    std::vector<TriangleIndices> collapsed = kTetrahedron;
    collapsed.push_back({0, 0, 1});
    collapsed.push_back({2, 2, 2});
    requireCounts(checkEdges(collapsed), 6, 0, 0, 0);
}

BOOST_AUTO_TEST_CASE(no_triangles_have_no_open_edges) {
    requireCounts(checkEdges({}), 0, 0, 0, 0);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
