#include "demos/scenes/replay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "clearway/query.h"
#include "demos/scenes/random.h"

namespace clearway::scenes {

namespace {

constexpr double kShareTolerance = 0.02;
constexpr double kLargestAmplitude = 8;  // part sizes

struct Wave {
    double weight, cycles, phase;
};

/// Six sums of sines, one per degree of freedom; their values are mostly about 1.
class Waves {
  public:
    Waves(Random& random, bool turns) : turns_(turns) {
        for (auto& sum : waves_) {
            for (Wave& wave : sum) {
                wave = {random.between(0.3, 1), random.between(0.5, 6), random.between(0, 2 * M_PI)};
            }
        }
    }

    Deviation at(double share) const {
        Deviation deviation;
        for (int i = 0; i < 6; ++i) {
            deviation[i] = 0;
            for (const Wave& wave : waves_[i]) {
                deviation[i] += wave.weight * std::sin(2 * M_PI * wave.cycles * share + wave.phase);
            }
        }
        deviation.tail<3>() *= turns_ ? kTurnOfASize : 0;
        return deviation;
    }

  private:
    std::array<std::array<Wave, 4>, 6> waves_;
    bool turns_;
};

double shareAt(int i, int count) {
    return count > 1 ? static_cast<double>(i) / (count - 1) : 0;
}

std::vector<Pose> deviated(const PathCurve& curve, const Waves& waves, double amplitude, int count) {
    std::vector<Pose> poses;
    for (int i = 0; i < count; ++i) {
        const double share = shareAt(i, count);
        poses.push_back(curve.at(share, amplitude * waves.at(share)));
    }
    return poses;
}

double collidingShare(const PoseTask& task, const std::vector<Pose>& poses, Workspace& workspace) {
    const auto touching = std::count_if(poses.begin(), poses.end(), [&](const Pose& pose) {
        return collides(task.part, task.environment, pose, workspace);
    });
    return static_cast<double>(touching) / static_cast<double>(poses.size());
}

/// Poses with the wanted share of collisions, if some amplitude of this deviation gives it.
std::optional<std::vector<Pose>> bisected(const PoseTask& task, const PathCurve& curve, const Waves& waves,
                                          double share, int count) {
    Workspace workspace;
    // With few poses only few shares are possible: the nearest one is off by up to half a pose, plus
    // rounding.
    const double enough = std::max(kShareTolerance / 2, (0.5 + 1e-9) / count);
    double low = 0, high = 1e-4;
    while (collidingShare(task, deviated(curve, waves, high, count), workspace) < share) {
        low = high;
        high *= 2;
        if (high > kLargestAmplitude) return std::nullopt;
    }
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        std::vector<Pose> poses = deviated(curve, waves, middle, count);
        const double reached = collidingShare(task, poses, workspace);
        if (std::abs(reached - share) <= enough) return poses;
        (reached < share ? low : high) = middle;
    }
    return std::nullopt;
}

}  // namespace

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

std::vector<Pose> posesColliding(const PoseTask& task, double share, int count, std::uint64_t seed,
                                 bool turns) {
    const PathCurve curve(task.path, task.part.box());
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
        const Waves waves(random, turns);
        if (auto poses = bisected(task, curve, waves, share, count)) return *poses;
    }
    throw std::runtime_error("no deviation from the path has the wanted share of colliding poses");
}

std::vector<PartState> beginningOf(const std::vector<PartState>& path, double share) {
    const double states = std::ceil(share * static_cast<double>(path.size()));
    return {path.begin(), path.begin() + static_cast<std::ptrdiff_t>(states)};
}

}  // namespace clearway::scenes
