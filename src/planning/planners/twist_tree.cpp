#include "planning/planners/twist_tree.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "model/principal_axes.h"
#include "planning/improve/least_twist.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

// Shares of half the diagonal of the part's box.
constexpr double kTightGap =
    0.012;  ///< measured: gaps of tight fits are up to .0106, of other problems from .014 on
constexpr double kFreeGap = 0.05, kWidestBand = 0.05;
constexpr std::array<double, 4> kLookAheads = {
    2, 0.5, 0.1, 0.02};              ///< of directions that leave the gaps open; a gap is the last one
constexpr double kLeastTrack = 0.1;  ///< whose direction is tried elsewhere

// In gaps of the centred part.
constexpr double kLeastCertified = 5;  ///< directions that certify less lead nowhere
constexpr double kBand = 3, kShortAdvance = 0.3;
constexpr double kStep = 12, kContactInterval = 0.2, kFloor = 0.3,
                 kCentreBelow = 0.6;  ///< of sweeps

constexpr int kCentrings = 2, kRandomDirections = 10, kMostShortAdvances = 3, kRefinements = 3,
              kCentreBisections = 7;
constexpr double kLikeDirection = 0.98;  ///< cosine of twists that count as one
constexpr double kWayBack = 0.9;         ///< cosine with the way back, which is not tried
constexpr double kAcross = 0.5;          ///< of a contact's row: one that acts less across the track is ahead
constexpr double kLeastMoved = 0.3;      ///< of a unit direction that contacts turn aside
constexpr double kBackOff = 0.8;         ///< of what is certified ahead of a block
constexpr double kCutFloor = 0.05;       ///< of a floor that OMPL's motions keep
constexpr double kNearlyFloor = 0.9;     ///< of a floor that a capped clearance is known to
constexpr double kPlayLoss = 0.7, kPlayGrowth = 2, kLeastPlay = 0.1;  ///< of the root's
constexpr double kSpare = 0.25;       ///< of the clearance where a motion begins
constexpr double kTurning = 0.1;      ///< of a direction's length: directions that turn less are translations
constexpr double kAdvancing = 1e-3;   ///< of the turn: screws that advance less are turns
constexpr double kLeastScore = 0.03;  ///< directions that certify less lead nowhere
constexpr double kDepthLoss = 0.8;    ///< of a score, for each track from the root
constexpr double kInwards = 0.5;      ///< of a score, where the goal comes no nearer
constexpr double kWidened = 1.5;      ///< times the clearance where a pull was tried last
constexpr double kLeastLength = 0.02;  ///< in gaps
constexpr int kMostDoublings = 6, kPullBisections = 20;
constexpr double kWider = 3;  ///< last advances that the next screw is chosen by
constexpr double kProbeScore = 0.3, kLeastProbed = 0.1;
constexpr int kMostPlaces = 512, kMostFound = 4;
constexpr std::size_t kMostLibrary = 6;
constexpr double kMostTurn = 1, kMostSecant = 2.5;  ///< radians
constexpr int kRaisedAfter = 3;
constexpr double kRest = 0.2;  ///< of a step: a shorter rest is added to it

/// The k-th of places spread evenly over [0, 1], coarse ones first (van der Corput).
double placeOf(int k) {
    double place = 0, share = 0.5;
    for (int rest = k + 1; rest > 0; rest /= 2, share *= 0.5) place += share * (rest % 2);
    return place;
}

/// Where a screw leads a part: along its axis, or a point of the part if the screw only turns.
Vector3 headingOf(const Screw& screw, const Vector3& point) {
    const double rate = screw.angular.norm();
    const Vector3 along = rate > 0
                              ? Vector3(screw.velocity.dot(screw.angular) / (rate * rate) * screw.angular)
                              : screw.velocity;
    const Vector3 moving = screw.velocity + screw.angular.cross(point);
    return (along.norm() > kAdvancing * moving.norm() ? along : moving).normalized();
}

}  // namespace

