#include "planning/planners/planner_team.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <future>
#include <limits>
#include <mutex>
#include <optional>
#include <string>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/sliding_rrt_connect.h"
#include "core/clock.h"
#include "planning/planners/twist_search.h"

namespace clearway::planning {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

/// Iterations of RRTConnect's shortest run: on easy problems of OMPL.app, most runs have ended by then.
constexpr std::uint64_t kShortestRun = 3000;
/// Iterations of a turn, which take about the same time. Finer slides take more of it.
constexpr std::uint64_t kTurn = 1000, kSlidingTurn = 30, kFineTurn = 10, kTwistTurn = 10;
/// A turn in seconds, where turns are counted in time.
constexpr double kSecondsOfTurn = 0.03;
/// Restarts succeed early or almost never; turns after the first kEarlyTurns are charged kLateCost times.
constexpr double kEarlyTurns = 20, kLateCost = 4;
constexpr const char* kTwistSearch = "TwistSearch";
constexpr double kTwistCost = 0.5;  ///< in a tight fit a TwistSearch gets the time of two others
/// Finer standoffs, as shares of the diagonal of the part's box.
constexpr double kLeastFineStandoff = 0.00025, kMostFineStandoff = 0.01;

/// The sequence 1, 1, 2, 1, 1, 2, 4, 1, ... of Luby, Sinclair and Zuckerman. i counts from 1.
std::uint64_t luby(std::uint64_t i) {
    std::uint64_t power = 1;
    while (power - 1 < i) power *= 2;
    while (power - 1 != i) {
        i -= power / 2 - 1;
        power = 1;
        while (power - 1 < i) power *= 2;
    }
    return power / 2;
}

}  // namespace

struct PlannerTeam::Member {
    std::string name;
    ob::PlannerPtr planner;
    ob::ProblemDefinitionPtr definition;
    std::uint64_t turn;                ///< iterations
    std::uint64_t shortestRun = 0;     ///< iterations; 0: one run only
    std::uint64_t runs = 0, left = 0;  ///< iterations left in the present run
    double spent = 0;                  ///< turns
    double cost = 1;                   ///< of a turn
    bool isBusy = false;
    bool isExhausted = false;  ///< nothing is left to try

    /// Takes over the starts that were added. With other starts or another goal the planner begins anew.
    void follow(const ob::ProblemDefinition& given) {
        if (!definition || definition->getGoal() != given.getGoal() || !beginsAs(given)) {
            if (definition) planner->clear();
            isExhausted = false;
            definition = std::make_shared<ob::ProblemDefinition>(given.getSpaceInformation());
            definition->setGoal(given.getGoal());
            planner->setProblemDefinition(definition);
        }
        for (unsigned int i = definition->getStartStateCount(); i < given.getStartStateCount(); ++i)
            addStart(given.getStartState(i));
    }

    void addStart(const ob::State* state) {
        definition->addStartState(state);
        isExhausted = false;
    }

    /// Whether the definition's starts are the first ones of the given definition.
    bool beginsAs(const ob::ProblemDefinition& given) const {
        const unsigned int count = definition->getStartStateCount();
        if (count > given.getStartStateCount()) return false;
        const ob::StateSpace& space = *given.getSpaceInformation()->getStateSpace();
        for (unsigned int i = 0; i < count; ++i) {
            if (!space.equalStates(definition->getStartState(i), given.getStartState(i))) return false;
        }
        return true;
    }

    /// Returns the status of a turn that ends early when isOver returns true.
    ob::PlannerStatus takeTurn(const std::function<bool()>& isOver) {
        if (left == 0) {
            if (runs > 0) planner->clear();
            ++runs;
            left = shortestRun > 0 ? shortestRun * luby(runs) : std::numeric_limits<std::uint64_t>::max();
        }
        const std::uint64_t most = std::min(left, turn);
        std::uint64_t count = 0;
        const ob::PlannerTerminationCondition isTurnOver(
            [&] { return count >= most || isOver() || (++count, false); });
        definition->clearSolutionPaths();
        const ob::PlannerStatus status = planner->solve(isTurnOver);
        left -= std::max<std::uint64_t>(1, std::min(count, left));
        const auto* search = dynamic_cast<const TwistSearch*>(planner.get());
        isExhausted = search != nullptr && search->isExhausted();
        // A planner that still waits for a goal when its turn ends calls the goal invalid.
        const bool isUnfinished = status == ob::PlannerStatus::INVALID_GOAL && isTurnOver();
        return isUnfinished ? ob::PlannerStatus(ob::PlannerStatus::TIMEOUT) : status;
    }
};

/// Who is next, and whether a solution was found. Used by several threads at once.
class PlannerTeam::Turns {
  public:
    Turns(std::vector<std::unique_ptr<Member>>& members, bool isByTime,
          const ob::PlannerTerminationCondition& isSpent)
        : members_(members), isByTime_(isByTime), isSpent_(isSpent) {}

    void work() {
        while (Member* member = next()) {
            const Clock::time_point begin = Clock::now();
            const ob::PlannerStatus status = member->takeTurn([this] { return isFound_ || isSpent_(); });
            const double seconds = secondsSince(begin);
            finish(*member, status, isByTime_ ? seconds / kSecondsOfTurn : 1);
        }
    }

    const Member* winner() const { return winner_; }
    /// The status of a member that cannot plan at all.
    const std::optional<ob::PlannerStatus>& failure() const { return failure_; }

