// Screws: poses along them, and what their pieces promise to sweeps.
#include "planning/improve/screw.h"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/each_target.h"
#include "support/oracle.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(screw_test)

using testing::Random;

Vector3 drawnVector(Random& random, double size) {
    return Vector3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
}

Screw drawnScrew(Random& random, double angle) {
    return {drawnVector(random, 1).normalized() * angle, drawnVector(random, 5)};
}

double apart(const Pose& a, const Pose& b) {
    return (a.rotation - b.rotation).norm() + (a.translation - b.translation).norm();
}

BOOST_AUTO_TEST_CASE(times_along_a_screw_add_up_and_its_poses_are_rigid) {
    Random random(1);
    for (const double angle : {0.0, 1e-9, 1e-4, 0.049, 0.051, 1.0, 3.0, 40.0}) {
        const Screw screw = drawnScrew(random, angle);
        const Pose from = random.pose(3);
        const Pose whole = movedAlong(screw, from, 0.7);
        BOOST_TEST(rotationDefect(whole) < 1e-12);
        BOOST_TEST(apart(movedAlong(screw, movedAlong(screw, from, 0.3), 0.4), whole) <
                   1e-12 * (1 + angle) * 50);
        BOOST_TEST(apart(movedAlong(screw, whole, -0.7), from) < 1e-12 * (1 + angle) * 50);
    }
}

BOOST_AUTO_TEST_CASE(velocities_are_the_derivatives_of_the_poses) {
    Random random(2);
    const Model part = Model::build(testing::box(Vector3(1, 2, 3)));
    constexpr double kStep = 1e-6;
    for (int k = 0; k < 50; ++k) {
        const Screw screw = drawnScrew(random, random.uniform(0, 4));
        const Pose from = random.pose(3);
        const MotionPiece piece = motionAlong(screw, from, part).pieces(0.2, 0.6);
        BOOST_TEST(apart(piece.middle, movedAlong(screw, from, 0.4)) < 1e-12);
        const Vector3 difference = (movedAlong(screw, from, 0.4 + kStep).translation -
                                    movedAlong(screw, from, 0.4 - kStep).translation) /
                                   (2 * kStep);
        BOOST_TEST((difference - piece.velocity).norm() < 1e-6);
    }
}

/// No point is farther from its line than the piece says, and none moves further than the length.
BOOST_AUTO_TEST_CASE(points_keep_within_the_deviation_and_the_length) {
    Random random(3);
    const Box box(Vector3(-1, -2, -3), Vector3(4, 2, 3));
    const Model part = Model::build(boxMesh(box));
    for (int k = 0; k < 200; ++k) {
        const Screw screw = drawnScrew(random, random.uniform(0, 3));
        const Pose from = random.pose(10);
        const PartMotion motion = motionAlong(screw, from, part);
        const double middle = 0.5, half = random.uniform(0.01, 0.5), share = random.uniform(-1, 1);
        const MotionPiece piece = motion.pieces(middle - half, middle + half);
        const Pose to = movedAlong(screw, from, middle + share * half);
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3 point = box.corner(Box::CornerType(corner));
            const Vector3 at = piece.middle * point;
            const Vector3 velocity =
                piece.velocity + piece.angularVelocity.cross(at - piece.middle.translation);
            const double off = (to * point - (at + share * half * velocity)).norm();
            BOOST_TEST(off <=
                       std::abs(share) * (piece.deviation + piece.deviationAcrossRotation) * (1 + 1e-9) +
                           1e-12);
            BOOST_TEST((to * point - from * point).norm() <=
                       (middle + share * half) * motion.length * (1 + 1e-9) + 1e-12);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_screw_between_two_poses_joins_them) {
    Random random(4);
    for (int k = 0; k < 200; ++k) {
        const Pose from = random.pose(5);
        const Pose to = k % 4 == 0 ? movedAlong(drawnScrew(random, 1e-7), from, 1) : random.pose(5);
        BOOST_TEST(apart(movedAlong(screwBetween(from, to), from, 1), to) < 1e-7);
    }
}

/// The sweep of a screw agrees with the oracle at poses along it, on every instruction set.
BOOST_DATA_TEST_CASE(sweeps_along_screws_agree_with_the_oracle, testing::eachTarget(), target) {
    const testing::UsingTarget use(target);
    constexpr int kPoses = 16;
    Random random(5);
    Workspace workspace;
    int certified = 0, contacts = 0;
    for (const testing::MeshPair& pair : testing::meshPairs(1)) {
        if (pair.part.triangles.size() * pair.environment.triangles.size() > 400000) continue;
        const Model part = Model::build(pair.part), environment = Model::build(pair.environment);
        const testing::MeshOracle oracle(pair.part, pair.environment);
        for (int n = 0; n < 6; ++n) {
            Pose from = random.pose(0.3 * oracle.sceneSize());
            const Screw screw{random.direction() * random.uniform(0.1, 3),
                              random.direction() * oracle.sceneSize() * 0.4};
            const PartMotion motion = motionAlong(screw, from, part);
            SweepOptions options;
            options.margin = 0.01 * n * oracle.sceneSize();
            options.leastInterval = 1e-6 * oracle.sceneSize();
            const SweepResult found = sweep(part, environment, motion.pieces, options, workspace);
            const auto distanceAt = [&](double time) {
                return oracle.distance(movedAlong(screw, from, time)).distance;
            };
            if (found.verdict == SweepVerdict::kContact) {
                ++contacts;
                BOOST_TEST(distanceAt(*found.contactTime) <=
                           options.margin * (1 + 1e-9) + 1e-12 * oracle.sceneSize());
            } else if (found.verdict == SweepVerdict::kCertified) {
                ++certified;
                for (int k = 0; k <= kPoses; ++k)
                    BOOST_REQUIRE(distanceAt(double(k) / kPoses) > options.margin);
            }
        }
    }
    BOOST_TEST(certified > 5);
    BOOST_TEST(contacts > 5);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
