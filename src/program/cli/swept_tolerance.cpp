#include "program/cli/swept_tolerance.h"

#include <algorithm>

#include "program/options/print.h"

namespace clearway::cli {

namespace {

constexpr double kUsualTolerance = 0.01;      ///< of the part's diagonal
constexpr double kErrorPerTolerance = 0.125;  ///< that sweptVolume allows
constexpr double kLeftOut = 2e-4;             ///< radians: OMPL may leave out turns below this
constexpr double kFloatRounding = 1e-6;       ///< of the largest coordinate, in the file

}  // namespace

double sweptTolerance(const PathOutputs& outputs, const Model& part) {
    return outputs.sweptTolerance.value_or(kUsualTolerance * part.box().diagonal().norm());
}

double sweptPlaceError(const std::vector<PartState>& path, double radius) {
    double turn = 0, farthest = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PartState &from = path[i], &to = path[std::min(i + 1, path.size() - 1)];
        const double angle = from.rotation.angularDistance(to.rotation);
        if (angle < kLeftOut) turn = std::max(turn, angle);
        farthest = std::max(farthest, from.position.norm() + (to.position - from.position).norm());
    }
    return radius * turn + kFloatRounding * (radius + farthest);
}

std::string whySweptIsTooFine(const PathOutputs& outputs, const Scene& scene,
                              const std::vector<PartState>& path) {
    if (outputs.swept.empty()) return "";
    const double tolerance = sweptTolerance(outputs, scene.part);
    const double error = sweptPlaceError(path, scene.part.radiusAboutOrigin());
    if (error < kErrorPerTolerance * tolerance) return "";
    return "--swept-tolerance is " + shownLength(tolerance) +
           (outputs.sweptTolerance ? "" : ", 1 % of the part's diagonal") +
           ", too fine for how exactly the part's places are known, expected at least " +
           inUnit(shortenedUp(error / kErrorPerTolerance * (1 + 1e-6)));
}

}  // namespace clearway::cli
