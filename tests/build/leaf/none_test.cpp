#include "build/leaf_splits.h"

#include <boost/test/unit_test.hpp>

#include "build/leaf/groups.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(none_test)

BOOST_AUTO_TEST_CASE(the_group_stays_one_leaf_whatever_its_triangles_share) {
    const CleanMesh mesh = meshOf({{0, 1, 2}, {3, 4, 5}, {1, 2, 6}});
    BinaryTree tree = buildByMeanSplit(mesh, {0, 1, 2}, 3);
    keepTogether(tree, mesh, buildByMeanSplit);
    BOOST_TEST((leavesOf(tree) == Leaves{{0, 1, 2}}));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
