#include "clearway/batch.h"

#include <tbb/task_arena.h>

#include <boost/test/unit_test.hpp>
#include <cstring>

#include "clearway/model.h"
#include "support/random_meshes.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(batch_test)

using testing::Random;

struct Fixture {
    Random random{11};
    Model part = Model::build(testing::torus(3, 1, 10));
    Model environment = Model::build(testing::randomTerrain(random, 16, 20, 1));
    std::vector<Pose> poses;
    Fixture() {
        for (int i = 0; i < 3 * int(kBatchBlock) + 5; ++i) poses.push_back(random.pose(6));
    }
};

bool isSame(const DistanceResult& a, const DistanceResult& b) {
    return a.lower == b.lower && a.upper == b.upper && a.distance == b.distance &&
           a.witness->pointOnPart == b.witness->pointOnPart &&
           a.witness->partTriangle == b.witness->partTriangle &&
           a.witness->environmentTriangle == b.witness->environmentTriangle &&
           a.counters.volumeTests == b.counters.volumeTests;
}

BOOST_FIXTURE_TEST_CASE(results_do_not_depend_on_the_number_of_threads, Fixture) {
    tbb::task_arena one(1), four(4);
    std::vector<DistanceResult> alone, shared;
    one.execute([&] { alone = distanceBatch(part, environment, poses); });
    four.execute([&] { shared = distanceBatch(part, environment, poses); });
    BOOST_REQUIRE_EQUAL(alone.size(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) BOOST_TEST(isSame(alone[i], shared[i]), "pose " << i);
}

BOOST_FIXTURE_TEST_CASE(a_batch_answers_as_single_queries_do, Fixture) {
    const double d = 0.5;
    const auto distances = distanceBatch(part, environment, poses);
    const auto within = isWithinBatch(part, environment, poses, d);
    Workspace workspace;
    int near = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (i % kBatchBlock == 0) workspace.forgetWarmStart();
        BOOST_TEST(isSame(distances[i], distance(part, environment, poses[i], {}, workspace)), "pose " << i);
        BOOST_TEST(bool(within[i]) == (distances[i].distance <= d), "pose " << i);
        near += within[i];
    }
    BOOST_TEST(near > 0);
    BOOST_TEST(near < int(poses.size()));
}

BOOST_FIXTURE_TEST_CASE(a_bad_pose_or_option_is_refused, Fixture) {
    BOOST_TEST(distanceBatch(part, environment, {}).empty());
    BOOST_CHECK_THROW(isWithinBatch(part, environment, poses, -1), std::invalid_argument);
    poses[7].rotation(0, 0) = 2;
    BOOST_CHECK_THROW(distanceBatch(part, environment, poses), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
