// Every peer of this build answers two spheres that are clearly apart, and clearly in contact, as it should.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "bench/peer.h"
#include "support/random_meshes.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(peers_test)

BOOST_AUTO_TEST_CASE(each_peer_answers_two_spheres_apart_and_in_contact) {
    const Mesh part = sphere(1, 12), environment = sphere(2, 16);
    const std::vector<Peer> peers = makePeers(part, environment);
    BOOST_TEST(peers.size() >= 3u);
    for (const Peer& peer : peers) {
        for (int i = 0; i < 24; ++i) {
            const double angle = 0.7 * i,
                         between = i % 2 == 0 ? 2.5 : 3.5;  // of the centres; contact ends at 3
            const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()));
            const Pose pose = toPose(turn, between * Vector3(std::cos(angle), std::sin(angle), 0));
            BOOST_TEST_CONTEXT(peer.name << ", pose " << i) {
                if (peer.collides) BOOST_TEST(peer.collides(pose).value == (between < 3 ? 1 : 0));
                if (peer.isWithin) BOOST_TEST(peer.isWithin(pose, 0.1).value == (between < 3 ? 1 : 0));
                if (peer.isWithin) BOOST_TEST(peer.isWithin(pose, 1.0).value == 1);
                if (peer.distance && between < 3) BOOST_TEST(peer.distance(pose).value <= 0);
                // A faceted sphere lies within its sphere.
                if (peer.distance && between > 3) BOOST_TEST(peer.distance(pose).value >= 0.5 - 1e-9);
                if (peer.distance && between > 3) BOOST_TEST(peer.distance(pose).value <= 0.8);
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
