#include "clearway/planning/sliding_rrt_connect.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/tools/config/SelfConfig.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "clearway/planning/clearance_objectives.h"
#include "planning/check/forward_check.h"
#include "planning/planners/slide_contacts.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {

namespace {

// Shares of half the diagonal of the part's box.
constexpr double kLeastStandoff = 0.005, kMostStandoff = 0.1;
constexpr double kRange = 0.5;
constexpr double kLeastStep = 0.001;                    ///< shorter ones count as no progress
constexpr double kFirstDomain = 1, kLeastDomain = 0.3;  ///< a node's radius after its first failure

constexpr double kLeastStepStandoffs = 0.05;
/// In standoffs: how near to a blocked pose the last certified one is looked for, and the step back from that one.
constexpr double kNearBlock = 1, kStepBack = 0.2;
constexpr int kMostSteps = 30, kMostShortSteps = 2;
constexpr double kDomainGrowth = 1.1, kDomainLoss = 0.9;

}  // namespace

struct SlidingRRTConnect::Lengths {
    Lengths(const ob::SpaceInformationPtr& si, const SlidingRRTConnect& planner)
        : clearance(sceneOf(si).clearance()),
          moves(*si->getStateSpace(), clearance->scene().part),
          certify(si) {
        const double radius = moves.radius();
        range = planner.range_ > 0 ? planner.range_ : kRange * radius;
        leastStandoff = planner.leastStandoff_ > 0 ? planner.leastStandoff_ : kLeastStandoff * radius;
        mostStandoff = std::max(leastStandoff,
                                planner.mostStandoff_ > 0 ? planner.mostStandoff_ : kMostStandoff * radius);
    }

    std::shared_ptr<const SceneClearance> clearance;
    PartMoves moves;
    ForwardCheck certify;
    double range, leastStandoff, mostStandoff;
};

/// A state of a tree. Between two nodes of the tree lie points of the slide that joins them.
struct SlidingRRTConnect::Node {
    ob::State* state;
    Node* parent;
    double domain = std::numeric_limits<double>::infinity();  ///< samples farther away are not for this node
};

struct SlidingRRTConnect::Tree {
    Tree(const ob::Planner* planner, bool isStart)
        : si(planner->getSpaceInformation()),
          isFromStart(isStart),
          nodes(ompl::tools::SelfConfig::getDefaultNearestNeighbors<Node*>(planner)) {
        nodes->setDistanceFunction(
            [this](const Node* a, const Node* b) { return si->distance(a->state, b->state); });
    }
    ~Tree() { clear(); }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;

    void clear() {
        nodes->clear();
        for (const auto& node : all) si->freeState(node->state);
        all.clear();
    }
    Node* nearest(const ob::State* state) const {
        Node probe{const_cast<ob::State*>(state), nullptr};
        return nodes->nearest(&probe);
    }

    ob::SpaceInformationPtr si;
    bool isFromStart;
    std::shared_ptr<ompl::NearestNeighbors<Node*>> nodes;
    std::vector<std::unique_ptr<Node>> all;
};

SlidingRRTConnect::SlidingRRTConnect(const ob::SpaceInformationPtr& si) : Planner(si, "SlidingRRTConnect") {
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    declareParam<double>("range", this, &SlidingRRTConnect::setRange, &SlidingRRTConnect::getRange,
                         "0.:1.:10000.");
    declareParam<double>("least_standoff", this, &SlidingRRTConnect::setLeastStandoff,
                         &SlidingRRTConnect::getLeastStandoff, "0.:.01:100.");
    declareParam<double>("most_standoff", this, &SlidingRRTConnect::setMostStandoff,
                         &SlidingRRTConnect::getMostStandoff, "0.:.01:1000.");
}

SlidingRRTConnect::~SlidingRRTConnect() = default;

void SlidingRRTConnect::setup() {
    Planner::setup();
    lengths_ = std::make_unique<Lengths>(si_, *this);
    if (!start_) {
        start_ = std::make_unique<Tree>(this, true);
        goal_ = std::make_unique<Tree>(this, false);
    }
}

void SlidingRRTConnect::clear() {
    Planner::clear();
    sampler_.reset();
    if (start_) start_->clear();
    if (goal_) goal_->clear();
    isStartNext_ = true;
}

SlidingRRTConnect::Node* SlidingRRTConnect::addPoint(Tree& tree, Node* parent, const ob::State* state) const {
    tree.all.push_back(std::make_unique<Node>(Node{si_->cloneState(state), parent}));
    return tree.all.back().get();
}

