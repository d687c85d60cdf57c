// Tests that every library of this build answers as the oracle does where the bodies are far from just touching.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "bench/linked_rings.h"
#include "bench/peer.h"
#include "support/oracle.h"

BOOST_AUTO_TEST_SUITE(peers_test)

using namespace clearway;
using namespace clearway::testing;

/// Whether the bodies collide at the pose and 2 away from it in all directions of the axes, or at none of these.
bool isAwayFromContact(const MeshOracle& oracle, const Pose& pose) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double step : {-2.0, 2.0}) {
            Pose moved = pose;
            moved.translation[axis] += step;
            if (oracle.collides(moved) != oracle.collides(pose)) return false;
        }
    }
    return true;
}

BOOST_AUTO_TEST_CASE(every_peer_answers_as_the_oracle_away_from_contact) {
    constexpr unsigned kSeed = 5;
    const Mesh mesh = ring(800);
    const MeshOracle oracle(mesh, mesh);
    const std::vector<Peer> peers = makePeers(mesh, mesh);
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> shift(-15, 15);
    int colliding = 0, free = 0;
    for (Pose pose : linkedRingPoses(48)) {
        for (int axis = 0; axis < 3; ++axis) pose.translation[axis] += shift(random);
        if (!isAwayFromContact(oracle, pose)) continue;
        const double distance = oracle.distance(pose).distance;
        (distance == 0 ? colliding : free) += 1;
        for (const Peer& peer : peers) {
            BOOST_TEST_CONTEXT(peer.name << ", seed " << kSeed) {
                if (peer.collides) BOOST_TEST((peer.collides(pose).value != 0) == (distance == 0));
                if (peer.distance)
                    BOOST_TEST(std::abs(std::max(0.0, peer.distance(pose).value) - distance) < 1e-3);
            }
        }
    }
    BOOST_TEST(colliding >= 3);
    BOOST_TEST(free >= 3);
}

BOOST_AUTO_TEST_SUITE_END()