struct TwistTree::Candidate {
    Node* node;
    Screw screw;             ///< moves the part by a twist of length 1 in a unit of time
    double score = 0;        ///< the share of the part's radius that is certified
    double certified = 0;    ///< length
    bool isInwards = false;  ///< the goal comes no nearer
    bool isReverse = false;  ///< of a direction that certifies much
};

/// A screw that is being followed.
struct TwistTree::Track {
    Node* node;
    Screw screw;
    double step;
    std::size_t first;  ///< how many nodes there were before it
    double length = 0, sinceBlock = 0;
    double pulledAt = 0;  ///< the clearance where a pull was tried last
    int shortAdvances = 0;
    std::optional<Advance> known{};  ///< of the next step
    std::vector<Node*> nodes{};
};

/// The places along a track where directions of other tracks are tried.
struct TwistTree::Probe {
    std::vector<Node*> nodes;
    double length;
    int count, next = 0, found = 0;
    double priority;
};

TwistTree::TwistTree(ob::SpaceInformationPtr si, const SceneClearance& clearance, const PartMoves& moves,
                     const ob::GoalRegion* goal, bool isFromStart)
    : si_(std::move(si)),
      clearance_(clearance),
      moves_(moves),
      goal_(goal),
      isFromStart_(isFromStart),
      validator_(dynamic_cast<const MotionValidator*>(si_->getMotionValidator().get())),
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

const ob::State* TwistTree::stateOf(const Node& node) const {
    return node.state;
}

double TwistTree::goalDistance(const Node& node) const {
    return goal_ != nullptr ? goal_->distanceGoal(node.state) : 0;
}

void TwistTree::addRoot(const ob::State* state) {
    const Screw none{Vector3::Zero(), Vector3::Zero()};
    nodes_.push_back(std::make_unique<Node>(
        Node{si_->cloneState(state), moves_.pose(state), nullptr, none, 0, 0, 0, 0, 0, true, {}}));
    Node& root = *nodes_.back();
    root.toGoal = goalDistance(root);
    ++rootCount_;
    findClearance(root);
    play_ = root.play = std::min(kFreeGap * moves_.radius(), root.clearance);
    rootPlay_ = std::max(rootPlay_, play_);
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
                     kContactInterval * play_ /
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
        std::make_unique<Node>(Node{state, moves_.pose(state), parent, screw * (done * time), parent->depth,
                                    0, done * time, play_, 0, done == 1, std::move(states)}));
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

/// The clearance that motions from a node keep.
double TwistTree::floorFrom(const Node& node) const {
    return std::min(kFloor * play_, kSpare * node.clearance);
}

/// Looks at poses in steps: a sweep would cost as much as the certificate of the motions, which follows.
TwistTree::Advance TwistTree::advance(const Node& from, const Screw& screw) const {
    const double speed = motionAlong(screw, from.X_environmentPart, clearance_.scene().part).length;
    const double floor = floorFrom(from), step = std::min(1.0, kStep * play_ / speed);
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
    while ((blocked - free) * speed > kContactInterval * play_) {
        const double middle = 0.5 * (free + blocked);
        (isFreeAt(middle) ? free : blocked) = middle;
    }
    return {free, false};
}

