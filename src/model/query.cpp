// The public queries: checks the caller's arguments, keeps the closest pairs, and turns the trees' positions and
// units into ids and environment units.
#include "clearway/query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "clearway/errors.h"
#include "clearway/model.h"
#include "core/number.h"
#include "model/arguments.h"
#include "model/local_minima.h"
#include "model/model_data.h"
#include "model/query_range.h"
#include "query/decide.h"
#include "query/queries.h"

namespace clearway {
namespace {

/// Infinity bounds nothing.
void requireBound(const char* name, double length) {
    if (length != std::numeric_limits<double>::infinity()) requireNotNegative(name, length);
}

PairQuery beginQuery(const Model& part, const Model& environment, const Pose& X_environmentPart,
                     Workspace::State& state) {
    requireSameWidth(part, environment);
    requireWithinRange(part, environment, X_environmentPart);
    state.counters = {};
    state.witnesses.serve(part.id(), environment.id());
    return preparePairQuery(treeOf(part), treeOf(environment), X_environmentPart);
}

/// |v|, also if the squares would overflow or vanish.
double lengthOf(const Vector3& v) {
    constexpr double kLeastSquare = 1e-280, kLargestSquare = 1e280;
    const double squared = v.squaredNorm();
    if (squared > kLeastSquare && squared < kLargestSquare) return std::sqrt(squared);
    const double largest = v.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return 0;
    const int exponent = std::ilogb(largest);
    return std::ldexp(Vector3(v.unaryExpr([&](double x) { return std::ldexp(x, -exponent); })).norm(),
                      exponent);
}

/// The length times `unit`, a power of two with inverse perUnit; rounded down if the result is denormal.
double scaledDown(double length, double unit, double perUnit) {
    const double scaled = length * unit;
    return scaled * perUnit > length ? std::nextafter(scaled, 0.0) : scaled;
}
/// The length times `unit`, rounded up if the result is denormal.
double scaledUp(double length, double unit, double perUnit) {
    const double scaled = length * unit;
    return scaled * perUnit < length ? std::nextafter(scaled, std::numeric_limits<double>::infinity())
                                     : scaled;
}

bool answerWithin(const Model& part, const Model& environment, const Pose& X_environmentPart, double d,
                  Workspace& workspace) {
    requireWithinCap(environment, d);
    Workspace::State& state = stateOf(workspace);
    const WorkspaceUse use(state);
    const PairQuery query = beginQuery(part, environment, X_environmentPart, state);
    const WithinAnswer answer = anyPairWithin(query, d, state);
    if (answer.within) state.witnesses.setLast(answer.triangles);
    return answer.within;
}

/// The pair in environment units, without counters.
DistanceResult resultOf(const Model& part, const Model& environment, const PairQuery& query,
                        const ResolvedPair& pair, const TrianglesAt& triangles) {
    const double toMeshUnits = std::ldexp(1.0, query.unitExponent);
    DistanceResult result;
    result.lower = scaledDown(pair.lower, toMeshUnits, query.perMeshUnit);
    result.upper = scaledUp(pair.upper, toMeshUnits, query.perMeshUnit);
    Witness& witness = result.witness.emplace();
    for (int k = 0; k < 3; ++k) {
        witness.pointOnPart[k] = pair.pointOnPart[k] * toMeshUnits;
        witness.pointOnEnvironment[k] = pair.pointOnEnvironment[k] * toMeshUnits;
    }
    result.distance =
        pair.contact == Verdict::yes ? 0.0 : lengthOf(witness.pointOnPart - witness.pointOnEnvironment);
    const std::uint32_t onPart = treeOf(part).triangleId(triangles.part),
                        onEnvironment = treeOf(environment).triangleId(triangles.environment);
    witness.partTriangle = onPart;
    witness.environmentTriangle = onEnvironment;
    witness.partComponent = static_cast<std::int64_t>(componentOf(part.components(), onPart));
    witness.environmentComponent =
        static_cast<std::int64_t>(componentOf(environment.components(), onEnvironment));
    return result;
}

Workspace& workspaceOfThread() {
    thread_local Workspace workspace;
    return workspace;
}

}  // namespace

Workspace& OwnedWorkspace::mine() {
    if (owner_ == std::this_thread::get_id()) return workspace_;
    throw ArgumentError("the workspace belongs to another thread, expected one for each thread");
}

DistanceResult distance(const Model& part, const Model& environment, const Pose& X_environmentPart,
                        const DistanceOptions& options, Workspace& workspace) {
    requireNotNegative("relativeError", options.relativeError);
    requireNotNegative("absoluteError", options.absoluteError);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double wanted = options.cap.value_or(kInfinity);
    requireBound("cap", wanted);
    const double cap = cappedByRange(environment, wanted);
    Workspace::State& state = stateOf(workspace);
    const WorkspaceUse use(state);
    const PairQuery query = beginQuery(part, environment, X_environmentPart, state);
    const double toMeshUnits = std::ldexp(1.0, query.unitExponent);
    const ClosestRequest request{options.relativeError, options.absoluteError * query.perMeshUnit,
                                 scaledUp(cap, query.perMeshUnit, toMeshUnits)};
    const ClosestAnswer answer = closestPair(query, request, state);

    if (!answer.found) {
        DistanceResult result;
        result.counters = state.counters;
        // Triangles that were left out may be nearer than the tree's own bound, but not nearer than the
        // range's cap.
        result.lower = cappedByRange(
            environment, std::max(cap, scaledDown(answer.pair.lower, toMeshUnits, query.perMeshUnit)));
        result.upper = result.distance = kInfinity;
        return result;
    }
    state.witnesses.keep(query, answer.triangles, answer.pair.pointOnPart, answer.pair.pointOnEnvironment);
    DistanceResult result = resultOf(part, environment, query, answer.pair, answer.triangles);
    result.counters = state.counters;
    return result;
}

std::vector<DistanceResult> nearPairs(const Model& part, const Model& environment,
                                      const Pose& X_environmentPart, double band, Workspace& workspace,
                                      NearPairs kept) {
    requireBound("band", band);
    requireWithinCap(environment, band);
    Workspace::State& state = stateOf(workspace);
    const WorkspaceUse use(state);
    const PairQuery query = beginQuery(part, environment, X_environmentPart, state);
    const bool isThinned = pairsWithin(query, band, state);
    if (isThinned || state.candidates.size() > kAllNearPairs)
        keepNearest(state.candidates, !isThinned && state.candidates.size() <= kLeafNearPairs);
    std::vector<PlacedPair> placed;
    const WantedWidth wanted{query.defaultWidth, 0, std::numeric_limits<double>::infinity()};
    for (const Candidate& candidate : state.candidates) {
        const ResolvedPair pair = settlePair(query, candidate.triangles, wanted, state.counters);
        if (pair.lower <= band * query.perMeshUnit)
            placed.push_back(
                {resultOf(part, environment, query, pair, candidate.triangles), candidate.triangles});
    }
    if (kept == NearPairs::kLocalMinima) keepLocalMinima(part, environment, X_environmentPart, placed);
    std::vector<DistanceResult> all;
    for (PlacedPair& pair : placed) all.push_back(std::move(pair.result));
    std::sort(all.begin(), all.end(), [](const DistanceResult& a, const DistanceResult& b) {
        const auto key = [](const DistanceResult& each) {
            return std::tuple(each.distance, each.witness->partTriangle, each.witness->environmentTriangle);
        };
        return key(a) < key(b);
    });
    if (!all.empty()) all[0].counters = state.counters;
    return all;
}

std::optional<DistanceGradient> distanceGradient(const DistanceResult& pair, const Vector3& centre) {
    if (!pair.witness || pair.collides()) return std::nullopt;
    const Vector3 apart = pair.witness->pointOnPart - pair.witness->pointOnEnvironment;
    const double length = lengthOf(apart);
    if (!(length > 0)) return std::nullopt;
    const Vector3 along = apart / length;
    return DistanceGradient{along, (pair.witness->pointOnPart - centre).cross(along)};
}

bool collides(const Model& part, const Model& environment, const Pose& X_environmentPart,
              Workspace& workspace) {
    return answerWithin(part, environment, X_environmentPart, 0, workspace);
}

bool isWithin(const Model& part, const Model& environment, const Pose& X_environmentPart, double d,
              Workspace& workspace) {
    requireBound("d", d);
    return answerWithin(part, environment, X_environmentPart, d, workspace);
}

DistanceResult distance(const Model& part, const Model& environment, const Pose& X_environmentPart,
                        const DistanceOptions& options) {
    return distance(part, environment, X_environmentPart, options, workspaceOfThread());
}

bool collides(const Model& part, const Model& environment, const Pose& X_environmentPart) {
    return collides(part, environment, X_environmentPart, workspaceOfThread());
}

bool isWithin(const Model& part, const Model& environment, const Pose& X_environmentPart, double d) {
    return isWithin(part, environment, X_environmentPart, d, workspaceOfThread());
}

}  // namespace clearway
