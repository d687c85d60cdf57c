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