/// Each direction of a first set is turned aside by the contacts until it leaves the gaps open for a length ahead.
TwistTree::Directions TwistTree::directionsAt(const Pose& X_environmentPart,
                                              const std::vector<ContactRow>& rows) {
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (const ContactRow& row : rows) sum += row.row * row.row.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> axes(sum);
    std::vector<Twist> wanted;
    for (int k = 0; k < 6; ++k) wanted.push_back(axes.eigenvectors().col(k));
    for (int k = 0; k < 6; ++k) wanted.push_back(Twist::Unit(k));
    const Matrix3 principal = X_environmentPart.rotation * principalAxes_;
    for (int k = 0; k < 3; ++k) {
        wanted.push_back((Twist() << principal.col(k), Vector3::Zero()).finished());
        wanted.push_back((Twist() << Vector3::Zero(), principal.col(k)).finished());
    }
    for (int k = 0; k < kRandomDirections; ++k) {
        Twist drawn;
        for (int i = 0; i < 6; ++i) drawn[i] = random_.gaussian01();
        wanted.push_back(drawn);
    }
    Directions directions;
    std::vector<TwistBound> bounds(rows.size());
    std::vector<double> aheads;
    for (const double share : kLookAheads) aheads.push_back(share * moves_.radius());
    aheads.push_back(play_);
    const auto keep = [&](const Twist& found, std::vector<Twist>& kept) {
        for (const std::vector<Twist>* known : {&directions.open, &directions.late}) {
            for (const Twist& each : *known) {
                if (each.dot(found) > kLikeDirection) return;
            }
        }
        kept.push_back(found);
    };
    for (Twist each : wanted) {
        if (moves_.isPlanar()) each(2) = each(3) = each(4) = 0;
        if (!(each.norm() > 1e-6)) continue;
        each.normalize();
        for (const double sign : {1.0, -1.0}) {
            for (const double ahead : aheads) {
                Twist direction = sign * each;
                bool isOpen = true;
                for (int k = 0; k < kRefinements && isOpen; ++k) {
                    for (std::size_t i = 0; i < rows.size(); ++i) {
                        bounds[i] = {rows[i].row,
                                     -std::max(0.0, rows[i].gap) / ahead - rows[i].row.dot(direction)};
                    }
                    const std::optional<Twist> aside = leastTwist(bounds);
                    isOpen = aside && (direction + *aside).norm() > kLeastMoved;
                    if (isOpen) direction = (direction + *aside).normalized();
                }
                if (isOpen) keep(direction, ahead == play_ ? directions.late : directions.open);
            }
        }
    }
    return directions;
}

