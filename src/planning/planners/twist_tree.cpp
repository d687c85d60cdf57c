#include "planning/planners/twist_tree.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>
#include <utility>

#include "model/principal_axes.h"
#include "planning/planners/twist_directions.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

// Shares of half the diagonal of the part's box.
constexpr double kTightGap =
    0.012;  ///< gaps of tight fits were up to .0106, those of other problems from .014 on
constexpr double kWidestBand = 0.05;
constexpr double kShortestStep = 2e-3, kFinest = 1e-5;  ///< however small the gap is
constexpr double kLeastScore = 0.03;                    ///< directions that are free for less lead nowhere

// In gaps of the centred part.
constexpr double kBand = 3;
constexpr double kLeastFree = 5;  ///< directions that are free for less lead nowhere
constexpr double kStep = 12;      ///< between the poses that are looked at along a screw
constexpr double kContactInterval = 0.2, kFloor = 0.3;

constexpr int kCentrings = 2;
constexpr double kCutFloor = 0.05;    ///< of a floor, kept by OMPL's motions
constexpr double kNearlyFloor = 0.9;  ///< of a floor; a capped clearance is known so far
constexpr double kSpare = 0.25;       ///< of the clearance where a motion begins
constexpr double kTurning = 0.1;      ///< of a direction's length: directions that turn less are translations
constexpr double kInwards = 0.5;      ///< of a score, where the goal comes no nearer
constexpr double kLeastProbed = 0.1;  ///< of the radius
constexpr int kMostFound = 4;         ///< directions by probes along one track
constexpr double kMostTurn = 1;       ///< radians of a motion
constexpr int kRaisedAfter = 3;       ///< valid motions, until a longer one is tried
constexpr double kRest = 0.2;         ///< of a step: a shorter rest is added to it

/// The k-th of places spread evenly over [0, 1], coarse ones first (van der Corput).
double placeOf(int k) {
    double place = 0, share = 0.5;
    for (int rest = k + 1; rest > 0; rest /= 2, share *= 0.5) place += share * (rest % 2);
    return place;
}

/// A derived class may judge motions in its own way: null for one.
const MotionValidator* plainValidatorOf(const ob::SpaceInformation& si) {
    const auto* validator = dynamic_cast<const MotionValidator*>(si.getMotionValidator().get());
    return validator != nullptr && typeid(*validator) == typeid(MotionValidator) ? validator : nullptr;
}

}  // namespace

TwistTree::TwistTree(ob::SpaceInformationPtr si, const SceneClearance& clearance, const PartMoves& moves,
                     const ob::GoalRegion* goal, bool isFromStart)
    : si_(std::move(si)),
      clearance_(clearance),
      moves_(moves),
      goal_(goal),
      isFromStart_(isFromStart),
      validator_(plainValidatorOf(*si_)),
      principalAxes_(principalAxesOf(clearance.scene().part)) {}

TwistTree::~TwistTree() {
    for (const auto& node : nodes_) {
        si_->freeState(node->state);
        for (ob::State* state : node->states) si_->freeState(state);
    }
}

bool TwistTree::isTight(const SceneClearance& clearance, const PartMoves& moves,
                        const Pose& X_environmentPart) {
    ClearanceOptions options;
    options.cap = kTightGap * moves.radius();
    options.isRough = true;
    const double lower = clearance.at(X_environmentPart, options).lower;
    return lower > 0 && lower < *options.cap;
}

void TwistTree::addRoot(const ob::State* state) {
    const Screw none{Vector3::Zero(), Vector3::Zero()};
    nodes_.push_back(std::make_unique<Node>(Node{
        si_->cloneState(state), moves_.pose(state), nullptr, none, nodes_.size(), 0, 0, 0, 0, 0, true, {}}));
    Node& root = *nodes_.back();
    root.toGoal = goalDistance(root);
    if (goal_ != nullptr && goal_->isSatisfied(root.state)) atGoal_ = &root;
    ++rootCount_;
    findClearance(root);
    play_ = root.play = std::min(kFreeGap * moves_.radius(), root.clearance);
    rootPlay_ = std::max(rootPlay_, play_);
    if (!(play_ > 0)) return;
    if (root.clearance >= kTightGap * moves_.radius()) {
        free_.push_back(&root);
        return;
    }
    lookAround(root, nullptr);
}

