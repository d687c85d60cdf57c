#include "torture/resting.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

#include "bench/series.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "torture/mesh_families.h"

namespace clearway::testing {
namespace {

constexpr int kPoses = 64;
constexpr int kCallsPerTiming = 8;

struct Resting {
    std::string name;
    Mesh part;
    Mesh environment;
    std::function<Vector3(Random&)> resting;  ///< draws translations in contact
    /// Moves a translation in contact to a gap of 1 % of the part's size.
    Vector3 away;
};

/// A whole multiple of 1/8 in [-reach, reach].
double eighths(Random& random, int reach) {
    return 0.125 * (random.below(16 * reach + 1) - 8 * reach);
}

Resting boxesFaceToFace(int cells) {
    return {"boxes face to face, " + std::to_string(cells) + " cells", box(Vector3(2, 2, 1), cells),
            box(Vector3(4, 4, 1), cells), [](Random& r) { return Vector3(eighths(r, 3), eighths(r, 3), 2); },
            Vector3(0, 0, 0.06)};
}

Resting boxesEdgeToEdge(int cells) {
    return {"shared edges, " + std::to_string(cells) + " cells", box(Vector3(2, 2, 1), cells),
            box(Vector3(4, 4, 1), cells), [](Random& r) { return Vector3(6, eighths(r, 5), 2); },
            Vector3(0.05, 0, 0.05)};
}

Resting squarePegInHole(int cells) {
    return {"square peg filling its hole, " + std::to_string(cells) + " cells", box(Vector3(3, 3, 3), cells),
            squareHole(cells), [](Random& r) { return Vector3(0, 0, eighths(r, 2)); }, Vector3(0, 0, 7.1)};
}

Resting roundPegInHole(int sides) {
    return {"round peg filling its hole, " + std::to_string(sides) + " sides", tube(3, 5, 12, sides),
            plateWithHole(20, 2, 5, sides), [](Random& r) { return Vector3(0, 0, eighths(r, 4)); },
            Vector3(0, 0, 11.2)};
}

Resting combInComb(int teeth) {
    return {"combs, " + std::to_string(teeth) + " teeth", comb(teeth), comb(teeth),
            [](Random& r) { return Vector3(1, eighths(r, 3), 0); }, Vector3(0, 0, 2.1)};
}

/// The median nanoseconds of one call over the poses; each pose counts with its least time over the
/// repetitions.
double medianTime(const Model& part, const Model& environment, const std::vector<Pose>& poses, bool isWarm,
                  int repetitions) {
    Workspace workspace;
    std::vector<double> best(poses.size(), 1e300);
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const auto start = std::chrono::steady_clock::now();
            for (int call = 0; call < kCallsPerTiming; ++call) {
                // A warm start comes from the previous pose of the set, not from an earlier repetition of
                // this pose.
                if (!isWarm) workspace.forgetWarmStart();
                collides(part, environment, poses[(i + std::size_t(call)) % poses.size()], workspace);
            }
            const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
            best[i] = std::min(best[i], taken.count() / kCallsPerTiming);
        }
    }
    return median(best);
}

double measure(std::ostream& out, const Resting& meshes, bool isWarm, int repetitions) {
    const Model part = Model::build(meshes.part), environment = Model::build(meshes.environment);
    Random random(1);
    std::vector<Pose> resting, clear;
    int contacts = 0, exact = 0;
    Workspace workspace;
    for (int i = 0; i < kPoses; ++i) {
        Pose pose{Matrix3::Identity(), meshes.resting(random)};
        resting.push_back(pose);
        workspace.forgetWarmStart();
        contacts += collides(part, environment, pose, workspace);
        exact += int(workspace.counters().exactPairs);
        pose.translation += meshes.away;
        clear.push_back(pose);
    }
    const double contact = medianTime(part, environment, resting, isWarm, repetitions),
                 free = medianTime(part, environment, clear, isWarm, repetitions);
    out << std::left << std::setw(46) << meshes.name + (isWarm ? ", warm" : ", cold") << std::right
        << std::fixed << std::setprecision(2) << std::setw(9) << contact / 1e3 << " us" << std::setw(9)
        << free / 1e3 << " us" << std::setw(8) << contact / free << std::setw(8) << contacts << '/' << kPoses
        << std::setw(8) << exact / double(kPoses) << '\n';
    return contact / free;
}

}  // namespace

double measureResting(std::ostream& out, int repetitions) {
    out << std::left << std::setw(46) << "collides" << std::right << std::setw(12) << "resting"
        << std::setw(12) << "clear" << std::setw(8) << "ratio" << std::setw(11) << "contact" << std::setw(8)
        << "exact" << '\n';
    std::vector<double> ratios;
    for (const Resting& meshes : {boxesFaceToFace(1), boxesFaceToFace(16), boxesEdgeToEdge(1),
                                  boxesEdgeToEdge(16), squarePegInHole(1), squarePegInHole(8),
                                  roundPegInHole(24), roundPegInHole(200), combInComb(5), combInComb(40)}) {
        for (const bool isWarm : {true, false}) ratios.push_back(measure(out, meshes, isWarm, repetitions));
    }
    const double middle = median(ratios), worst = *std::max_element(ratios.begin(), ratios.end());
    out << "median ratio " << middle << ", largest " << worst << '\n';
    return middle;
}

}  // namespace clearway::testing
