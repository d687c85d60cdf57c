#include "bench/pose_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "clearway/query.h"
#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

constexpr double kShareTolerance = 0.02;
constexpr double kLargestAmplitude = 8;  // part sizes
constexpr double kTurn = 2;  // rad that move the ends of a part as far as one part size of translation
constexpr double kPi = 3.14159265358979323846;

/// Three translations in part sizes, then a rotation vector in rad.
using Deviation = Eigen::Matrix<double, 6, 1>;

/// The states of a path at even shares of its length, which counts turning by what it moves the part's ends.
class Curve {
  public:
    Curve(const std::vector<PartState>& path, const Box& partBox)
        : path_(path), centre_(partBox.center()), size_(partBox.diagonal().norm()) {
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const double turned = path[i].rotation.angularDistance(path[i + 1].rotation);
            const Vector3 way = placeOf(path[i + 1]) - placeOf(path[i]);
            reached_.push_back(reached_.back() + way.norm() + turned * size_ / kTurn);
        }
        if (!(reached_.back() > 0))
            throw std::invalid_argument("the path does not move, expected one that does");
    }

    double size() const { return size_; }

    /// share: 0 to 1.
    Pose at(double share, const Deviation& deviation) const {
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
        if (turn.norm() > 0)
            state.rotation = state.rotation * Eigen::AngleAxisd(turn.norm(), turn.normalized());
        state.rotation.normalize();
        state.position = place - state.rotation * centre_;
        return poseOf(state);
    }

  private:
    Vector3 placeOf(const PartState& state) const { return state.rotation * centre_ + state.position; }

    std::vector<PartState> path_;
    Vector3 centre_;
    double size_;
    std::vector<double> reached_{0};
};

struct Wave {
    double weight, cycles, phase;
};

/// Six sums of sines; about 1 at most places.
class Waves {
  public:
    Waves(Random& random, bool turns) : turns_(turns) {
        for (auto& sum : waves_) {
            for (Wave& wave : sum) {
                wave = {random.uniform(0.3, 1), random.uniform(0.5, 6), random.uniform(0, 2 * kPi)};
            }
        }
    }

    Deviation at(double share) const {
        Deviation deviation;
        for (int i = 0; i < 6; ++i) {
            deviation[i] = 0;
            for (const Wave& wave : waves_[i]) {
                deviation[i] += wave.weight * std::sin(2 * kPi * wave.cycles * share + wave.phase);
            }
        }
        deviation.tail<3>() *= turns_ ? kTurn : 0;
        return deviation;
    }

  private:
    std::array<std::array<Wave, 4>, 6> waves_;
    bool turns_;
};

double shareAt(int i, int count) {
    return count > 1 ? static_cast<double>(i) / (count - 1) : 0;
}

std::vector<Pose> deviated(const Curve& curve, const Waves& waves, double amplitude, int count) {
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

/// Poses with the wanted share, if this deviation has an amplitude for it.
std::optional<std::vector<Pose>> bisected(const PoseTask& task, const Curve& curve, const Waves& waves,
                                          double share, int count) {
    Workspace workspace;
    // Few poses have few shares; by a hair more than half a pose, which may be what the nearest is off by.
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

/// Where a walk is: how far along the path, and how far beside it.
struct Walker {
    double share = 0;
    Deviation deviation = Deviation::Zero();
    double direction = 1;  ///< +1 or -1, along the path
    Pose pose;
    double clearance = 0;
};

class FreeWalk {
  public:
    FreeWalk(const PoseTask& task, double from, double to, int count, std::uint64_t seed)
        : task_(task),
          curve_(task.path, task.part.box()),
          random_(seed),
          from_(from * curve_.size()),
          to_(to * curve_.size()),
          stride_(1.0 / count) {}

    /// The first place on the path where a walk can begin.
    Walker start() {
        for (int i = 0; i <= 1000; ++i) {
            Walker walker;
            walker.share = i / 1000.0;
            if (place(walker)) return walker;
        }
        throw std::runtime_error("no place on the path has a clearance in the wanted range");
    }

    Walker next(const Walker& walker) {
        if (steps_++ % kStepsOfAnAim == 0) aim_ = from_ * std::pow(to_ / from_, random_.uniform(0, 1));
        if (const auto onward = bestStep(walker, walker.direction)) return *onward;
        if (const auto back = bestStep(walker, -walker.direction)) return *back;
        throw std::runtime_error("a walk beside the path is stuck");
    }

  private:
    static constexpr int kTries = 300;
    static constexpr int kChoices = 4;
    static constexpr int kStepsOfAnAim = 8;
    static constexpr double kPull = 0.99;    // back to the path, a little
    static constexpr double kChange = 4e-3;  // part sizes, about the length of a step beside the path

    /// Of the first few allowed steps the one whose clearance comes nearest to the aim.
    std::optional<Walker> bestStep(const Walker& from, double direction) {
        std::optional<Walker> best;
        int found = 0;
        for (int i = 0; i < kTries && found < kChoices; ++i) {
            Walker tried = from;
            tried.direction = direction;
            tried.share += direction * random_.uniform(0.5, 1.5) * stride_;
            tried.deviation = kPull * from.deviation + change();
            if (tried.share < 0 || tried.share > 1 || !place(tried)) continue;
            ++found;
            if (!best || offAim(tried) < offAim(*best)) best = tried;
        }
        return best;
    }

    double offAim(const Walker& walker) const { return std::abs(std::log(walker.clearance / aim_)); }

    Deviation change() {
        Deviation drawn;
        for (int i = 0; i < 6; ++i) drawn[i] = kChange / std::sqrt(6.0) * random_.normal();
        drawn.tail<3>() *= kTurn;
        return drawn;
    }

    /// Works out pose and clearance; false when it is out of the range.
    bool place(Walker& walker) {
        walker.pose = curve_.at(walker.share, walker.deviation);
        const DistanceResult found = distance(task_.part, task_.environment, walker.pose, {}, workspace_);
        walker.clearance = found.distance;
        return !found.collides() && found.lower >= from_ && found.upper <= to_;
    }

    const PoseTask& task_;
    Curve curve_;
    Random random_;
    Workspace workspace_;
    double from_, to_;  // clearances, environment units
    double aim_ = 0;
    double stride_;
    int steps_ = 0;
};

}  // namespace

std::vector<Pose> posesColliding(const PoseTask& task, double share, int count, std::uint64_t seed,
                                 bool turns) {
    const Curve curve(task.path, task.part.box());
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
        const Waves waves(random, turns);
        if (auto poses = bisected(task, curve, waves, share, count)) return *poses;
    }
    throw std::runtime_error("no deviation from the path has the wanted share of colliding poses");
}

std::vector<Pose> posesFree(const PoseTask& task, double from, double to, int count, std::uint64_t seed) {
    FreeWalk walk(task, from, to, count, seed);
    std::vector<Pose> poses;
    Walker walker = walk.start();
    for (int i = 0; i < count; ++i) {
        poses.push_back(walker.pose);
        if (i + 1 < count) walker = walk.next(walker);
    }
    return poses;
}

std::vector<double> stepsBetween(const std::vector<Pose>& poses, const Box& partBox) {
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
        double farthest = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3 point = partBox.corner(static_cast<Box::CornerType>(corner));
            farthest = std::max(farthest, (poses[i + 1] * point - poses[i] * point).norm());
        }
        steps.push_back(farthest / partBox.diagonal().norm());
    }
    return steps;
}

std::vector<std::size_t> shuffledOrder(std::size_t count, std::uint64_t seed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random random(seed);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<int>(i))]);
    return order;
}

}  // namespace clearway::testing