/// Goes along the screw in motions of OMPL's that are valid: shorter ones after a refusal, longer ones after some successes. Returns the
/// node at the end, or where it is blocked; null when that is where it began.
TwistTree::Node* TwistTree::grow(Node* parent, const Screw& screw, double time) {
    const double floor = floorFrom(*parent);
    const double angle = time * screw.angular.norm(),
                 longest = std::min(1.0, kMostTurn / std::max(angle, kMostTurn)),
                 least =
                     resolution() /
                     (time * motionAlong(screw, parent->X_environmentPart, clearance_.scene().part).length);
    std::vector<ob::State*> states;
    const ob::State* last = parent->state;
    const ScratchState next(*si_);
    double step = longest, done = 0;
    for (int successes = 0; done < 1 && step >= std::min(least, longest);) {
        const double end = done + (1 + kRest) * step >= 1 ? 1 : done + step;
        moves_.setPose(movedAlong(screw, parent->X_environmentPart, end * time), next.get());
        if (!isValidMotion(last, next.get(), kCutFloor * floor)) {
            step *= 0.5;
            successes = 0;
            continue;
        }
        done = end;
        states.push_back(si_->cloneState(next.get()));
        last = states.back();
        if (++successes >= kRaisedAfter && 2 * step <= longest) {
            step *= 2;
            successes = 0;
        }
    }
    if (states.empty()) return nullptr;
    ob::State* state = states.back();
    states.pop_back();
    nodes_.push_back(
        std::make_unique<Node>(Node{state, moves_.pose(state), parent, screw * (done * time), nodes_.size(),
                                    parent->depth, 0, done * time, play_, 0, done == 1, std::move(states)}));
    Node& node = *nodes_.back();
    node.toGoal = goalDistance(node);
    findClearance(node);
    return &node;
}

/// A motion that must keep clearance is certified sooner than one that may graze.
bool TwistTree::isValidMotion(const ob::State* from, const ob::State* to, double floor) const {
    if (!isFromStart_) std::swap(from, to);
    return validator_ != nullptr ? validator_->keepsClearance(from, to, floor) : si_->checkMotion(from, to);
}

Twist TwistTree::twistOf(const Screw& screw, const Node& node) const {
    Twist twist;
    twist.head<3>() = screw.velocity + screw.angular.cross(moves_.centre(node.X_environmentPart));
    twist.tail<3>() = moves_.lever() * screw.angular;
    return twist;
}

Screw TwistTree::screwOf(const Twist& twist, const Node& node) const {
    const Vector3 angular = twist.tail<3>() / moves_.lever();
    return {angular, twist.head<3>() - angular.cross(moves_.centre(node.X_environmentPart))};
}

void TwistTree::findClearance(Node& node) const {
    ClearanceOptions options;
    options.cap = kFreeGap * moves_.radius();
    options.isRough = true;
    node.clearance = clearance_.at(node.X_environmentPart, options).lower;
}

/// How closely it is found where a screw is blocked. Tiny gaps must not make for endless steps.
double TwistTree::resolution() const {
    return std::max(kContactInterval * play_, kFinest * moves_.radius());
}

double TwistTree::band() const {
    return std::min(kBand * play_, kWidestBand * moves_.radius());
}

/// The clearance that motions from a node keep.
double TwistTree::floorFrom(const Node& node) const {
    return std::min(kFloor * play_, kSpare * node.clearance);
}

