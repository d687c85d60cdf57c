#include "bench/near_margin.h"

#include <algorithm>
#include <cmath>

#include "clearway/query.h"

namespace clearway::testing {
namespace {

constexpr double kOfMargin[] = {1e-3, 1e-6, 1e-9, 1e-12};
constexpr double kOfScene[] = {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15};

double largestCoordinate(const BenchTask& task, const Pose& pose) {
    const auto largest = [](const Box& box) {
        return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    };
    const double part = std::sqrt(3.0) * largest(boundingBox(task.part));  // however the part is turned
    return std::max(largest(boundingBox(task.environment)), part + pose.translation.cwiseAbs().maxCoeff());
}

/// The wanted distances, including the margin itself.
std::vector<double> targets(double margin, double sceneSize) {
    std::vector<double> all{margin};
    const auto around = [&](double offset) {
        all.push_back(margin + offset);
        all.push_back(margin - offset);
    };
    if (margin > 0) {
        for (const double e : kOfMargin) around(e * margin);
    } else {
        for (const double e : kOfScene) around(e * sceneSize);
    }
    return all;
}

/// All free poses, or `count` of them evenly spread.
std::vector<std::size_t> freePoses(const std::vector<Truth>& truths, double margin, int count) {
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        if (truths[i].distance > 2 * margin) free.push_back(i);
    }
    if (free.size() <= std::size_t(count)) return free;
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < std::size_t(count); ++k)
        chosen.push_back(free[k * free.size() / std::size_t(count)]);
    return chosen;
}

class Collector {
  public:
    explicit Collector(double margin) { result_.margin = margin; }

    void add(const Pose& pose, const Truth& truth) {
        const double margin = result_.margin;
        if (truth.distance > 0 && std::abs(truth.distance - margin) <= truth.error) {
            ++result_.undecided;
            return;
        }
        result_.poses.push_back(pose);
        result_.isValid.push_back(truth.distance > margin);
    }

    PosesNearMargin result() const { return result_; }

  private:
    PosesNearMargin result_;
};

}  // namespace

Truth askOracle(const MeshOracle& oracle, const BenchTask& task, const Pose& pose) {
    constexpr double kOracleRoundoffs = 16;  // 2^-64 of the largest coordinate, generously
    const double distance = oracle.distance(pose).distance;
    if (distance == 0) return {0, 0};  // exact
    return {distance, kOracleRoundoffs * 0x1p-64 * largestCoordinate(task, pose) + 0x1p-53 * distance};
}

PosesNearMargin posesNearMargin(const BenchTask& task, const TreePair& trees, const MeshOracle& oracle,
                                const std::vector<Truth>& truths, double margin, int bases) {
    Collector collector(margin);
    Workspace workspace;
    for (const std::size_t base : freePoses(truths, margin, bases)) {
        const DistanceResult near = distance(trees.part, trees.environment, task.poses[base], {}, workspace);
        const Vector3 between = near.witness->pointOnEnvironment - near.witness->pointOnPart;
        if (!(between.norm() > 0)) continue;
        for (const double target : targets(margin, task.sceneSize())) {
            // No pair comes nearer by more than the motion, and the closest pair comes nearer by the whole
            // motion.
            Pose pose = task.poses[base];
            pose.translation += (near.distance - target) / between.norm() * between;
            collector.add(pose, askOracle(oracle, task, pose));
        }
    }
    for (std::size_t i = 0; i < task.poses.size(); ++i) collector.add(task.poses[i], truths[i]);
    return collector.result();
}

}  // namespace clearway::testing
