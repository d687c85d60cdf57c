#include "bench/pose_sets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "clearway/query.h"
#include "demos/scenes/replay.h"
#include "support/random_meshes.h"

namespace clearway::testing {

using namespace scenes;
namespace {

/// The state of a walk: its place along the path, and its deviation from the path.
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

    /// Among the first few allowed steps, the one whose clearance comes nearest to the aim.
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
        drawn.tail<3>() *= kTurnOfASize;
        return drawn;
    }

    /// Computes pose and clearance; returns false if the clearance is out of range.
    bool place(Walker& walker) {
        walker.pose = curve_.at(walker.share, walker.deviation);
        const DistanceResult found = distance(task_.part, task_.environment, walker.pose, {}, workspace_);
        walker.clearance = found.distance;
        return !found.collides() && found.lower >= from_ && found.upper <= to_;
    }

    const PoseTask& task_;
    PathCurve curve_;
    Random random_;
    Workspace workspace_;
    double from_, to_;  // clearances, environment units
    double aim_ = 0;
    double stride_;
    int steps_ = 0;
};

}  // namespace

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