/// Looks at poses in steps: a sweep would cost as much as the certificate of the motions, which follows.
TwistTree::Advance TwistTree::advance(const Node& from, const Screw& screw) const {
    const double speed = motionAlong(screw, from.X_environmentPart, clearance_.scene().part).length;
    const double floor = floorFrom(from);
    const double step = std::min(1.0, std::max(kStep * play_, kShortestStep * moves_.radius()) / speed);
    const ScratchState at(*si_);
    ClearanceOptions asked;
    asked.cap = floor;
    asked.isRough = asked.isOutside = true;
    const auto isFreeAt = [&](double time) {
        moves_.setPose(movedAlong(screw, from.X_environmentPart, time), at.get());
        return si_->satisfiesBounds(at.get()) &&
               clearance_.at(moves_.pose(at.get()), asked).lower > kNearlyFloor * floor;
    };
    double free = 0, blocked = step;
    while (isFreeAt(blocked)) {
        free = blocked;
        if (blocked == 1) return {1, true};
        blocked = std::min(1.0, blocked + step);
    }
    while ((blocked - free) * speed > resolution()) {
        const double middle = 0.5 * (free + blocked);
        (isFreeAt(middle) ? free : blocked) = middle;
    }
    return {free, false};
}

void TwistTree::lookAround(Node& at, const Twist* arrived) {
    Node* centred = &at;
    for (int k = 0; k < kCentrings; ++k) {
        Node* next = centre(centred, Twist::Zero());
        if (next == centred) break;
        centred = next;
    }
    Node& node = *centred;
    const std::vector<ContactRow> rows = rowsNear(clearance_, moves_, node.X_environmentPart, band());
    if (rows.empty() && band() >= kFreeGap * moves_.radius()) {
        free_.push_back(&node);
        return;
    }
    const TwistDirections directions =
        directionsAlong(rows, node.X_environmentPart.rotation * principalAxes_, moves_, play_, random_);
    const auto add = [&](const std::vector<Twist>& found, std::vector<Candidate>& to) {
        for (auto each = found.rbegin(); each != found.rend(); ++each) {  // the first one is taken first
            if (arrived != nullptr && -arrived->dot(*each) > kWayBack) continue;
            to.push_back({&node, screwOf(*each, node)});
        }
    };
    for (const Screw& known : library_) {
        const Twist twist = twistOf(known, node).normalized();
        for (const double sign : {1.0, -1.0}) {
            if (arrived == nullptr || -arrived->dot(sign * twist) < kWayBack)
                unscored_.push_back({&node, screwOf(sign * twist, node), 0, 0, false, true});
        }
    }
    add(directions.open, unscored_);
    add(directions.late, late_);
}

void TwistTree::score(const Candidate& candidate) {
    play_ = candidate.node->play;
    const double length = moves_.radius();
    const Advance found = advance(*candidate.node, candidate.screw * length);
    Candidate scored = candidate;
    scored.length = (found.isWhole ? 1 : kBackOff) * found.time * length;
    if (scored.length < std::min(kLeastScore * length, kLeastFree * play_)) return;
    if (!candidate.isReverse) unscored_.push_back({candidate.node, candidate.screw * -1, 0, 0, false, true});
    scored.score = found.time;
    const ScratchState end(*si_);
    moves_.setPose(movedAlong(candidate.screw, candidate.node->X_environmentPart, scored.length), end.get());
    if (goal_ != nullptr) {
        if (goal_->isSatisfied(end.get())) return begin(scored);
        scored.isInwards = !leadsNearer(candidate);
    }
    if (isOld(end.get(), nodes_.size())) return;
    // Where one way along a track is open, so is often the other, though the direction is not known well enough to show it.
    for (Candidate& other : open_) {
        const Twist a = twistOf(other.screw, *other.node), b = twistOf(scored.screw, *scored.node);
        if (other.node != scored.node || a.dot(b) > -kWayBack) continue;
        if (other.isInwards != scored.isInwards)
            (scored.isInwards ? other : scored).score = std::max(other.score, scored.score);
    }
    open_.push_back(scored);
}

/// Whether the goal comes nearer along a screw: after a whole turn, because a turn alone changes the box that the goal looks at.
bool TwistTree::leadsNearer(const Candidate& candidate) const {
    const Vector3& angular = candidate.screw.angular;
    const double rate = angular.norm(), advance = rate > 0 ? candidate.screw.velocity.dot(angular) / rate : 0;
    const bool isTurning = rate * moves_.lever() > kTurning;
    Pose to = candidate.node->X_environmentPart;
    if (isTurning && std::abs(advance) < kAdvancing * rate * moves_.lever()) return false;
    to.translation += isTurning ? Vector3(2 * M_PI / rate * advance / rate * angular)
                                : Vector3(moves_.radius() * candidate.screw.velocity);
    const ScratchState end(*si_);
    moves_.setPose(to, end.get());
    return goal_->distanceGoal(end.get()) < candidate.node->toGoal;
}

