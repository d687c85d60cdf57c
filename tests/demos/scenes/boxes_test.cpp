#include "demos/scenes/scenes.h"

#include <boost/test/unit_test.hpp>

#include "demos/scenes/scene_checks.h"
#include "support/oracle.h"

BOOST_AUTO_TEST_SUITE(boxes_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

/// The number of pairs of triangles that are as near as the nearest pair.
int tiesAt(const GeneratedScene& scene, const PartState& state, double nearest) {
    const MeshOracle oracle(scene.part, scene.environment);
    int ties = 0;
    for (std::size_t i = 0; i < scene.part.triangles.size(); ++i) {
        for (std::size_t j = 0; j < scene.environment.triangles.size(); ++j) {
            ties += oracle.pairDistance(poseOf(state), i, j) <= nearest * (1 + 1e-9);
        }
    }
    return ties;
}

/// The path is free along its whole length, and every step keeps the clearance. By the oracle, the distance
/// in the corner is the gap itself.
BOOST_AUTO_TEST_CASE(the_path_keeps_the_clearance_and_its_faces_parallel) {
    for (const double clearance : {0.01, 2.0, 20.0}) {
        const GeneratedScene scene = makeBoxes({3, 100, 700, clearance});
        for (const PartState& state : scene.path) BOOST_TEST((poseOf(state).rotation == Matrix3::Identity()));
        const PathClearance walk = walkPath(scene, 0.5 * clearance, 1.02 * clearance, 5);
        BOOST_TEST(walk.proven);
        BOOST_TEST(walk.least >= clearance);
        BOOST_TEST(walk.tightLength > 0.5 * walk.length);
        const MeshOracle oracle(scene.part, scene.environment);
        for (std::size_t i = 0; i + 1 < scene.path.size(); ++i) {
            for (const double t : {0.0, 0.3, 0.7}) {
                const PartState state = between(scene.path[i], scene.path[i + 1], t);
                const double distance = oracle.distance(poseOf(state)).distance;
                BOOST_TEST(distance >= clearance);
                if (i + 2 < scene.path.size()) BOOST_TEST(distance < 1.011 * clearance);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(many_pairs_of_triangles_are_equally_near) {
    const GeneratedScene scene = makeBoxes(kBoxes);
    const PartState state = between(scene.path[0], scene.path[1], 0.4);
    const double nearest = MeshOracle(scene.part, scene.environment).distance(poseOf(state)).distance;
    BOOST_TEST(tiesAt(scene, state, nearest) >= 50);
}

BOOST_AUTO_TEST_SUITE_END()
