#include "build/leaf_splits.h"

#include <boost/test/unit_test.hpp>

#include "build/leaf/groups.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(edge_test)

Leaves chains(const std::vector<TriangleIndices>& triangles) {
    return leavesOf(splitGroup(splitIntoEdgeChains, meshOf(triangles)));
}

BOOST_AUTO_TEST_CASE(one_shared_vertex_is_not_enough_an_edge_is) {
    BOOST_TEST((chains({{0, 1, 2}, {2, 3, 4}, {5, 6, 7}, {7, 6, 8}}) == Leaves{{0}, {1}, {2, 3}}));
    BOOST_TEST(
        (chains({{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {0, 7, 8}}) == Leaves{{0}, {1}, {2}, {3}}));  // by the tip
    BOOST_TEST(
        (chains({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) == Leaves{{0, 1, 2, 3}}));  // a closed fan
}

BOOST_AUTO_TEST_CASE(either_winding_shares_the_edge) {
    BOOST_TEST((chains({{0, 1, 2}, {1, 0, 3}}) == Leaves{{0, 1}}));
    BOOST_TEST((chains({{0, 1, 2}, {0, 1, 3}}) == Leaves{{0, 1}}));
}

BOOST_AUTO_TEST_CASE(a_chain_grows_from_any_of_its_links) {
    BOOST_TEST((chains({{0, 1, 2}, {3, 4, 5}, {1, 2, 3}, {2, 3, 4}}) == Leaves{{0, 2, 3, 1}}));
}

BOOST_AUTO_TEST_CASE(a_vertex_that_a_degenerate_triangle_repeats_counts_once) {
    BOOST_TEST((chains({{0, 0, 1}, {0, 2, 3}}) == Leaves{{0}, {1}}));
    BOOST_TEST((chains({{0, 0, 1}, {0, 1, 3}}) == Leaves{{0, 1}}));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
