// How a TwistTree follows a screw: as far as it is free, then centred between the contacts, and on along the same screw or a secant.
#include <algorithm>
#include <cmath>
#include <utility>

#include "planning/improve/least_twist.h"
#include "planning/planners/twist_tree.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

// In gaps of the centred part.
constexpr double kShortAdvance = 0.3, kLeastLength = 0.02, kCentreBelow = 0.6;

constexpr double kLeastTrack = 0.1;  ///< of half the diagonal of the part's box; a shorter track is no track
constexpr double kBeyond = 0.02;     ///< of that, too: the bounds are looked for so far ahead of an end
constexpr int kMostShortAdvances = 3, kCentreBisections = 7, kCentreTries = 4;
constexpr double kAcross = 0.5;      ///< of a contact's row: one that acts less across the track is ahead
constexpr double kWider = 3;         ///< last advances that the next screw is chosen by
constexpr double kWidened = 1.5;     ///< times the clearance where a pull was tried last
constexpr double kMostSecant = 2.5;  ///< radians
constexpr double kPlayLoss = 0.7, kPlayGrowth = 2;  ///< of the play, by one centring
constexpr double kLeastPlay = 0.1;                  ///< of the root's
constexpr int kMostDoublings = 6, kPullBisections = 20;
constexpr double kProbeScore = 0.3;
constexpr int kMostPlaces = 2048;
constexpr std::size_t kMostLibrary = 6;

}  // namespace

/// Where a screw leads a part: along its axis, or a point of the part if the screw only turns.
Vector3 TwistTree::headingOf(const Screw& screw, const Vector3& point) {
    const double rate = screw.angular.norm();
    const Vector3 along = rate > 0
                              ? Vector3(screw.velocity.dot(screw.angular) / (rate * rate) * screw.angular)
                              : screw.velocity;
    const Vector3 moving = screw.velocity + screw.angular.cross(point);
    return (along.norm() > kAdvancing * moving.norm() ? along : moving).normalized();
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
    if (isOld(track.node->state, countBehind(*track.node))) return finishTrack();
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

/// Moves the part across the track so that its least gap grows most, to first order; the move is taken only if the clearance grows.
TwistTree::Node* TwistTree::centre(Node* node, const Twist& along) {
    const double most = band();
    std::vector<ContactRow> rows = rowsNear(clearance_, moves_, node->X_environmentPart, most);
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
    double low = rows[0].gap, high = most;
    Twist best = Twist::Zero();
    for (int k = 0; k < kCentreBisections; ++k) {
        const double middle = 0.5 * (low + high);
        for (std::size_t i = 0; i < rows.size(); ++i) bounds[i] = {rows[i].row, middle - rows[i].gap};
        const std::optional<Twist> found = leastTwist(bounds);
        if (found && found->norm() < most) {
            best = *found;
            low = middle;
        } else {
            high = middle;
        }
    }
    ClearanceOptions options;
    options.cap = most;
    options.isRough = true;
    for (int k = 0; k < kCentreTries && best.norm() > kLeastLength * play_; ++k, best *= 0.5) {
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

/// How many nodes there were a radius of the way back: a turn that closes comes to its own beginning.
std::size_t TwistTree::countBehind(const Node& node) const {
    const Node* from = &node;
    double length = 0;
    while (from->index > track_->first && length < moves_.radius()) {
        length += from->length;
        from = from->parent;
    }
    return std::max(from->index, track_->first);
}

/// Whether a state is on one of the first motions, within half the band across it.
bool TwistTree::isOld(const ob::State* state, std::size_t count) const {
    const double widest = 0.5 * band();
    for (std::size_t i = 0; i < count; ++i) {
        const Node& other = *nodes_[i];
        if (other.parent == nullptr || other.length == 0) continue;
        const Twist way = moves_.between(other.parent->state, other.state);
        const Twist here = moves_.between(other.parent->state, state);
        const double length = way.norm(), along = length > 0 ? here.dot(way) / length : -1;
        if (along < 0 || along > length) continue;
        if ((here - along / length * way).norm() < widest) return true;
    }
    return false;
}

void TwistTree::finishTrack() {
    const std::unique_ptr<Track> track = std::move(track_);
    if (track->nodes.empty() || track->length < kShortAdvance * play_) return;
    Node& end = *track->node;
    const Twist along = twistOf(track->screw, end).normalized();
    end.depth = track->nodes.front()->parent->depth + 1;
    const SceneDistance nearest = clearance_.distance(end.X_environmentPart);
    const ScratchState beyond(*si_);
    moves_.setPose(movedAlong(track->screw, end.X_environmentPart, kBeyond * moves_.radius()), beyond.get());
    TrackEnd told{nearest, 0, track->length, !si_->satisfiesBounds(beyond.get())};
    if (const auto plane = contactPlaneOf(nearest, clearance_.scene(), end.X_environmentPart))
        told.squareness = -plane->normal.dot(headingOf(track->screw, nearest.witness->pointOnPart));
    if (track->length > kLeastTrack * moves_.radius()) {
        ends_.push_back(told);
        if (library_.size() < kMostLibrary) library_.push_back(track->screw);
        const double spacing = std::max(play_, track->length / kMostPlaces);
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

}  // namespace clearway::planning
