#include "bench/pose_sets.h"

#include <algorithm>
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "bench/bench_scenes.h"
#include "support/full_run.h"
#include "support/oracle.h"

BOOST_AUTO_TEST_SUITE(pose_sets_test)

using namespace clearway;
using namespace clearway::testing;

const int kPoses = inForm(100, 40);
constexpr std::uint64_t kSeed = 7;

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const BenchScene& scene : benchScenes()) names.push_back(scene.name);
    return names;
}

BenchTask smallTask(const std::string& name, std::uint64_t seed = kSeed) {
    const BenchScene& scene = benchSceneNamed(name);
    return makeTask(scene, scene.small, kPoses, seed);
}

bool areEqual(const Pose& a, const Pose& b) {
    return a.rotation == b.rotation && a.translation == b.translation;
}

BOOST_DATA_TEST_CASE(poses_collide_or_are_free_as_promised_by_the_oracle,
                     boost::unit_test::data::make(sceneNames()), name) {
    const BenchScene& scene = benchSceneNamed(name);
    const BenchTask task = smallTask(name);
    BOOST_TEST_CONTEXT("seed " << kSeed) {
        BOOST_TEST(task.poses.size() == kPoses);
        const MeshOracle oracle(task.part, task.environment);
        int touching = 0;
        for (const Pose& pose : task.poses) {
            if (scene.collidingShare > 0) {
                touching += oracle.collides(pose);
                continue;
            }
            const double clearance = oracle.distance(pose).distance / task.partSize();
            BOOST_TEST(clearance >= scene.leastFree * (1 - 1e-9));
            BOOST_TEST(clearance <= scene.mostFree * (1 + 1e-9));
        }
        BOOST_TEST(std::abs(touching / double(kPoses) - scene.collidingShare) <= 0.02);
    }
}

BOOST_DATA_TEST_CASE(consecutive_poses_are_near_each_other_and_shuffled_ones_are_not,
                     boost::unit_test::data::make(sceneNames()), name) {
    const BenchTask task = smallTask(name);
    const Box box = boundingBox(task.part);
    std::vector<double> steps = stepsBetween(task.poses, box);
    std::sort(steps.begin(), steps.end());
    std::vector<Pose> shuffled;
    for (const std::size_t i : shuffledOrder(task.poses.size(), kSeed)) shuffled.push_back(task.poses[i]);
    std::vector<double> leaps = stepsBetween(shuffled, box);
    std::sort(leaps.begin(), leaps.end());
    BOOST_TEST(4 * steps[steps.size() / 2] < leaps[leaps.size() / 2]);
}

BOOST_AUTO_TEST_CASE(a_share_between_two_numbers_of_poses_is_reached_by_either) {
    const BenchScene& scene = benchSceneNamed("K");
    for (const int count : {2, 10, 30}) {  // 75 % of them is no whole number
        BOOST_TEST(makeTask(scene, scene.small, count, kSeed).poses.size() == std::size_t(count));
    }
}

BOOST_AUTO_TEST_CASE(the_seed_decides_which_poses) {
    for (const char* name : {"K", "L"}) {
        const std::vector<Pose> once = smallTask(name).poses, again = smallTask(name).poses,
                                others = smallTask(name, kSeed + 1).poses;
        BOOST_TEST(std::equal(once.begin(), once.end(), again.begin(), again.end(), areEqual));
        BOOST_TEST(!std::equal(once.begin(), once.end(), others.begin(), others.end(), areEqual));
    }
}

BOOST_AUTO_TEST_CASE(a_shuffled_order_holds_every_pose_once) {
    std::vector<std::size_t> order = shuffledOrder(1000, kSeed);
    BOOST_TEST(!std::is_sorted(order.begin(), order.end()));
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) BOOST_TEST(order[i] == i);
}

BOOST_AUTO_TEST_SUITE_END()