void TwistTree::lookAround(Node& at, const Twist* arrived) {
    Node* centred = &at;
    for (int k = 0; k < kCentrings; ++k) {
        Node* next = centre(centred, Twist::Zero());
        if (next == centred) break;
        centred = next;
    }
    Node& node = *centred;
    const double band = std::min(kBand * play_, kWidestBand * moves_.radius());
    const std::vector<ContactRow> rows = rowsNear(clearance_, moves_, node.X_environmentPart, band);
    if (rows.empty() && band >= kFreeGap * moves_.radius()) {
        free_.push_back(&node);
        return;
    }
    const Directions directions = directionsAt(node.X_environmentPart, rows);
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
    scored.certified = (found.isWhole ? 1 : kBackOff) * found.time * length;
    if (scored.certified < std::min(kLeastScore * length, kLeastCertified * play_)) return;
    if (!candidate.isReverse) unscored_.push_back({candidate.node, candidate.screw * -1, 0, 0, false, true});
    scored.score = found.time;
    if (goal_ != nullptr) {
        const ScratchState end(*si_);
        moves_.setPose(movedAlong(candidate.screw, candidate.node->X_environmentPart, scored.certified),
                       end.get());
        double distance = 0;
        if (goal_->isSatisfied(end.get(), &distance)) return begin(scored);
        scored.isInwards = !leadsNearer(candidate);
    }
    const ScratchState end(*si_);
    moves_.setPose(movedAlong(candidate.screw, candidate.node->X_environmentPart, scored.certified),
                   end.get());
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
    track_ =
        std::make_unique<Track>(Track{candidate.node, candidate.screw, candidate.certified, nodes_.size()});
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

void TwistTree::followOn() {
    Track& track = *track_;
    const Advance ahead = track.known ? *track.known : advance(*track.node, track.screw * track.step);
    track.known.reset();
    const double length = (ahead.isWhole ? 1 : kBackOff * ahead.time) * track.step;
    Node* next = length > kLeastLength * play_ ? grow(track.node, track.screw, length) : nullptr;
    const bool isWhole = ahead.isWhole && next != nullptr && next->isWhole;
    if (next != nullptr) {
        track.node = next;
        track.nodes.push_back(next);
        track.sinceBlock += next->length;
        track.length += next->length;
    }
    if (goal_ != nullptr && goal_->isSatisfied(track.node->state)) return reachGoal(track.node);
    if (track.node->clearance >= kFreeGap * moves_.radius() && (goal_ == nullptr || !isWhole)) {
        free_.push_back(track.node);
        track_.reset();
        return;
    }
    if (isOld(track.node->state, track.first)) return finishTrack();
    if (track.node->clearance > kWidened * track.pulledAt) {
        track.pulledAt = track.node->clearance;
        if (pullOut(*track.node, track.screw)) return;
    }
    if (isWhole && track.node->clearance >= kCentreBelow * play_) {
        track.step = std::min(2 * track.step, moves_.radius());
        return;
    }
    if (!isWhole)
        track.shortAdvances = track.sinceBlock < kShortAdvance * play_ ? track.shortAdvances + 1 : 0;
    if (track.shortAdvances == kMostShortAdvances) return finishTrack();
    const double wanted = kWider * std::max(track.sinceBlock, play_);
    track.sinceBlock = 0;
    Node* centred = centre(track.node, twistOf(track.screw, *track.node));
    if (centred != track.node) track.nodes.push_back(centred);
    track.node = centred;
    track.screw = chooseScrew(*track.node, std::min(wanted, moves_.radius()));
}

void TwistTree::reachGoal(const Node* node) {
    atGoal_ = node;
    track_.reset();
}

/// Tries to leave along the screw's axis: a part that has come out of its thread need not be turned on. Returns whether the part gets to
/// the goal.
bool TwistTree::pullOut(Node& node, const Screw& screw) {
    const double rate = screw.angular.norm();
    if (goal_ == nullptr || !(rate > 0)) return false;
    const Vector3 axis = screw.angular / rate;
    const Screw pull{Vector3::Zero(), screw.velocity.dot(axis) < 0 ? Vector3(-axis) : axis};
    const ScratchState end(*si_);
    const auto isOutsideAt = [&](double length) {
        moves_.setPose(movedAlong(pull, node.X_environmentPart, length), end.get());
        return goal_->isSatisfied(end.get());
    };
    double inside = 0, outside = moves_.radius();
    for (int k = 0; !isOutsideAt(outside); ++k, outside *= 2) {
        if (k == kMostDoublings) return false;
        inside = outside;
    }
    for (int k = 0; k < kPullBisections; ++k) {
        const double middle = 0.5 * (inside + outside);
        (isOutsideAt(middle) ? outside : inside) = middle;
    }
    if (!advance(node, pull * outside).isWhole) return false;
    const Node* last = grow(&node, pull, outside);
    if (last == nullptr || !last->isWhole) return false;
    reachGoal(last);
    return true;
}

/// Raises the least gap across the track, to first order, and takes the move if it does so truly.
TwistTree::Node* TwistTree::centre(Node* node, const Twist& along) {
    const double band = std::min(kBand * play_, kWidestBand * moves_.radius());
    std::vector<ContactRow> rows = rowsNear(clearance_, moves_, node->X_environmentPart, band);
    if (rows.empty()) return node;
    const auto isAhead = [&](ContactRow& row) {
        const double whole = row.row.norm();
        row.row -= row.row.dot(along) * along;
        return row.row.norm() < kAcross * whole;
    };
    const double gap = rows[0].gap;
    rows.erase(std::remove_if(rows.begin(), rows.end(), isAhead), rows.end());
    if (rows.empty()) return node;
    std::vector<TwistBound> bounds(rows.size());
    double low = rows[0].gap, high = band;
    Twist best = Twist::Zero();
    for (int k = 0; k < kCentreBisections; ++k) {
        const double middle = 0.5 * (low + high);
        for (std::size_t i = 0; i < rows.size(); ++i) bounds[i] = {rows[i].row, middle - rows[i].gap};
        const std::optional<Twist> found = leastTwist(bounds);
        if (found && found->norm() < band) {
            best = *found;
            low = middle;
        } else {
            high = middle;
        }
    }
    ClearanceOptions options;
    options.cap = band;
    options.isRough = true;
    for (int k = 0; k < 4 && best.norm() > 0.02 * play_; ++k, best *= 0.5) {
        const Screw screw = screwOf(best, *node);
        const Pose to = movedAlong(screw, node->X_environmentPart, 1);
        const double reached = clearance_.at(to, options).lower;
        if (!(reached > gap) || !advance(*node, screw).isWhole) continue;
        Node* next = grow(node, screw, 1);
        if (next == nullptr || !next->isWhole) continue;
        play_ = next->play = std::clamp(reached, std::max(kPlayLoss * play_, kLeastPlay * rootPlay_),
                                        std::max(kPlayGrowth * play_, kLeastPlay * rootPlay_));
        next->length = 0;  // across the track
        return next;
    }
    return node;
}

/// The screw goes on in space as it is, unless a secant of the last poses is certified farther.
Screw TwistTree::chooseScrew(const Node& node, double wanted) {
    Track& track = *track_;
    track.step = wanted;
    track.known = advance(node, track.screw * wanted);
    Screw best = track.screw;
    if (track.known->isWhole) return best;
    for (const double back : {0.25, 1.0}) {
        const Node* from = &node;
        double length = 0;
        while (from->parent != nullptr && from->depth == node.depth && length < back * moves_.radius()) {
            length += from->length;
            from = from->parent;
        }
        if (length < back * moves_.radius()) break;
        Screw secant = screwBetween(from->X_environmentPart, node.X_environmentPart);
        if (secant.angular.norm() > kMostSecant) continue;
        const double norm = twistOf(secant, node).norm();
        if (!(norm > 0)) continue;
        secant = secant * (1 / norm);
        const Advance found = advance(node, secant * wanted);
        if (found.time > track.known->time) {
            track.known = found;
            best = secant;
        }
    }
    return best;
}

/// Whether a state is on one of the first motions, within the band across it.
bool TwistTree::isOld(const ob::State* state, std::size_t count) const {
    const double band = std::min(kBand * play_, kWidestBand * moves_.radius());
    for (std::size_t i = 0; i < count; ++i) {
        const Node& other = *nodes_[i];
        if (other.parent == nullptr || other.length == 0) continue;
        const Twist way = moves_.between(other.parent->state, other.state);
        const Twist here = moves_.between(other.parent->state, state);
        const double length = way.norm(), along = length > 0 ? here.dot(way) / length : -1;
        if (along < 0 || along > length) continue;
        if ((here - along / length * way).norm() < 0.5 * band) return true;
    }
    return false;
}

void TwistTree::finishTrack() {
    const std::unique_ptr<Track> track = std::move(track_);
    if (track->length < kShortAdvance * play_) return;
    Node& end = *track->node;
    const Twist along = twistOf(track->screw, end).normalized();
    end.depth = track->nodes.front()->parent->depth + 1;
    const SceneDistance nearest = clearance_.distance(end.X_environmentPart);
    TrackEnd told{nearest, 0, track->length};
    if (const auto plane = contactPlaneOf(nearest, clearance_.scene(), end.X_environmentPart))
        told.squareness = -plane->normal.dot(headingOf(track->screw, nearest.witness->pointOnPart));
    if (track->length > kLeastTrack * moves_.radius()) {
        ends_.push_back(told);
        if (library_.size() < kMostLibrary) library_.push_back(track->screw);
        const double spacing = std::max(2 * play_, track->length / kMostPlaces);
        Probe places{track->nodes,
                     track->length,
                     static_cast<int>(track->length / spacing),
                     0,
                     0,
                     kProbeScore * std::pow(kDepthLoss, end.depth - 1)};
        probes_.insert(probes_.begin(), places);
    }
    lookAround(end, &along);
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
