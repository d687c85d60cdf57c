#include "planning/planners/slide_contacts.h"

namespace clearway::planning {
namespace {

namespace ob = ompl::base;

// Shares of half the diagonal of the part's box.
constexpr double kLongestSlide = 0.5;   ///< of one step, because contact planes change on the way
constexpr double kForgottenGap = 0.02;  ///< added to kForgottenStandoffs

constexpr double kForgottenStandoffs = 4;  ///< contacts with a larger gap do not count
constexpr std::size_t kMostContacts = 8;
constexpr double kLikeContact = 0.15;    ///< rows closer than this are the same contact
constexpr double kLeastProgress = 0.05;  ///< of a step, along the way to the target
constexpr double kTendBack = 0.5;        ///< standoffs that a step may lead away from the target

}  // namespace

double SlideContacts::forgottenGap() const {
    return kForgottenStandoffs * standoff_ + kForgottenGap * moves_.radius();
}

std::vector<ContactRow> SlideContacts::rowsAt(const Pose& X_environmentPart) {
    std::vector<ContactRow> rows;
    for (std::size_t i = 0; i < contacts_.size();) {
        const ContactRow row = rowAt(contacts_[i], moves_, X_environmentPart);
        if (row.gap > forgottenGap()) {
            contacts_.erase(contacts_.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            rows.push_back(row);
            ++i;
        }
    }
    return rows;
}

std::optional<bool> SlideContacts::step(const ob::State* at, const ob::State* target, double reach,
                                        ob::State* next) {
    const Twist wanted = moves_.between(at, target);
    const double way = wanted.norm();
    bool isTarget = way <= reach;
    Twist step = isTarget ? wanted : Twist(wanted * (reach / way));
    const std::vector<ContactRow> rows = rowsAt(moves_.pose(at));
    if (!rows.empty()) {
        const double longest = kLongestSlide * moves_.radius();
        const bool isShortened = step.norm() > longest;
        if (isShortened) step *= longest / step.norm();
        const Twist free = step;
        step = nearestKeeping(standoff_, rows, free);
        const double along = step.dot(wanted);
        if (along < kLeastProgress * way * free.norm() && step.norm() < 2 * standoff_) return std::nullopt;
        if (along < -kTendBack * standoff_ * way) return std::nullopt;
        const bool isUnchanged = (step - free).squaredNorm() == 0;
        isTarget = isTarget && !isShortened && isUnchanged;
    }
    if (isTarget) {
        si_.copyState(next, target);
    } else {
        moves_.move(at, step, next);
    }
    return isTarget;
}

void SlideContacts::lookAround(const ob::State* state) {
    const Pose X_environmentPart = moves_.pose(state);
    ClearanceOptions options;
    options.cap = forgottenGap();
    options.isRough = true;
    const PoseClearance found = clearance_.at(X_environmentPart, options);
    const auto plane = contactPlaneOf(found.nearest, clearance_.scene(), X_environmentPart);
    if (!plane) return;
    const ContactRow row = rowAt(*plane, moves_, X_environmentPart);
    if (row.gap > *options.cap) return;
    for (ContactPlane& known : contacts_) {
        if ((rowAt(known, moves_, X_environmentPart).row - row.row).norm() < kLikeContact) {
            known = *plane;
            return;
        }
    }
    if (contacts_.size() == kMostContacts) contacts_.erase(contacts_.begin());
    contacts_.push_back(*plane);
}

}  // namespace clearway::planning