void SlidingRRTConnect::addRoot(Tree& tree, const ob::State* state) const {
    tree.nodes->add(addPoint(tree, nullptr, state));
}

/// One extension of a tree: moves on to its target, along contacts where it must.
class SlidingRRTConnect::Extension {
  public:
    Extension(const SlidingRRTConnect& planner, Tree& tree, Node* from, double standoff)
        : planner_(planner),
          lengths_(*planner.lengths_),
          moves_(lengths_.moves),
          tree_(tree),
          at_(from),
          node_(from),
          standoff_(standoff),
          contacts_(*planner.si_, *lengths_.clearance, lengths_.moves, standoff),
          next_(*planner.si_),
          blocked_(*planner.si_) {}

    /// Returns the last node, which is the one begun from when the extension added none.
    Node* run(const ob::State* target, double reach) {
        int shortSteps = 0;
        for (int step = 0; step < kMostSteps && reach > 0; ++step) {
            const std::optional<bool> isWhole = contacts_.step(at_->state, target, reach, next_.get());
            if (!isWhole) break;
            const Node* before = at_;
            const bool isFree = advance();
            const double moved = before == at_ ? 0 : moves_.between(before->state, at_->state).norm();
            reach -= moved;
            sinceNode_ += moved;
            if (isFree && *isWhole) {
                isReached_ = true;
                break;
            }
            if (sinceNode_ >= lengths_.mostStandoff) makeNode();
            const double least = std::max(kLeastStep * moves_.radius(), kLeastStepStandoffs * standoff_);
            shortSteps = moved < least ? shortSteps + 1 : 0;
            if (shortSteps == kMostShortSteps) break;
            if (!isFree) {
                contacts_.lookAround(blocked_.get());
            } else if (!contacts_.areNone()) {
                contacts_.lookAround(at_->state);
            }
        }
        if (isReached_ || sinceNode_ >= 0.2 * lengths_.mostStandoff) makeNode();
        return node_;
    }

    bool isReached() const { return isReached_; }

  private:
    void makeNode() {
        if (at_ == node_) return;
        tree_.nodes->add(at_);
        node_ = at_;
        sinceNode_ = 0;
    }

    /// Moves on to next_, or to a little before where that motion is blocked. Returns whether it is not blocked.
    bool advance() {
        const ob::SpaceInformation& si = *planner_.si_;
        const double until = lengths_.certify(at_->state, next_.get(), kNearBlock * standoff_);
        const bool isFree = until == 1;
        if (!isFree) {
            const ob::StateSpace& space = *si.getStateSpace();
            si.copyState(blocked_.get(), at_->state);
            if (until > 0) space.interpolate(at_->state, next_.get(), until, blocked_.get());
            const double way = moves_.between(at_->state, next_.get()).norm();
            const double time = until - kStepBack * standoff_ / way;
            if (!(time > 0)) return false;
            const ScratchState end(si);
            si.copyState(end.get(), next_.get());
            space.interpolate(at_->state, end.get(), time, next_.get());
        }
        // The motion to where it was cut is another motion for OMPL, and paths take those of the goal's tree in reverse.
        if (!isFree || !tree_.isFromStart) {
            const ob::State *first = at_->state, *last = next_.get();
            if (!tree_.isFromStart) std::swap(first, last);
            if (!si.checkMotion(first, last)) return false;
        }
        at_ = planner_.addPoint(tree_, at_, next_.get());
        return isFree;
    }

    const SlidingRRTConnect& planner_;
    const Lengths& lengths_;
    const PartMoves& moves_;
    Tree& tree_;
    Node *at_, *node_;
    double standoff_, sinceNode_ = 0;
    SlideContacts contacts_;
    bool isReached_ = false;
    ScratchState next_, blocked_;  ///< blocked_: the last pose that is certified
};

SlidingRRTConnect::Node* SlidingRRTConnect::extend(Tree& tree, Node* from, const ob::State* target,
                                                   double reach, bool& isReached) {
    const double least = std::log(lengths_->leastStandoff), most = std::log(lengths_->mostStandoff);
    Extension extension(*this, tree, from, std::exp(random_.uniformReal(least, most)));
    Node* last = extension.run(target, reach);
    isReached = extension.isReached();
    return last;
}

