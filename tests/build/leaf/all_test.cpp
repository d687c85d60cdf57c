#include "build/leaf_splits.h"

#include <boost/test/unit_test.hpp>

#include "build/leaf/groups.h"
#include "support/processor_time.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(all_test)

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

/// Guards against looking at the whole mesh for each group, which took 80 s for 300,000 triangles.
BOOST_AUTO_TEST_CASE(a_group_costs_no_more_in_a_large_mesh_than_in_a_small_one) {
    std::vector<TriangleIndices> triangles;
    for (std::uint32_t i = 0; i < 300000; ++i) triangles.push_back({i % 60, i % 60 + 1, i % 60 + 2});
    const CleanMesh large = meshOf(triangles);
    triangles.resize(4);
    const CleanMesh small = meshOf(triangles);
    const auto secondsOf = [](const CleanMesh& mesh, GeneralSplit general) {
        return processorSecondsOf([&] {
            for (int i = 0; i < 500; ++i) splitIntoSingles(mesh, {0, 1, 2, 3}, general);
        });
    };
    for (const NamedGeneralSplit& general : kGeneralSplits) {
        const double inSmall = secondsOf(small, general.build), inLarge = secondsOf(large, general.build);
        BOOST_TEST(inLarge < 10 * inSmall + 0.1,
                   general.name << ": " << inLarge << " s, " << inSmall << " s");
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
