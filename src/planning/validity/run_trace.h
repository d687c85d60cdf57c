// Sees what a planner asks of checkers, validators and objectives while it runs.
#pragma once

#include <ompl/base/StateSpace.h>

#include <chrono>
#include <cstdint>
#include <random>
#include <vector>

#include "planning/validity/calls.h"

namespace clearway::planning {

/// While it lives, calls and queries of the thread that it was made in are counted, timed and sampled. One at
/// a time in a thread; planners' further threads go unseen. It costs two looks at the clock a query.
class RunTrace {
  public:
    RunTrace(const ompl::base::StateSpacePtr& space, const CallSampling& sampling);
    ~RunTrace();
    RunTrace(const RunTrace&) = delete;
    RunTrace& operator=(const RunTrace&) = delete;

    /// Null when there is none.
    static RunTrace* ofThisThread();

    /// s2: null for calls about one state.
    void called(CallKind kind, const ompl::base::State* s1, const ompl::base::State* s2);

    enum class Query { kDistance, kWithin };
    void queried(Query kind, double seconds, const QueryCounters& work);

    const QueryTally& tally() const { return tally_; }

    /// Calls of each kind, by CallKind's numbers.
    std::uint64_t calls(CallKind kind) const { return calls_[static_cast<std::size_t>(kind)]; }

    /// The sample, in the order of the run; a last block that the run's end cut short is among them.
    std::vector<CallBlock> sample() const;

  private:
    struct Kept {
        std::uint64_t place = 0;  ///< of the block in the run
        CallBlock calls;
    };
    void beginBlock();

    ompl::base::StateSpacePtr space_;
    CallSampling sampling_;
    std::mt19937_64 random_;
    std::vector<Kept> kept_;
    Kept* current_ = nullptr;  ///< the block at hand when it is kept
    std::uint64_t calls_[5] = {};
    std::uint64_t allCalls_ = 0;
    QueryTally tally_;
};

/// Calls a query, which leaves its counters in the workspace, and tells the thread's trace of it.
template <class Ask>
auto traced(RunTrace::Query kind, const Workspace& workspace, const Ask& ask) {
    RunTrace* trace = RunTrace::ofThisThread();
    if (trace == nullptr) return ask();
    const auto begin = std::chrono::steady_clock::now();
    auto answer = ask();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    trace->queried(kind, took.count(), workspace.counters());
    return answer;
}

/// Tells the thread's trace of a call.
inline void noteCall(CallKind kind, const ompl::base::State* s1, const ompl::base::State* s2 = nullptr) {
    if (RunTrace* trace = RunTrace::ofThisThread()) trace->called(kind, s1, s2);
}

}  // namespace clearway::planning