void SlidingRRTConnect::addSolution(const Node* inStart, const Node* inGoal, bool isExact) {
    const auto path = std::make_shared<og::PathGeometric>(si_);
    std::vector<const ob::State*> states;
    for (const Node* node = inStart; node != nullptr; node = node->parent) states.push_back(node->state);
    std::reverse(states.begin(), states.end());
    for (const Node* node = isExact ? inGoal->parent : nullptr; node != nullptr; node = node->parent) {
        states.push_back(node->state);
    }
    for (const ob::State* state : states) path->append(state);
    const double apart = isExact ? 0 : si_->distance(inStart->state, inGoal->state);
    pdef_->addSolutionPath(path, !isExact, apart, getName());
}

/// Adds goals while there are few of them for the size of the tree.
bool SlidingRRTConnect::addGoals(const ob::PlannerTerminationCondition& isSpent) {
    const bool isFirst = goal_->nodes->size() == 0;
    if (isFirst || pis_.getSampledGoalsCount() < goal_->nodes->size() / 2) {
        const ob::State* state = isFirst ? pis_.nextGoal(isSpent) : pis_.nextGoal();
        if (state != nullptr) addRoot(*goal_, state);
    }
    return goal_->nodes->size() > 0;
}

ob::PlannerStatus SlidingRRTConnect::solve(const ob::PlannerTerminationCondition& isSpent) {
    checkValidity();
    const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
    if (goal == nullptr) {
        OMPL_ERROR("%s: Unknown type of goal", getName().c_str());
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    }
    while (const ob::State* state = pis_.nextStart()) addRoot(*start_, state);
    if (start_->nodes->size() == 0) {
        OMPL_ERROR("%s: There are no valid initial states!", getName().c_str());
        return ob::PlannerStatus::INVALID_START;
    }
    if (!goal->couldSample()) {
        OMPL_ERROR("%s: Insufficient states in sampleable goal region", getName().c_str());
        return ob::PlannerStatus::INVALID_GOAL;
    }
    if (!sampler_) sampler_ = si_->allocStateSampler();
    const ScratchState sample(*si_);
    std::pair<const Node*, const Node*> closest(nullptr, nullptr);
    double least = std::numeric_limits<double>::infinity();
    while (!isSpent) {
        if (!addGoals(isSpent)) {
            OMPL_ERROR("%s: Unable to sample any valid states for goal tree", getName().c_str());
            return ob::PlannerStatus::INVALID_GOAL;
        }
        Tree &tree = treeOf(isStartNext_), &other = treeOf(!isStartNext_);
        isStartNext_ = !isStartNext_;
        sampler_->sampleUniform(sample.get());
        Node* near = tree.nearest(sample.get());
        const PartMoves& moves = lengths_->moves;
        if (moves.between(near->state, sample.get()).norm() > near->domain) continue;
        bool isReached = false;
        Node* added = extend(tree, near, sample.get(), lengths_->range, isReached);
        const double radius = moves.radius();
        if (added == near) {
            const bool isFirst = std::isinf(near->domain);
            near->domain =
                isFirst ? kFirstDomain * radius : std::max(kLeastDomain * radius, kDomainLoss * near->domain);
            continue;
        }
        near->domain *= kDomainGrowth;
        Node* towards = other.nearest(added->state);
        towards = extend(other, towards, added->state, std::numeric_limits<double>::infinity(), isReached);
        const Node *inStart = tree.isFromStart ? added : towards,
                   *inGoal = tree.isFromStart ? towards : added;
        const double apart = si_->distance(inStart->state, inGoal->state);
        if (isReached) {
            addSolution(inStart, inGoal, true);
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (apart < least) {
            least = apart;
            closest = {inStart, inGoal};
        }
    }
    if (closest.first == nullptr) return ob::PlannerStatus::TIMEOUT;
    addSolution(closest.first, closest.second, false);
    return ob::PlannerStatus::APPROXIMATE_SOLUTION;
}

void SlidingRRTConnect::getPlannerData(ob::PlannerData& data) const {
    Planner::getPlannerData(data);
    if (!start_) return;
    for (const Tree* tree : {start_.get(), goal_.get()}) {
        const int tag = tree->isFromStart ? 1 : 2;
        for (const auto& node : tree->all) {
            const ob::PlannerDataVertex vertex(node->state, tag);
            if (node->parent == nullptr) {
                tree->isFromStart ? data.addStartVertex(vertex) : data.addGoalVertex(vertex);
            } else if (tree->isFromStart) {
                data.addEdge(ob::PlannerDataVertex(node->parent->state, tag), vertex);
            } else {
                data.addEdge(vertex, ob::PlannerDataVertex(node->parent->state, tag));
            }
        }
    }
}

}  // namespace clearway::planning
