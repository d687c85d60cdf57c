#include "demos/study/replayer.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <stdexcept>
#include <string>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/state_to_pose.h"
#include "demos/study/experiment.h"
#include "planning/plan/plan_setup.h"

namespace clearway::study {
namespace {

namespace ob = ompl::base;
using planning::PlanSetup;

PlanSetup setupFor(const Problem& problem, const Scene& scene) {
    const planning::OmplMessages unobserved;
    planning::PlanOptions options;
    options.planner = "RRTConnect";
    options.threads = 1;
    planning::PlanReport report;
    return planning::makePlanSetup(problem, scene, options, report);
}

void setState(const ob::StateSpace& space, ob::State* state, const std::vector<double>& reals) {
    const std::size_t expected = space.getValueLocations().size();
    if (reals.size() != expected) {
        throw std::invalid_argument("a recorded state has " + std::to_string(reals.size()) +
                                    " numbers, expected " + std::to_string(expected));
    }
    space.copyFromReals(state, reals);
}

}  // namespace

std::vector<Pose> posesOf(const Problem& problem, const std::vector<CallBlock>& blocks) {
    ob::StateSpacePtr space = std::make_shared<ob::SE3StateSpace>();
    if (problem.space == Space::kSe2) space = std::make_shared<ob::SE2StateSpace>();
    space->computeLocations();  // of the reals of its states; its bounds do not matter
    const planning::StateToPose toPose = planning::stateToPose(*space);
    ob::ScopedState<> state(space);
    std::vector<Pose> poses;
    const auto add = [&](const std::vector<double>& reals) {
        setState(*space, state.get(), reals);
        poses.push_back(toPose(state.get()));
    };
    for (const CallBlock& block : blocks) {
        for (const Call& call : block) {
            add(call.from);
            if (!call.to.empty()) add(call.to);
        }
    }
    return poses;
}

struct Replayer::Tools {
    PlanSetup setup;
    ob::ScopedState<> from, to, lastValid;

    Tools(const Problem& problem, const Scene& scene)
        : setup(setupFor(problem, scene)), from(setup.si), to(setup.si), lastValid(setup.si) {}

    void set(ob::ScopedState<>& state, const std::vector<double>& reals) {
        setState(*setup.si->getStateSpace(), state.get(), reals);
    }

    void set(const Call& call) {
        set(from, call.from);
        if (call.kind != CallKind::kState && call.kind != CallKind::kClearance) set(to, call.to);
    }

    CallAnswer motionAnswer(bool isForward) {
        const std::uint64_t before = setup.certified->counters().undecided;
        bool isValid = false;
        if (isForward) {
            std::pair<ob::State*, double> last(lastValid.get(), 0);
            isValid = setup.si->checkMotion(from.get(), to.get(), last);
        } else {
            isValid = setup.si->checkMotion(from.get(), to.get());
        }
        if (isValid) return CallAnswer::kYes;
        return setup.certified->counters().undecided > before ? CallAnswer::kUndecided : CallAnswer::kNo;
    }

    CallAnswer ask(CallKind kind) {
        double clearance = 0;
        switch (kind) {
            case CallKind::kState:
                return setup.checker->isValid(from.get()) ? CallAnswer::kYes : CallAnswer::kNo;
            case CallKind::kClearance:
                return setup.checker->isValid(from.get(), clearance) ? CallAnswer::kYes : CallAnswer::kNo;
            case CallKind::kMotion:
                return motionAnswer(false);
            case CallKind::kForwardMotion:
                break;
        }
        return motionAnswer(true);
    }
};

Replayer::Replayer(const Problem& problem, const Scene& scene)
    : tools_(std::make_unique<Tools>(problem, scene)) {}
Replayer::~Replayer() = default;
Replayer::Replayer(Replayer&&) noexcept = default;

ReplayedCalls Replayer::replay(const std::vector<CallBlock>& blocks) {
    ReplayedCalls result;
    for (const CallBlock& block : blocks) {
        takeQueryTally();
        result.answers.emplace_back();
        for (const Call& call : block) {
            tools_->set(call);
            result.answers.back().push_back(tools_->ask(call.kind));
        }
        result.tallies.push_back(takeQueryTally());
    }
    return result;
}

std::vector<double> Replayer::time(const std::vector<CallBlock>& blocks) {
    std::vector<double> seconds;
    for (const CallBlock& block : blocks) {
        const double begin = threadSeconds();
        for (const Call& call : block) {
            tools_->set(call);
            tools_->ask(call.kind);
        }
        seconds.push_back(threadSeconds() - begin);
    }
    return seconds;
}

}  // namespace clearway::study
