#include "planning/validity/run_trace.h"

#include <algorithm>
#include <cassert>

namespace clearway::planning {
namespace {

thread_local RunTrace* traceOfThisThread = nullptr;

std::vector<double> realsOf(const ompl::base::StateSpace& space, const ompl::base::State* state) {
    std::vector<double> reals;
    space.copyToReals(reals, state);
    return reals;
}

}  // namespace

RunTrace::RunTrace(const ompl::base::StateSpacePtr& space, const CallSampling& sampling)
    : space_(space), sampling_(sampling), random_(sampling.seed) {
    assert(traceOfThisThread == nullptr);
    kept_.reserve(sampling.blocks);
    traceOfThisThread = this;
}

RunTrace::~RunTrace() {
    traceOfThisThread = nullptr;
}

RunTrace* RunTrace::ofThisThread() {
    return traceOfThisThread;
}

void RunTrace::called(CallKind kind, const ompl::base::State* s1, const ompl::base::State* s2) {
    ++calls_[static_cast<std::size_t>(kind)];
    if (sampling_.blocks == 0) return;
    if (allCalls_ % sampling_.callsPerBlock == 0) beginBlock();
    ++allCalls_;
    if (current_ == nullptr) return;
    current_->calls.push_back(
        {kind, realsOf(*space_, s1), s2 ? realsOf(*space_, s2) : std::vector<double>()});
}

/// A reservoir: after n blocks each one of them is kept with the same probability.
void RunTrace::beginBlock() {
    const std::uint64_t place = allCalls_ / sampling_.callsPerBlock;
    current_ = nullptr;
    if (kept_.size() < sampling_.blocks) {
        kept_.emplace_back();
        current_ = &kept_.back();
    } else if (const std::uint64_t drawn = random_() % (place + 1); drawn < sampling_.blocks) {
        current_ = &kept_[drawn];
    }
    if (current_ == nullptr) return;
    current_->place = place;
    current_->calls.clear();
}

void RunTrace::queried(Query kind, double seconds, const QueryCounters& work) {
    ++(kind == Query::kDistance ? tally_.distances : tally_.withins);
    tally_.seconds += seconds;
    tally_.work += work;
}

std::vector<CallBlock> RunTrace::sample() const {
    std::vector<const Kept*> inOrder;
    for (const Kept& block : kept_) inOrder.push_back(&block);
    std::sort(inOrder.begin(), inOrder.end(),
              [](const Kept* a, const Kept* b) { return a->place < b->place; });
    std::vector<CallBlock> blocks;
    for (const Kept* block : inOrder) blocks.push_back(block->calls);
    return blocks;
}

}  // namespace clearway::planning
