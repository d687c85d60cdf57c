#include "program/scenes/path_curve.h"

#include <algorithm>
#include <stdexcept>

namespace clearway::scenes {

PathCurve::PathCurve(const std::vector<PartState>& path, const Box& partBox)
    : path_(path), centre_(partBox.center()), size_(partBox.diagonal().norm()) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double turned = path[i].rotation.angularDistance(path[i + 1].rotation);
        const Vector3 way = placeOf(path[i + 1]) - placeOf(path[i]);
        reached_.push_back(reached_.back() + way.norm() + turned * size_ / kTurnOfASize);
    }
    if (!(reached_.back() > 0)) throw std::invalid_argument("the path does not move, expected one that does");
}

Pose PathCurve::at(double share, const Deviation& deviation) const {
    const double length = share * reached_.back();
    const auto next = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, length);
    const auto k = static_cast<std::size_t>(next - reached_.begin());
    const double gap = reached_[k] - reached_[k - 1];
    const double u = gap > 0 ? (length - reached_[k - 1]) / gap : 0;
    const Vector3 place =
        (1 - u) * placeOf(path_[k - 1]) + u * placeOf(path_[k]) + size_ * deviation.head<3>();
    const Vector3 turn = deviation.tail<3>();
    PartState state;
    state.rotation = path_[k - 1].rotation.slerp(u, path_[k].rotation);
    if (turn.norm() > 0) state.rotation = state.rotation * Eigen::AngleAxisd(turn.norm(), turn.normalized());
    state.rotation.normalize();
    state.position = place - state.rotation * centre_;
    return poseOf(state);
}

}  // namespace clearway::scenes
