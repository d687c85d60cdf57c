// How far a part must be moved along a line to come free and stay free.
#include <boost/test/unit_test.hpp>

#include "clearway/scene_clearance.h"
#include "model/solids.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(escape_test)

Scene sceneOf(const Mesh& part, const std::vector<Mesh>& obstacles, double margin = 0) {
    Scene scene(Model::build(part));
    for (const Mesh& mesh : obstacles) scene.obstacles.emplace_back(Model::build(mesh), margin);
    return scene;
}

/// A block of 4 sits 0.03 deep in a floor of 12 that is 2 thick.
BOOST_AUTO_TEST_CASE(a_sunk_block_escapes_upwards_least) {
    const Mesh floor = translated(box({6, 6, 1}), {0, 0, -1});
    Pose X;
    X.translation.z() = 1.97;
    for (const double margin : {0.0, 0.5}) {
        const SceneClearance clearance(sceneOf(box({2, 2, 2}), {floor}, margin));
        for (const auto& [direction, length] : {std::pair(Vector3(0, 0, 1), 0.03),
                                                {Vector3(0, 0, -7), 5.97},
                                                {Vector3(1, 0, 0), 8.0},
                                                {Vector3(0, -1, 0), 8.0}}) {
            const EscapeDistance found = clearance.escapeDistance(X, direction);
            BOOST_TEST(found.lower <= length + margin + 1e-12);
            BOOST_TEST(found.upper >= length + margin - 1e-12);
            BOOST_TEST(found.upper - found.lower < 1e-3);
        }
        X.translation.z() = 3;
        BOOST_TEST(clearance.escapeDistance(X, {0, 0, 1}).upper == 0);
        BOOST_TEST(clearance.escapeDistance(X, {0, 0, -1}).upper > 6);
        X.translation.z() = 1.97;
        BOOST_CHECK_THROW(clearance.escapeDistance(X, Vector3::Zero()), std::invalid_argument);
        BOOST_CHECK_THROW(clearance.escapeDistance(X, {0, NAN, 1}), std::invalid_argument);
    }
    BOOST_TEST(SceneClearance(sceneOf(box({2, 2, 2}), {})).escapeDistance(X, {1, 0, 0}).upper == 0);
}

BOOST_AUTO_TEST_CASE(odd_questions_have_answers) {
    // Along a face that it nearly touches, the part comes free where the face ends, and soon.
    const Mesh floor = translated(box({20, 20, 1}, 10), {0, 0, -2 - 1e-10});
    const SceneClearance sliding(sceneOf(sphere(1, 20), {floor}));
    const EscapeDistance along = sliding.escapeDistance({}, {1, 0.3, 0});
    BOOST_TEST(along.lower == 0);
    BOOST_TEST(along.upper > 19);
    BOOST_TEST(along.upper < 23);
    BOOST_TEST(sliding.escapeDistance({}, {0, 0, 1e300}).upper < 1e-3);

    Mesh point = box({1, 1, 1});
    for (Vector3& vertex : point.vertices) vertex.setZero();
    const SceneClearance points(sceneOf(point, {point}, 0.1));
    Pose X;
    X.translation.x() = -2;
    BOOST_TEST(points.escapeDistance(X, {1, 1, 0}).upper == 0);
    BOOST_TEST(points.escapeDistance(X, {1, 0, 0}).upper == 2.1, boost::test_tools::tolerance(1e-3));
    BOOST_CHECK_THROW(SceneClearance(sceneOf(point, {point})).escapeDistance({}, {1, 0, 0}),
                      std::invalid_argument);

    X.translation.x() = 1e17;
    const SceneClearance far(sceneOf(box({1, 1, 1}), {translated(box({1, 1, 1}), {1e17, 0, 0})}));
    const EscapeDistance found = far.escapeDistance(X, {1, 0, 0});
    X.translation.x() += found.upper;
    BOOST_TEST(found.upper >= 2);
    BOOST_TEST(far.isFree(X));

    const SceneClearance clearance(sceneOf(box({1, 1, 1}), {}));
    for (const double band : {-0.3, double(NAN)})
        BOOST_CHECK_THROW(clearance.nearPairs({}, band), std::invalid_argument);
}

/// Every pose beyond `upper` is free, and the pose at `lower` is not.
BOOST_AUTO_TEST_CASE(poses_beyond_the_escape_distance_are_free) {
    Random random(6);
    const Mesh part = torus(1, 0.3, 8);
    int blocked = 0;
    for (int n = 0; n < 30; ++n) {
        std::vector<Mesh> obstacles;
        for (int k = 0; k < 4; ++k) obstacles.push_back(transformed(box({0.8, 0.5, 0.3}), random.pose(2)));
        Scene scene = sceneOf(part, obstacles, n % 2 == 0 ? 0 : 0.05);
        if (n % 3 == 0) {
            scene.partSolids = makeSolids(part).solids;
            for (std::size_t k = 0; k < obstacles.size(); ++k)
                scene.obstacles[k].solids = makeSolids(obstacles[k]).solids;
        }
        const SceneClearance clearance(scene);
        const Pose X = random.pose(1);
        const Vector3 direction = random.direction();
        const EscapeDistance found = clearance.escapeDistance(X, direction);
        BOOST_REQUIRE(found.lower <= found.upper);
        const auto at = [&](double length) {
            Pose moved = X;
            moved.translation += length * direction;
            return clearance.isFree(moved);
        };
        for (int k = 0; k < 200; ++k) BOOST_REQUIRE(at(found.upper * (1 + 1e-9) + 1e-9 + 0.03 * k));
        if (found.lower == 0) continue;
        ++blocked;
        BOOST_TEST(!at(found.lower));
        BOOST_TEST(found.upper - found.lower < 1e-3);
    }
    BOOST_TEST(blocked > 10);
}

BOOST_AUTO_TEST_CASE(near_pairs_of_a_scene_come_by_clearance) {
    Scene scene = sceneOf(box({1, 1, 1}),
                          {translated(box({1, 1, 1}), {3, 0, 0}), translated(box({1, 1, 1}), {-3.2, 0, 0})});
    scene.obstacles[1].margin = 0.5;
    const SceneClearance clearance(scene);
    const std::vector<SceneDistance> near = clearance.nearPairs({}, 1.1);
    BOOST_REQUIRE(near.size() > 2);
    BOOST_TEST(*near[0].obstacle == 1);  // 1.2 away, less the margin
    BOOST_TEST(near[0].distance == 1.2, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(near.front().distance > near.back().distance);
    bool isFirstThere = false;
    for (const SceneDistance& each : near) isFirstThere = isFirstThere || *each.obstacle == 0;
    BOOST_TEST(isFirstThere);
    BOOST_TEST(clearance.nearPairs({}, 0.6).empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
