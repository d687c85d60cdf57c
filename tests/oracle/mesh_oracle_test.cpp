// The oracle's tree agrees with trying all pairs of triangles, and with answers known from geometry.
#include <boost/test/unit_test.hpp>

#include "support/hard_triangles.h"
#include "support/oracle.h"
#include "support/random_meshes.h"

BOOST_AUTO_TEST_SUITE(mesh_oracle_test)

using namespace clearway;
using namespace clearway::testing;

BOOST_AUTO_TEST_CASE(tree_equals_brute_force) {
    for (const int triangles : {1, 2, 7, 60, 500}) {
        for (const double spread : {60.0, 400.0}) {  // touching, and mostly apart
            Random random(100 + triangles);
            const Mesh part = randomSoup(random, triangles, 50, 20);
            const Mesh environment = randomSoup(random, triangles, 100, 20);
            const MeshOracle oracle(part, environment);
            const int poses = triangles == 500 ? 2 : 6;
            for (int i = 0; i < poses; ++i) {
                const Pose pose = random.pose(spread);
                const OracleAnswer expected = bruteForceDistance(part, environment, pose);
                const OracleAnswer found = oracle.distance(pose);
                BOOST_TEST_CONTEXT(triangles << " triangles, spread " << spread << ", pose " << i) {
                    BOOST_TEST(found.distance == expected.distance);
                    BOOST_TEST(oracle.collides(pose) == (expected.distance == 0));
                    if (found.distance > 0) {
                        BOOST_TEST(oracle.pairDistance(pose, found.partTriangle, found.environmentTriangle) ==
                                       found.distance,
                                   boost::test_tools::tolerance(1e-12));
                    }
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(shuffling_the_triangles_changes_nothing) {
    Random random(5);
    for (const MeshPair& pair : meshPairs(5)) {
        const MeshOracle oracle(pair.part, pair.environment);
        const MeshOracle other(shuffled(random, pair.part), shuffled(random, pair.environment));
        for (int i = 0; i < 5; ++i) {
            const Pose pose = random.pose(150);
            BOOST_TEST_CONTEXT(pair.name << ", seed 5, pose " << i) {
                BOOST_TEST(oracle.distance(pose).distance == other.distance(pose).distance,
                           boost::test_tools::tolerance(1e-15));
                BOOST_TEST(oracle.collides(pose) == other.collides(pose));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(boxes_at_any_gap_have_the_box_distance) {
    const Mesh part = box({1, 2, 3}, 2);
    const MeshOracle oracle(part, box({4, 5, 6}, 3));
    for (const double gap : {0x1p-40, 0x1p-10, 0.5, 100.0}) {
        BOOST_TEST(oracle.distance(Pose{Matrix3::Identity(), {5 + gap, 0.3, 0.2}}).distance == gap);
        BOOST_TEST(
            oracle.distance(Pose{Matrix3::Identity(), {5 + 3 * gap, 7 + 4 * gap, 0}}).distance == 5 * gap,
            boost::test_tools::tolerance(1e-15));
        BOOST_TEST(!oracle.collides(Pose{Matrix3::Identity(), {5 + gap, 0.3, 0.2}}));
    }
    BOOST_TEST(oracle.collides(Pose{Matrix3::Identity(), {5, 0.3, 0.2}}));    // faces touch
    BOOST_TEST(oracle.collides(Pose{Matrix3::Identity(), {4.5, 0.3, 0.2}}));  // skins cross
    BOOST_TEST(oracle.distance(Pose{Matrix3::Identity(), {5, 0.3, 0.2}}).distance == 0.0);
    BOOST_TEST(oracle.distance(Pose{}).distance == 3.0);  // one hollow box inside the other
    BOOST_TEST(!oracle.collides(Pose{}));
}

BOOST_AUTO_TEST_CASE(the_pose_counts_as_it_is_rounded) {
    // 3 * 0.1 is not 0.3 in binary: a point moved by the pose's own doubles stays off the plane at 0.3.
    const Mesh point = meshOf({Vector3(3, 0.2, 0.2), Vector3(3, 0.2, 0.2), Vector3(3, 0.2, 0.2)});
    const Mesh wall = meshOf({Vector3(0.3, 0, 0), Vector3(0.3, 1, 0), Vector3(0.3, 0, 1)});
    Pose pose;
    pose.rotation(0, 0) = 0.1;
    const OracleAnswer answer = MeshOracle(point, wall).distance(pose);
    BOOST_TEST(answer.distance > 0.0);
    BOOST_TEST(answer.distance < 1e-16);
    BOOST_TEST(!MeshOracle(point, wall).collides(pose));
}

BOOST_AUTO_TEST_SUITE_END()
