#include "planning/planners/twist_search.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/outside_goal.h"

namespace clearway::planning {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

constexpr unsigned int kJoiningTurn = 50;  ///< iterations of RRTConnect between two steps of the trees
constexpr std::size_t kMostGoalRoots = 4;

const TwistTree::Node* nodeAt(const TwistTree& tree, const ob::SpaceInformation& si, const ob::State* state) {
    for (const TwistTree::Node* node : tree.free()) {
        if (si.equalStates(tree.stateOf(*node), state)) return node;
    }
    return nullptr;
}

}  // namespace

/// RRTConnect between the states where the part is free.
class TwistSearch::Joint {
  public:
    Joint(const ob::SpaceInformationPtr& si, double range, const ob::GoalPtr& outside)
        : planner_(si),
          definition_(std::make_shared<ob::ProblemDefinition>(si)),
          ends_(std::make_shared<ob::GoalStates>(si)) {
        definition_->setGoal(outside ? outside : ends_);
        planner_.setRange(range);
        planner_.setProblemDefinition(definition_);
        planner_.setup();
    }

    /// Takes over the states that were added.
    void follow(const TwistTree& start, const TwistTree* goal) {
        for (std::size_t i = definition_->getStartStateCount(); i < start.free().size(); ++i)
            definition_->addStartState(start.stateOf(*start.free()[i]));
        if (goal == nullptr) return;
        for (std::size_t i = ends_->getStateCount(); i < goal->free().size(); ++i)
            ends_->addState(goal->stateOf(*goal->free()[i]));
    }

    bool takeTurn(const std::function<bool()>& isSpent) {
        unsigned int asked = 0;
        definition_->clearSolutionPaths();
        const ob::PlannerTerminationCondition isOver([&] { return asked++ >= kJoiningTurn || isSpent(); });
        return planner_.solve(isOver) == ob::PlannerStatus::EXACT_SOLUTION;
    }

    std::vector<ob::State*> states() const {
        return definition_->getSolutionPath()->as<og::PathGeometric>()->getStates();
    }

    void addData(ob::PlannerData& data) const { planner_.getPlannerData(data); }

  private:
    og::RRTConnect planner_;
    ob::ProblemDefinitionPtr definition_;
    std::shared_ptr<ob::GoalStates> ends_;
};

struct TwistSearch::Parts {
    explicit Parts(const ob::SpaceInformationPtr& si)
        : clearance(sceneOf(si).clearance()), moves(*si->getStateSpace(), clearance->scene().part) {}

    std::shared_ptr<const SceneClearance> clearance;
    PartMoves moves;
    std::unique_ptr<TwistTree> start, goal;  ///< goal: null for OutsideGoal
    std::unique_ptr<Joint> joint;
};

TwistSearch::TwistSearch(const ob::SpaceInformationPtr& si) : Planner(si, "TwistSearch") {
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    declareParam<double>("range", this, &TwistSearch::setRange, &TwistSearch::getRange, "0.:1.:10000.");
}

TwistSearch::~TwistSearch() = default;

void TwistSearch::setup() {
    if (!parts_) parts_ = std::make_unique<Parts>(si_);
    Planner::setup();
}

/// Trees belong to the goal that they were made for.
void TwistSearch::setProblemDefinition(const ob::ProblemDefinitionPtr& definition) {
    if (pdef_ && definition != pdef_) clear();
    Planner::setProblemDefinition(definition);
}

void TwistSearch::clear() {
    Planner::clear();
    parts_.reset();
    setup_ = false;
    isExhausted_ = false;
}

bool TwistSearch::isTight(const ob::SpaceInformationPtr& si, const ob::State* state) {
    const Parts parts(si);
    const SceneClearance::ColdStart cold(*parts.clearance);
    return TwistTree::isTight(*parts.clearance, parts.moves, parts.moves.pose(state));
}

const std::vector<TwistTree::TrackEnd>& TwistSearch::ends() const {
    static const std::vector<TwistTree::TrackEnd> none;
    return parts_ && parts_->start ? parts_->start->ends() : none;
}

void TwistSearch::addSolution(const std::vector<const ob::State*>& states) {
    const auto path = std::make_shared<og::PathGeometric>(si_);
    for (const ob::State* state : states) path->append(state);
    pdef_->addSolutionPath(path, false, 0, getName());
}