  private:
    Member* next() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (isFound_ || failure_ || isSpent_()) return nullptr;
        Member* chosen = nullptr;
        for (const auto& member : members_) {
            if (!member->isBusy && !member->isExhausted &&
                (chosen == nullptr || member->spent < chosen->spent))
                chosen = member.get();
        }
        if (chosen != nullptr) chosen->isBusy = true;
        return chosen;
    }

    void finish(Member& member, const ob::PlannerStatus& status, double spent) {
        const std::lock_guard<std::mutex> lock(mutex_);
        member.isBusy = false;
        const bool isLate = member.shortestRun > 0 && member.spent > kEarlyTurns;
        member.spent += (isLate ? kLateCost : member.cost) * spent;
        if (status == ob::PlannerStatus::EXACT_SOLUTION && winner_ == nullptr) {
            winner_ = &member;
            isFound_ = true;
        } else if (status != ob::PlannerStatus::TIMEOUT &&
                   status != ob::PlannerStatus::APPROXIMATE_SOLUTION && !isFound_) {
            failure_ = status;
            isFound_ = true;
        }
    }

    std::vector<std::unique_ptr<Member>>& members_;
    bool isByTime_;
    const ob::PlannerTerminationCondition& isSpent_;
    std::mutex mutex_;
    std::atomic<bool> isFound_{false};
    const Member* winner_ = nullptr;
    std::optional<ob::PlannerStatus> failure_;
};

PlannerTeam::PlannerTeam(const ob::SpaceInformationPtr& si) : Planner(si, "PlannerTeam") {
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.multithreaded = true;
    specs_.directed = true;
    declareParam<double>("range", this, &PlannerTeam::setRange, &PlannerTeam::getRange, "0.:1.:10000.");
    declareParam<unsigned int>("threads", this, &PlannerTeam::setThreads, &PlannerTeam::getThreads, "1:256");
}

PlannerTeam::~PlannerTeam() = default;

void PlannerTeam::makeMembers() {
    const double diagonal = sceneOf(si_).scene().part.box().diagonal().norm();
    constexpr unsigned int kKinds = 3;
    const unsigned int count = std::max(threads_, kKinds);
    for (unsigned int i = 0; i < count; ++i) {
        auto member = std::make_unique<Member>();
        if (i % kKinds == 0) {
            const auto planner = std::make_shared<og::RRTConnect>(si_);
            planner->setRange(range_);
            *member = {"RRTConnect", planner, nullptr, kTurn, kShortestRun};
        } else {
            const auto planner = std::make_shared<SlidingRRTConnect>(si_);
            const bool isFine = i % kKinds == 2;
            if (isFine) {
                planner->setLeastStandoff(kLeastFineStandoff * diagonal);
                planner->setMostStandoff(kMostFineStandoff * diagonal);
            }
            *member = {isFine ? "SlidingRRTConnect, fine" : "SlidingRRTConnect", planner, nullptr,
                       kSlidingTurn};
        }
        members_.push_back(std::move(member));
    }
}

/// Where the first start or a fixed goal is in a tight fit, a TwistSearch goes first. Elsewhere nothing changes but for the query that tells.
void PlannerTeam::addTwistSearch() {
    if (twistSearch() != nullptr || pdef_->getStartStateCount() == 0) return;
    const auto* goal = dynamic_cast<const ob::GoalState*>(pdef_->getGoal().get());
    const bool isTight = TwistSearch::isTight(si_, pdef_->getStartState(0)) ||
                         (goal != nullptr && TwistSearch::isTight(si_, goal->getState()));
    if (!isTight) return;
    const auto planner = std::make_shared<TwistSearch>(si_);
    planner->setRange(range_);
    planner->setup();
    auto member = std::make_unique<Member>();
    *member = {kTwistSearch, planner, nullptr, kTwistTurn};
    member->cost = kTwistCost;
    members_.insert(members_.begin(), std::move(member));
}

const TwistSearch* PlannerTeam::twistSearch() const {
    for (const auto& member : members_) {
        if (const auto* search = dynamic_cast<const TwistSearch*>(member->planner.get())) return search;
    }
    return nullptr;
}

void PlannerTeam::setup() {
    Planner::setup();
    if (members_.empty()) makeMembers();
    for (const auto& member : members_) member->planner->setup();
}

void PlannerTeam::clear() {
    Planner::clear();
    members_.clear();
    setup_ = false;
}

ob::PlannerStatus PlannerTeam::solve(const ob::PlannerTerminationCondition& isSpent) {
    checkValidity();
    addTwistSearch();
    for (const auto& member : members_) member->follow(*pdef_);
    Turns turns(members_, threads_ > 1, isSpent);
    std::vector<std::future<void>> others;
    for (unsigned int i = 1; i < threads_; ++i) {
        others.push_back(std::async(std::launch::async, [&] { turns.work(); }));
    }
    turns.work();
    for (auto& other : others) other.get();

    const Member* best = turns.winner();
    if (best == nullptr && turns.failure()) return *turns.failure();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& member : members_) {
        if (turns.winner() != nullptr || !member->definition->hasSolution()) continue;
        if (member->definition->getSolutionDifference() >= least) continue;
        least = member->definition->getSolutionDifference();
        best = member.get();
    }
    if (best == nullptr) return ob::PlannerStatus::TIMEOUT;
    ob::PlannerSolution solution = best->definition->getSolutions().front();
    const std::string run = best->shortestRun > 0 ? ", run " + std::to_string(best->runs) : "";
    solution.setPlannerName(best->name + run);
    pdef_->addSolutionPath(solution);
    return turns.winner() != nullptr ? ob::PlannerStatus::EXACT_SOLUTION
                                     : ob::PlannerStatus::APPROXIMATE_SOLUTION;
}

void PlannerTeam::getPlannerData(ob::PlannerData& data) const {
    Planner::getPlannerData(data);
    for (const auto& member : members_) member->planner->getPlannerData(data);
}

}  // namespace clearway::planning
