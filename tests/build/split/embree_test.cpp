#include "build/general_splits.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <boost/test/unit_test.hpp>
#include <thread>

#include "build/sample_meshes.h"
#include "build/split/children.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(embree_test)

BOOST_AUTO_TEST_CASE(two_clusters_are_parted) {
    std::vector<Corners> triangles = soup(40, 31);
    const std::vector<Corners> others = transformed(soup(60, 32), 1, {5, 0, 0});
    triangles.insert(triangles.end(), others.begin(), others.end());
    TriangleSet first, second;
    for (std::uint32_t i = 0; i < 100; ++i) (i < 40 ? first : second).insert(i);
    BOOST_TEST((rootChildren(buildByEmbree, cleanMeshOf(triangles)) == std::make_pair(first, second)));
}

BOOST_AUTO_TEST_CASE(other_work_keeps_its_threads) {
    using Control = tbb::global_control;
    rootChildren(buildByEmbree, cleanMeshOf(soup(100, 33)));
    BOOST_TEST(Control::active_value(Control::max_allowed_parallelism) ==
               std::size_t(tbb::info::default_concurrency()));
}

BOOST_AUTO_TEST_CASE(two_threads_may_build_at_once) {
    const CleanMesh mesh = cleanMeshOf(soup(5000, 34));
    const auto alone = rootChildren(buildByEmbree, mesh);
    std::pair<TriangleSet, TriangleSet> there, here;
    std::thread other([&] { there = rootChildren(buildByEmbree, mesh); });
    here = rootChildren(buildByEmbree, mesh);
    other.join();
    BOOST_TEST((here == alone));
    BOOST_TEST((there == alone));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