/// Returns whether there is a root at each end that needs one.
bool TwistSearch::addRoots(const ob::PlannerTerminationCondition& isSpent) {
    while (const ob::State* state = pis_.nextStart()) {
        parts_->start->addRoot(state);
        isExhausted_ = false;
    }
    if (!parts_->goal) return parts_->start->rootCount() > 0;
    if (parts_->goal->rootCount() < kMostGoalRoots) {
        const ob::State* state = parts_->goal->rootCount() == 0 ? pis_.nextGoal(isSpent) : pis_.nextGoal();
        if (state != nullptr) {
            parts_->goal->addRoot(state);
            isExhausted_ = false;
        }
    }
    return parts_->start->rootCount() > 0 && parts_->goal->rootCount() > 0;
}

/// Takes a turn at joining the states where the part is free. Returns whether there is a path.
bool TwistSearch::join(const ob::PlannerTerminationCondition& isSpent) {
    TwistTree& start = *parts_->start;
    TwistTree* goal = parts_->goal.get();
    if (!parts_->joint) {
        const ob::GoalPtr outside = goal == nullptr ? pdef_->getGoal() : nullptr;
        parts_->joint = std::make_unique<Joint>(si_, range_, outside);
    }
    parts_->joint->follow(start, goal);
    if (!parts_->joint->takeTurn([&] { return isSpent.eval(); })) return false;
    const std::vector<ob::State*> middle = parts_->joint->states();
    const TwistTree::Node* first = nodeAt(start, *si_, middle.front());
    const TwistTree::Node* last = goal != nullptr ? nodeAt(*goal, *si_, middle.back()) : nullptr;
    if (first == nullptr || (goal != nullptr && last == nullptr)) return false;
    std::vector<const ob::State*> states = start.pathTo(*first);
    states.insert(states.end(), middle.begin() + 1, middle.end());
    if (last != nullptr) {
        const std::vector<const ob::State*> end = goal->pathTo(*last);
        states.insert(states.end(), end.rbegin() + 1, end.rend());
    }
    addSolution(states);
    return true;
}

ob::PlannerStatus TwistSearch::solve(const ob::PlannerTerminationCondition& isSpent) {
    checkValidity();
    const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
    if (goal == nullptr) {
        OMPL_ERROR("%s: Unknown type of goal", getName().c_str());
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    }
    const auto* outside = dynamic_cast<const OutsideGoal*>(goal);
    Parts& parts = *parts_;
    if (!parts.start) {
        parts.start = std::make_unique<TwistTree>(si_, *parts.clearance, parts.moves, outside, true);
        if (outside == nullptr)
            parts.goal = std::make_unique<TwistTree>(si_, *parts.clearance, parts.moves, nullptr, false);
    }
    if (!addRoots(isSpent)) {
        const bool hasStart = parts.start->rootCount() > 0;
        OMPL_ERROR("%s: There are no valid %s states!", getName().c_str(), hasStart ? "goal" : "initial");
        return hasStart ? ob::PlannerStatus::INVALID_GOAL : ob::PlannerStatus::INVALID_START;
    }
    while (!isSpent) {
        bool isLeft = parts.start->atGoal() != nullptr || parts.start->work();
        if (parts.start->atGoal() != nullptr) {
            addSolution(parts.start->pathTo(*parts.start->atGoal()));
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (parts.goal && parts.goal->work()) isLeft = true;
        const bool isJoinable = !parts.start->free().empty() && (!parts.goal || !parts.goal->free().empty());
        if (isJoinable && join(isSpent)) return ob::PlannerStatus::EXACT_SOLUTION;
        if (isLeft || isJoinable) continue;
        const std::size_t goals = parts.goal ? parts.goal->rootCount() : 0;
        if (goals > 0 && addRoots(isSpent) && parts.goal->rootCount() > goals) continue;
        isExhausted_ = true;
        break;
    }
    return ob::PlannerStatus::TIMEOUT;
}

void TwistSearch::getPlannerData(ob::PlannerData& data) const {
    Planner::getPlannerData(data);
    if (!parts_ || !parts_->start) return;
    parts_->start->addData(data);
    if (parts_->goal) parts_->goal->addData(data);
    if (parts_->joint) parts_->joint->addData(data);
}

}  // namespace clearway::planning
