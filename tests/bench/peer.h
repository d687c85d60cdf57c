// The libraries that clearway is measured against, each behind one set of functions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/query.h"

namespace clearway::testing {

/// The answer of one query, and its work if the library counts it.
struct Answer {
    double value = 0;  ///< a distance (0 or less for contact), or 1 for yes and 0 for no
    double lower = 0;  ///< clearway's interval, if it answered with a distance
    double upper = 0;
    QueryCounters counters;
};

/// A library with its own trees of the two meshes. A function is empty if the library has no such query.
/// Copies share the trees.
struct Peer {
    std::string name;
    double buildSeconds = 0;
    std::size_t bytes = 0;  ///< of both trees, as the library counts them; 0: not counted
    std::function<Answer(const Pose& X_environmentPart)>
        distance;  ///< exact, without nearest points if possible
    std::function<Answer(const Pose& X_environmentPart)> collides;  ///< ends at the first contact
    std::function<Answer(const Pose& X_environmentPart, double d)> isWithin;
    std::function<void()> forgetWarmStart;  ///< empty for a library that keeps nothing between queries
};

/// FCL 0.7's RSS trees, for distances. Debian's library holds explicit instantiations of the templates used
/// here. So the traversal timed is Debian's own -O2 code; clearway's flags compile only the headers' inline
/// code.
Peer makeFclRss(const Mesh& part, const Mesh& environment);

/// FCL 0.7's OBBRSS trees, for collisions; also Debian's code.
Peer makeFclObbRss(const Mesh& part, const Mesh& environment);

/// PQP 1.3, if the build was given a checkout (CLEARWAY_BENCH_PQP). Its warm start is the models' last
/// closest pair of triangles.
Peer makePqp(const Mesh& part, const Mesh& environment);

/// Coal's OBBRSS trees, if the build was given Coal's prefix (CLEARWAY_BENCH_COAL).
Peer makeCoal(const Mesh& part, const Mesh& environment);

/// Bullet's GImpact trees in double, if CMake finds Bullet: its pairs of boxes, then its GJK for each pair of triangles.
Peer makeBullet(const Mesh& part, const Mesh& environment);

/// CGAL's AABB trees with exact predicates. The answer is exact for the corners rounded to double at the pose.
Peer makeCgal(const Mesh& part, const Mesh& environment);

/// A library that this build knows, and the function that makes its trees.
struct NamedPeer {
    const char* name;  ///< that of the Peer
    Peer (*make)(const Mesh& part, const Mesh& environment);
};

/// Every library that this build knows and that answers distances.
std::vector<NamedPeer> distancePeers();

/// Every library that this build knows, FCL's two trees first.
std::vector<Peer> makePeers(const Mesh& part, const Mesh& environment);

}  // namespace clearway::testing
