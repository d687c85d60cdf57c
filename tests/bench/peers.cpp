#include "bench/peer.h"

namespace clearway::testing {

std::vector<Peer> makePeers(const Mesh& part, const Mesh& environment) {
    std::vector<Peer> peers{makeFclRss(part, environment), makeFclObbRss(part, environment)};
#ifdef CLEARWAY_BENCH_WITH_PQP
    peers.push_back(makePqp(part, environment));
#endif
#ifdef CLEARWAY_BENCH_WITH_COAL
    peers.push_back(makeCoal(part, environment));
#endif
#ifdef CLEARWAY_BENCH_WITH_BULLET
    peers.push_back(makeBullet(part, environment));
#endif
    peers.push_back(makeCgal(part, environment));
#ifdef CLEARWAY_BENCH_WITH_MESHLIB
    peers.push_back(makeMeshLib(part, environment));
#endif
    return peers;
}

}  // namespace clearway::testing