double TwistTree::priorityOf(const Candidate& candidate) const {
    return candidate.score * std::pow(kDepthLoss, candidate.node->depth) *
           (candidate.isInwards ? kInwards : 1);
}

void TwistTree::begin(const Candidate& candidate) {
    play_ = candidate.node->play;
    track_ = std::make_unique<Track>(Track{candidate.node, candidate.screw, candidate.length, nodes_.size()});
}

bool TwistTree::work() {
    if (track_) {
        followOn();
        return true;
    }
    if (!unscored_.empty()) {
        const Candidate next = unscored_.back();
        unscored_.pop_back();
        score(next);
        return true;
    }
    if (open_.empty() && !late_.empty()) {
        std::swap(unscored_, late_);
        return true;
    }
    const auto best = std::max_element(
        open_.begin(), open_.end(),
        [&](const Candidate& a, const Candidate& b) { return priorityOf(a) < priorityOf(b); });
    const bool isProbeFirst =
        !probes_.empty() && (best == open_.end() || priorityOf(*best) < probes_.back().priority);
    if (isProbeFirst) {
        probe();
        return true;
    }
    if (best == open_.end()) return false;
    const Candidate next = *best;
    open_.erase(best);
    begin(next);
    return true;
}

void TwistTree::probe() {
    Probe& places = probes_.back();
    if (places.next >= places.count || places.found == kMostFound) {
        probes_.pop_back();
        return;
    }
    double left = placeOf(places.next++) * places.length;
    for (Node* node : places.nodes) {
        if (left > node->length || node->length == 0) {
            left -= node->length;
            continue;
        }
        const Screw along = node->screw * (1 / node->length);
        Node place = *node->parent;
        place.X_environmentPart = movedAlong(along, node->parent->X_environmentPart, left);
        const Twist track = twistOf(along, place).normalized();
        Candidate best{nullptr, along};
        for (const Screw& known : library_) {
            const Twist twist = twistOf(known, place);
            if (std::abs(twist.normalized().dot(track)) > kWayBack) continue;
            for (const double sign : {1.0, -1.0}) {
                const Screw screw = known * (sign / twist.norm());
                const double share = advance(place, screw * moves_.radius()).time;
                if (share > std::max(kLeastProbed, best.score)) {
                    best.screw = screw;
                    best.score = share;
                }
            }
        }
        if (best.score > 0) {
            ++places.found;
            Node* made = grow(node->parent, along, left);
            if (made == nullptr) return;
            made->depth = node->depth + 1;
            unscored_.push_back({made, best.screw});
        }
        return;
    }
}

void TwistTree::addData(ob::PlannerData& data) const {
    const int tag = isFromStart_ ? 1 : 2;
    for (const auto& node : nodes_) {
        if (node->parent == nullptr) {
            const ob::PlannerDataVertex root(node->state, tag);
            isFromStart_ ? data.addStartVertex(root) : data.addGoalVertex(root);
            continue;
        }
        const ob::State* last = node->parent->state;
        const auto goTo = [&](const ob::State* state) {
            ob::PlannerDataVertex from(last, tag), to(state, tag);
            isFromStart_ ? data.addEdge(from, to) : data.addEdge(to, from);
            last = state;
        };
        for (const ob::State* state : node->states) goTo(state);
        goTo(node->state);
    }
}

std::vector<const ob::State*> TwistTree::pathTo(const Node& wanted) const {
    std::vector<const Node*> way;
    for (const Node* node = &wanted; node != nullptr; node = node->parent) way.push_back(node);
    std::vector<const ob::State*> states;
    for (auto node = way.rbegin(); node != way.rend(); ++node) {
        states.insert(states.end(), (*node)->states.begin(), (*node)->states.end());
        states.push_back((*node)->state);
    }
    return states;
}

}  // namespace clearway::planning
