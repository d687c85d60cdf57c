#include "bench/peer.h"

namespace clearway::testing {

std::vector<NamedPeer> distancePeers() {
    return {
        {"FCL RSS", makeFclRss},
#ifdef CLEARWAY_BENCH_WITH_PQP
        {"PQP", makePqp},
#endif
#ifdef CLEARWAY_BENCH_WITH_COAL
        {"Coal OBBRSS", makeCoal},
#endif
    };
}

std::vector<Peer> makePeers(const Mesh& part, const Mesh& environment) {
    std::vector<Peer> peers;
    for (const NamedPeer& peer : distancePeers()) peers.push_back(peer.make(part, environment));
    peers.insert(peers.begin() + 1, makeFclObbRss(part, environment));
#ifdef CLEARWAY_BENCH_WITH_BULLET
    peers.push_back(makeBullet(part, environment));
#endif
    peers.push_back(makeCgal(part, environment));
    return peers;
}

}  // namespace clearway::testing
