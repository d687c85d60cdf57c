// Records what a planner asks: decorators around the checker and the validator count, time and sample its calls.
#pragma once

#include <ompl/base/StateSpace.h>

#include <cstdint>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "clearway/scene.h"
#include "clearway/scene_clearance.h"
#include "core/clock.h"
#include "demos/study/calls.h"
#include "program/bench/planner_run.h"

namespace clearway::study {

/// Records the calls of one thread between begin() and end(). Calls from the planner's further threads are
/// answered but not recorded. A recorded call costs two readings of the clock.
class Recorder {
  public:
    Recorder(const ompl::base::StateSpacePtr& space, const CallSampling& sampling);

    /// Starts recording the calling thread. A thread can have one recorder at a time.
    void begin();
    void end();

    /// Returns answer() and records the call. s2: null for calls about one state.
    template <class Answer>
    auto record(CallKind kind, const ompl::base::State* s1, const ompl::base::State* s2,
                const Answer& answer) {
        if (isRecording()) note(kind, s1, s2);
        return time(answer);
    }

    /// Returns answer() and counts only its time, for calls that are not replayed.
    template <class Answer>
    auto time(const Answer& answer) {
        if (!isRecording()) return answer();
        const Clock::time_point begin = Clock::now();
        const auto result = answer();
        seconds_ += secondsSince(begin);
        return result;
    }

    /// The work of the thread's queries from begin() to end().
    const QueryTally& tally() const { return tally_; }

    /// The time spent in calls: their queries, and the poses between them.
    double seconds() const { return seconds_; }

    std::uint64_t calls(CallKind kind) const { return calls_[static_cast<std::size_t>(kind)]; }

    /// The sampled blocks, in the order of the run. A last block that the run's end cut short may be among
    /// them.
    std::vector<CallBlock> sample() const;

  private:
    struct Kept {
        std::uint64_t place = 0;  ///< position of the block in the run
        CallBlock calls;
    };
    bool isRecording() const { return thread_ == std::this_thread::get_id(); }
    void note(CallKind kind, const ompl::base::State* s1, const ompl::base::State* s2);
    void beginBlock();

    ompl::base::StateSpacePtr space_;
    CallSampling sampling_;
    std::mt19937_64 random_;
    std::thread::id thread_;  ///< the recorded thread; none before begin() and after end()
    std::vector<Kept> kept_;
    Kept* current_ = nullptr;  ///< the current block if it is kept
    std::uint64_t calls_[4] = {};
    std::uint64_t allCalls_ = 0;
    double seconds_ = 0;
    QueryTally tally_;
};

/// For RunLimits: makes the recorder, which counts, times and samples the calls of a run, and must outlive it.
CallWatch recordingInto(std::optional<Recorder>& recorder, const CallSampling& sampling);

}  // namespace clearway::study
