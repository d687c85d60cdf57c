// Lists of poses among a scene's obstacles.
#include <tbb/task_arena.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "clearway/batch.h"
#include "clearway/scene_clearance.h"
#include "support/words.h"

BOOST_AUTO_TEST_SUITE(scene_batch_test)

using namespace clearway;

Model cube(double half) {
    return Model::build(boxMesh({Vector3::Constant(-half), Vector3::Constant(half)}));
}

std::vector<Pose> around() {
    std::vector<Pose> poses;
    for (int i = 0; i < 3 * int(kBatchBlock) + 5; ++i) {
        const double angle = 0.1 * i;
        poses.push_back({Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(),
                         Vector3(3 * std::cos(angle), 2 * std::sin(0.7 * angle), 0.01 * i)});
    }
    return poses;
}

BOOST_AUTO_TEST_CASE(batches_answer_as_single_questions_on_any_number_of_threads) {
    const SceneClearance scene(Scene(cube(0.5), cube(1), 0.25));
    const std::vector<Pose> poses = around();
    tbb::task_arena one(1), four(4);
    std::vector<double> alone, shared;
    one.execute([&] { alone = scene.clearanceBatch(poses); });
    four.execute([&] { shared = scene.clearanceBatch(poses); });
    BOOST_TEST((alone == shared));
    const std::vector<std::uint8_t> flags = scene.isFreeBatch(poses);
    BOOST_REQUIRE_EQUAL(flags.size(), poses.size());
    int free = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        BOOST_TEST(bool(flags[i]) == scene.isFree(poses[i]), "pose " << i);
        BOOST_TEST(bool(flags[i]) == (alone[i] > 0), "pose " << i);
        free += flags[i];
    }
    BOOST_TEST(free > 0);
    BOOST_TEST(free < int(poses.size()));
    BOOST_TEST(scene.isFreeBatch({}).empty());
}

BOOST_AUTO_TEST_CASE(the_first_pose_that_is_refused_is_the_error) {
    const Model part = cube(0.5);
    const QueryRange range{Box(Vector3::Constant(-5), Vector3::Constant(5)), part.radiusAboutOrigin(), 20};
    const auto far = boxMesh({Vector3(1000, 0, 0), Vector3(1001, 1, 1)});
    const SceneClearance scene(Scene(part, Model::build(far, {}, range)));
    std::vector<Pose> poses = around();
    poses[7].translation.x() = 6;
    testing::requireRefusedBy([&] { scene.isFreeBatch(poses); }, {"range"});
    poses[3].rotation *= 2;
    testing::requireRefusedBy([&] { scene.clearanceBatch(poses); }, {"rotation"});
}

BOOST_AUTO_TEST_SUITE_END()
