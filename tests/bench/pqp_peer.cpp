#include <PQP.h>

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "bench/peer.h"
#include "core/clock.h"

namespace clearway::testing {
namespace {

/// PQP's queries write to the models (last_tri), and a collision's result keeps its list of pairs.
struct Trees {
    PQP_Model part;
    PQP_Model environment;
    PQP_CollideResult contacts;
};

void fill(PQP_Model& model, const Mesh& mesh) {
    model.BeginModel(static_cast<int>(mesh.triangles.size()));
    int id = 0;
    for (const TriangleIndices& t : mesh.triangles) {
        model.AddTri(mesh.vertices[t[0]].data(), mesh.vertices[t[1]].data(), mesh.vertices[t[2]].data(),
                     id++);
    }
    if (model.EndModel() != PQP_OK) throw std::runtime_error("PQP did not build its tree");
}

/// A pose in the form that PQP takes: row-major.
struct Placed {
    PQP_REAL rotation[3][3];
    PQP_REAL translation[3];

    explicit Placed(const Pose& pose) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) rotation[row][column] = pose.rotation(row, column);
            translation[row] = pose.translation[row];
        }
    }
};

template <typename Result>
Answer answerOf(double value, Result& result) {
    Answer answer;
    answer.value = value;
    answer.counters.volumeTests = static_cast<std::uint64_t>(result.NumBVTests());
    answer.counters.triangleTests = static_cast<std::uint64_t>(result.NumTriTests());
    return answer;
}

void require(int code) {
    if (code != PQP_OK) throw std::runtime_error("PQP refused a query with code " + std::to_string(code));
}

Answer distanceBy(Trees& trees, const Pose& X_environmentPart) {
    Placed placed(X_environmentPart), fixed(Pose{});
    PQP_DistanceResult result;
    require(PQP_Distance(&result, placed.rotation, placed.translation, &trees.part, fixed.rotation,
                         fixed.translation, &trees.environment, /*rel_err*/ 0, /*abs_err*/ 0));
    return answerOf(result.Distance(), result);
}

Answer collidesBy(Trees& trees, const Pose& X_environmentPart) {
    Placed placed(X_environmentPart), fixed(Pose{});
    require(PQP_Collide(&trees.contacts, placed.rotation, placed.translation, &trees.part, fixed.rotation,
                        fixed.translation, &trees.environment, PQP_FIRST_CONTACT));
    return answerOf(trees.contacts.Colliding() != 0, trees.contacts);
}

Answer isWithinBy(Trees& trees, const Pose& X_environmentPart, double d) {
    Placed placed(X_environmentPart), fixed(Pose{});
    PQP_ToleranceResult result;
    require(PQP_Tolerance(&result, placed.rotation, placed.translation, &trees.part, fixed.rotation,
                          fixed.translation, &trees.environment, d));
    return answerOf(result.CloserThanTolerance() != 0, result);
}

}  // namespace

Peer makePqp(const Mesh& part, const Mesh& environment) {
    Peer peer;
    peer.name = "PQP";
    const auto start = Clock::now();
    const auto trees = std::make_shared<Trees>();
    fill(trees->part, part);
    fill(trees->environment, environment);
    peer.buildSeconds = secondsSince(start);
    // PQP counts bytes in an int, which overflows from 5 million triangles on. Without its sign the number holds up to 9.9 million.
    peer.bytes = std::size_t{static_cast<std::uint32_t>(trees->part.MemUsage(0))} +
                 static_cast<std::uint32_t>(trees->environment.MemUsage(0));
    peer.distance = [trees](const Pose& pose) { return distanceBy(*trees, pose); };
    peer.collides = [trees](const Pose& pose) { return collidesBy(*trees, pose); };
    peer.isWithin = [trees](const Pose& pose, double d) { return isWithinBy(*trees, pose, d); };
    peer.forgetWarmStart = [trees] {  // restores the state after EndModel
        trees->part.last_tri = trees->part.tris;
        trees->environment.last_tri = trees->environment.tris;
    };
    return peer;
}

}  // namespace clearway::testing
