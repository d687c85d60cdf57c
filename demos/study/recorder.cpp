#include "demos/study/recorder.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace clearway::study {
namespace {

namespace ob = ompl::base;

std::vector<double> realsOf(const ob::StateSpace& space, const ob::State* state) {
    std::vector<double> reals;
    space.copyToReals(reals, state);
    return reals;
}

/// Forwards to the setup's checker, so that the setup's counters still count.
class RecordingChecker : public planning::ValidityChecker {
  public:
    RecordingChecker(Recorder& recorder, const ob::SpaceInformationPtr& si,
                     std::shared_ptr<const planning::ValidityChecker> checker)
        : ValidityChecker(si, checker->shared()), recorder_(recorder), checker_(std::move(checker)) {}

    using ValidityChecker::isValid;
    bool isValid(const ob::State* state) const override {
        return recorder_.record(CallKind::kState, state, nullptr, [&] { return checker_->isValid(state); });
    }
    bool isValid(const ob::State* state, double& clearance) const override {
        return recorder_.record(CallKind::kClearance, state, nullptr,
                                [&] { return checker_->isValid(state, clearance); });
    }

  private:
    Recorder& recorder_;
    std::shared_ptr<const planning::ValidityChecker> checker_;
};

class RecordingValidator : public planning::MotionValidator {
  public:
    RecordingValidator(Recorder& recorder, const ob::SpaceInformationPtr& si,
                       const planning::SharedScene& scene, const planning::MotionOptions& options)
        : MotionValidator(si, scene, options), recorder_(recorder) {}

    bool checkMotion(const ob::State* s1, const ob::State* s2) const override {
        return recorder_.record(CallKind::kMotion, s1, s2,
                                [&] { return MotionValidator::checkMotion(s1, s2); });
    }
    bool checkMotion(const ob::State* s1, const ob::State* s2,
                     std::pair<ob::State*, double>& lastValid) const override {
        return recorder_.record(CallKind::kForwardMotion, s1, s2,
                                [&] { return MotionValidator::checkMotion(s1, s2, lastValid); });
    }
    bool keepsClearance(const ob::State* s1, const ob::State* s2, double more,
                        const std::function<bool()>& isStopped) const override {
        return recorder_.time([&] { return MotionValidator::keepsClearance(s1, s2, more, isStopped); });
    }

  private:
    Recorder& recorder_;
};

/// Puts recording decorators in place of the setup's checker and certified validator.
/// The decorators answer as the originals do. They derive from the originals' classes, because planners and
/// samplers cast to these classes.
void recordInto(Recorder& recorder, planning::PlanSetup& setup, const std::function<bool()>& isOver) {
    setup.si->setStateValidityChecker(std::make_shared<RecordingChecker>(recorder, setup.si, setup.checker));
    planning::MotionOptions options;
    options.leastInterval = setup.certified->leastInterval();
    options.isStopped = isOver;
    setup.certified =
        std::make_shared<RecordingValidator>(recorder, setup.si, setup.checker->shared(), options);
    setup.si->setMotionValidator(setup.certified);
}

void measureCalls(const Recorder& recorder, RunMeasures& measures) {
    static_cast<Work&>(measures) = Work(recorder.tally());
    measures.motionChecks = recorder.calls(CallKind::kMotion) + recorder.calls(CallKind::kForwardMotion);
    measures.querySeconds = recorder.seconds();
    const double seconds = measures.seconds.value_or(0);
    measures.queryShare = seconds > 0 ? recorder.seconds() / seconds : 0;
}

}  // namespace

Recorder::Recorder(const ob::StateSpacePtr& space, const CallSampling& sampling)
    : space_(space), sampling_(sampling), random_(sampling.seed) {
    kept_.reserve(sampling.blocks);
}

void Recorder::begin() {
    takeQueryTally();
    thread_ = std::this_thread::get_id();
}

void Recorder::end() {
    thread_ = {};
    tally_ = takeQueryTally();
}

void Recorder::note(CallKind kind, const ob::State* s1, const ob::State* s2) {
    ++calls_[static_cast<std::size_t>(kind)];
    if (sampling_.blocks == 0) return;
    if (allCalls_ % sampling_.callsPerBlock == 0) beginBlock();
    ++allCalls_;
    if (current_ == nullptr) return;
    current_->calls.push_back(
        {kind, realsOf(*space_, s1), s2 ? realsOf(*space_, s2) : std::vector<double>()});
}

/// Reservoir sampling: after n blocks, each of them is kept with the same probability.
void Recorder::beginBlock() {
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

std::vector<CallBlock> Recorder::sample() const {
    std::vector<const Kept*> inOrder;
    for (const Kept& block : kept_) inOrder.push_back(&block);
    std::sort(inOrder.begin(), inOrder.end(),
              [](const Kept* a, const Kept* b) { return a->place < b->place; });
    std::vector<CallBlock> blocks;
    for (const Kept* block : inOrder) blocks.push_back(block->calls);
    return blocks;
}

CallWatch recordingInto(std::optional<Recorder>& recorder, const CallSampling& sampling) {
    CallWatch watch;
    watch.join = [&recorder, sampling](planning::PlanSetup& setup, const std::function<bool()>& isOver) {
        recorder.emplace(setup.si->getStateSpace(), sampling);
        recordInto(*recorder, setup, isOver);
    };
    watch.begin = [&recorder] { recorder->begin(); };
    watch.end = [&recorder](RunMeasures& measures) {
        recorder->end();
        measureCalls(*recorder, measures);
    };
    return watch;
}

}  // namespace clearway::study
