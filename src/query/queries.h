// The queries on trees and the scratch they work with. Each query is dispatched once, to the instruction set
// in use.
#pragma once

#include <atomic>
#include <cassert>
#include <cstdint>
#include <memory>
#include <thread>

#include "clearway/query.h"
#include "core/pile.h"
#include "query/motion_pieces.h"
#include "query/pair_query.h"
#include "query/refine.h"
#include "query/witnesses.h"
#include "tree/flat_tree.h"

namespace clearway {

/// A pair of volumes that traversal still has to open, with a lower bound of its distance in query units.
struct StackEntry {
    float bound;
    VolumeReference part;
    VolumeReference environment;
};

/// A pair of triangles that may be the closest. lower: a true lower bound of its distance, query units.
struct Candidate {
    float lower;
    TrianglesAt triangles;
};

/// A pair of volumes over an interval of time.
struct SweepEntry {
    float gap;    ///< orders the descent; of the interval that the pair was looked at in
    float moved;  ///< about how far a point of the part's volume moves in half the interval; query units
    VolumeReference part;
    VolumeReference environment;
    std::uint64_t interval;  ///< TimeInterval::key
};

/// The contents of a Workspace.
struct Workspace::State {
    Pile<StackEntry> stack;
    Pile<Candidate> candidates;
    Pile<SweepEntry> sweepStack;
    std::unique_ptr<PieceCache> pieces;  ///< made by the first sweep
    Witnesses witnesses;
    QueryCounters counters;
    std::atomic<std::thread::id> user{};  ///< the thread that uses the workspace now; see WorkspaceUse
};

struct WorkspaceAccess {
    static Workspace::State& state(Workspace& workspace) { return *workspace.state_; }
};

inline Workspace::State& stateOf(Workspace& workspace) {
    return WorkspaceAccess::state(workspace);
}

/// The use of a workspace by one query. In builds with assertions it fails if another thread uses the workspace meanwhile;
/// in others it does nothing. A query within a query of the same thread is one use.
#ifdef NDEBUG
struct WorkspaceUse {
    explicit WorkspaceUse(Workspace::State&) {}
};
#else
class WorkspaceUse {
  public:
    // The order is relaxed, so that ThreadSanitizer still sees the races of threads that share a workspace.
    explicit WorkspaceUse(Workspace::State& state) : state_(state) {
        const std::thread::id self = std::this_thread::get_id();
        std::thread::id user;
        isOutermost_ = state_.user.compare_exchange_strong(user, self, std::memory_order_relaxed);
        assert((isOutermost_ || user == self) &&
               "two threads use a workspace at once, expected one for each thread");
    }
    ~WorkspaceUse() {
        if (isOutermost_) state_.user.store({}, std::memory_order_relaxed);
    }
    WorkspaceUse(const WorkspaceUse&) = delete;
    WorkspaceUse& operator=(const WorkspaceUse&) = delete;

  private:
    Workspace::State& state_;
    bool isOutermost_;
};
#endif

/// DistanceOptions in query units.
struct ClosestRequest {
    double relativeError;
    double absoluteError;
    double cap;
};

/// The closest pair.
struct ClosestAnswer {
    /// If false, the distance is larger than the cap, pair.lower >= cap, and all other values have no
    /// meaning.
    bool found = false;
    ResolvedPair pair;
    TrianglesAt triangles;
};

/// Whether any pair is within the distance.
struct WithinAnswer {
    bool within = false;
    TrianglesAt triangles;  ///< if within: such a pair
};

/// Chooses the instruction set that CLEARWAY_TARGET names, unless a set is chosen already. Every query calls this before it
/// dispatches. Throws as currentTarget() does.
void settleTarget();

/// Finds the closest pair. Begins with the nearest witness of the state's, which must be of these two models.
ClosestAnswer closestPair(const PairQuery& query, const ClosestRequest& request, Workspace::State& state);

/// Decides exactly whether any pair is within the distance. distance: environment units, >= 0. Begins with the last
/// pair that answered.
WithinAnswer anyPairWithin(const PairQuery& query, double distance, Workspace::State& state);

/// Collects the pairs whose distance may be at most the band in state.candidates, thinned to the nearest of each leaf of the part when
/// there are more than kMostCandidates. Returns whether they are thinned. band: environment units, >= 0.
bool pairsWithin(const PairQuery& query, double band, Workspace::State& state);
constexpr std::size_t kMostCandidates = 1 << 20;

/// Keeps the nearest candidate of each leaf of the part or, if isByPairs, of each pair of leaves.
void keepNearest(Pile<Candidate>& candidates, bool isByPairs);

/// Sorts by lower bounds, the least first.
void sortByLower(Pile<Candidate>& candidates);

}  // namespace clearway
