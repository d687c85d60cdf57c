#include "build/general_splits.h"

#include <boost/test/unit_test.hpp>

#include "build/sample_meshes.h"
#include "build/split/children.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(mean_test)

Corners smallAt(const Vector3& at) {
    return {at, at + Vector3(0.1, 0, 0), at + Vector3(0, 0.1, 0)};
}

BOOST_AUTO_TEST_CASE(the_plane_goes_through_the_mean_not_the_middle_nor_the_median) {
    // Centroids at 0, 1, 2, 3 and 10 along x: mean 3.2, middle 5, median 2.
    const CleanMesh mesh = cleanMeshOf({smallAt({0, 0, 0}), smallAt({1, 0, 0}), smallAt({2, 0, 0}),
                                        smallAt({3, 0, 0}), smallAt({10, 0, 0})});
    BOOST_TEST(
        (rootChildren(buildByMeanSplit, mesh) == std::make_pair(TriangleSet{0, 1, 2, 3}, TriangleSet{4})));
    // And at 0, 4, 5, 6, 7, 8: mean 5, median 5.5, middle 4. A centroid on the plane counts to one side.
    const CleanMesh other = cleanMeshOf({smallAt({0, 0, 0}), smallAt({4, 0, 0}), smallAt({5.5, 0, 0}),
                                         smallAt({6, 0, 0}), smallAt({7, 0, 0}), smallAt({8, 0, 0})});
    BOOST_TEST((rootChildren(buildByMeanSplit, other) ==
                std::make_pair(TriangleSet{0, 1}, TriangleSet{2, 3, 4, 5})));
}

BOOST_AUTO_TEST_CASE(the_normal_is_the_direction_of_greatest_spread) {
    constexpr std::uint64_t kSeed = 31;
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        Random random(kSeed);
        for (int round = 0; round < 20; ++round) {
            const Matrix3 axes = random.rotation();
            std::vector<Corners> triangles;
            TriangleSet low;
            TriangleSet high;
            for (int i = 0; i < 60; ++i) {
                // Far apart along the first axis; as near as half that along the others.
                const double x = i % 2 ? random.uniform(6, 8) : random.uniform(-8, -6);
                (i % 2 ? high : low).insert(static_cast<std::uint32_t>(i));
                triangles.push_back(smallAt(axes * Vector3(x, random.uniform(-3, 3), random.uniform(-3, 3))));
            }
            BOOST_TEST((rootChildren(buildByMeanSplit, cleanMeshOf(triangles)) == std::make_pair(low, high)));
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
