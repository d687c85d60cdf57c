#define BOOST_TEST_MODULE all
#include "build/leaf/all.h"

#include <boost/test/unit_test.hpp>

#include "build/leaf/groups.h"

namespace clearway::testing {
namespace {

BOOST_AUTO_TEST_CASE(the_general_split_goes_on_to_single_triangles) {
    const CleanMesh mesh = meshOf({{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {5, 6, 7}, {6, 7, 8}});
    const std::vector<std::uint32_t> group = {0, 1, 2, 3, 4};
    for (const NamedGeneralSplit& general : kGeneralSplits) {
        const BinaryTree expected = general.build(mesh, group, 1);
        const Leaves leaves = leavesOf(splitIntoSingles(mesh, group, general.build));
        BOOST_TEST((leaves == leavesOf(expected)));
        BOOST_TEST(leaves.size() == 5u);
        for (const auto& leaf : leaves) BOOST_TEST(leaf.size() == 1u);
    }
}

}  // namespace
}  // namespace clearway::testing
