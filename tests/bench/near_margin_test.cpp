#include "bench/near_margin.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(near_margin_test)

using namespace clearway;
using namespace clearway::testing;

BOOST_DATA_TEST_CASE(poses_lie_on_both_sides_of_the_margin_at_every_nearness,
                     boost::unit_test::data::make({0.0, 1e-6, 1e-3}), share) {
    constexpr std::uint64_t kSeed = 3;
    constexpr int kBases = 2;
    const BenchScene& scene = benchSceneNamed("N");
    const BenchTask task = makeTask(scene, scene.small, 12, kSeed);
    const TreePair trees = buildTrees(task, BuildOptions{});
    const MeshOracle oracle(task.part, task.environment);
    std::vector<Truth> truths;
    for (const Pose& pose : task.poses) truths.push_back(askOracle(oracle, task, pose));
    const double margin = share * task.sceneSize();
    const PosesNearMargin near = posesNearMargin(task, trees, oracle, truths, margin, kBases);

    BOOST_TEST_REQUIRE(near.isValid.size() == near.poses.size());
    const int targets = share > 0 ? 9 : 13;
    BOOST_TEST(int(near.poses.size()) + near.undecided == kBases * targets + int(task.poses.size()));
    const double unit = share > 0 ? margin : task.sceneSize();
    std::vector<double> distances;
    for (std::size_t i = 0; i < near.poses.size(); ++i) {
        distances.push_back(oracle.distance(near.poses[i]).distance);
        BOOST_TEST(near.isValid[i] == (distances[i] > margin), "seed " << kSeed << ", pose " << i);
    }
    for (const double e :
         {1e-4, 1e-8, 1e-11}) {  // on either side, some poses are nearer to the margin than this
        int valid = 0, invalid = 0;
        for (std::size_t i = 0; i < near.poses.size(); ++i) {
            const double distance = distances[i];
            const bool isNear = share > 0 ? std::abs(distance - margin) <= e * unit : distance <= e * unit;
            (near.isValid[i] ? valid : invalid) += isNear;
        }
        BOOST_TEST(valid > 0);
        BOOST_TEST(invalid > 0);
    }
}

BOOST_AUTO_TEST_SUITE_END()
