#include "program/scenes/replay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "clearway/query.h"
#include "program/scenes/path_curve.h"
#include "program/scenes/random.h"

namespace clearway::scenes {

namespace {

constexpr double kShareTolerance = 0.02;
constexpr double kLargestAmplitude = 8;  // part sizes

struct Wave {
    double weight, cycles, phase;
};

/// Six sums of sines; about 1 at most places.
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

/// Poses with the wanted share, if this deviation has an amplitude for it.
std::optional<std::vector<Pose>> bisected(const PoseTask& task, const PathCurve& curve, const Waves& waves,
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

}  // namespace

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
