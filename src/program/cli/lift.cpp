#include "program/cli/lift.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

#include "clearway/errors.h"
#include "clearway/scene_clearance.h"
#include "clearway/shrink.h"
#include "core/clock.h"
#include "core/number.h"
#include "model/triangles_of.h"
#include "program/options/facts.h"
#include "program/options/print.h"

namespace clearway::cli {
namespace {

constexpr double kFaceDepth = 0.74;  ///< of an overlap: a flat contact so deep is just free
constexpr double kLeastLift = 1e-8;  ///< of the part's diagonal
constexpr double kLiftStep = 2;      ///< from one overlap to the next that may free the start
constexpr double kLiftError = 0.05;  ///< of the least overlap that frees a start
/// The room that planners need, of the diagonal of the part or, if it is smaller, of an obstacle that it touches.
constexpr double kRoomToMove = 0.005;
constexpr double kMostLift = 0.02;      ///< of the part's diagonal, where nobody asked
constexpr double kMostAskedLift = 0.2;  ///< and where somebody did
constexpr double kMostLiftSeconds = 5;  ///< for overlaps to be tried, where nobody asked

class LiftSearch {
  public:
    LiftSearch(Problem problem, ProblemScenes& scenes) : problem_(std::move(problem)), scenes_(scenes) {
        problem_.margin = 0;
        problem_.rules.margins.clear();
        problem_.rules.overlap = {};
    }

    WhyInvalid whyStartIsInvalid(double overlap) {
        problem_.rules.overlap.common = overlap;
        const SceneClearance clearance(scenes_.wholeScene(problem_));
        const Scene& scene = clearance.scene();
        size_ = scene.part.box().diagonal().norm();
        WhyInvalid why = clearance.whyInvalid(poseOf(problem_.start));
        if (why.nearest.witness && !touchedSize_) {
            const auto component = static_cast<std::size_t>(why.nearest.witness->environmentComponent);
            touchedSize_ = sizeOf(scene.obstacles[*why.obstacle].model, component);
        }
        return why;
    }

    /// An overlap that nothing can be shrunk by frees nothing.
    bool isFree(double overlap) {
        try {
            return whyStartIsInvalid(overlap).isValid();
        } catch (const ArgumentError&) {
            return false;
        }
    }
    double size() const { return size_; }  ///< of the part, once it was asked about

    /// More overlap does not always free more: thin places get shallower. So the least one is sought from below.
    Lift find(double depth, double most, const std::function<bool()>& isSpent) {
        double enough = std::max(depth / kFaceDepth, kLeastLift * size_), tooLittle = 0;
        WhyInvalid why;
        while (!(why = whyStartIsInvalid(enough)).isValid()) {
            tooLittle = enough;
            enough *= kLiftStep;
            if (enough <= most && !isSpent()) continue;
            throw std::invalid_argument("no overlap up to " + shownLength(tooLittle) +
                                        " frees the start: " + why.words());
        }
        while (tooLittle > 0 && enough - tooLittle > kLiftError * enough && !isSpent()) {
            const double middle = 0.5 * (tooLittle + enough);
            (isFree(middle) ? enough : tooLittle) = middle;
        }
        Lift lift{awayFromZero(enough, 3), 0};
        double room = kRoomToMove * std::min(size_, touchedSize_.value_or(size_));
        do {
            lift.tryFirst = awayFromZero(lift.least + room, 3);
            room *= isSpent() ? 0 : 0.5;
        } while (lift.tryFirst > lift.least && !isFree(lift.tryFirst));
        return lift;
    }

  private:
    static double sizeOf(const Model& model, std::size_t component) {
        Box box;
        eachTriangleOf(model, [&](std::size_t i, const TriangleCorners& corners) {
            if (i != component) return;
            for (const Vector3& corner : corners) box.extend(corner);
        });
        return box.diagonal().norm();
    }

    Problem problem_;
    ProblemScenes& scenes_;
    double size_ = 0;
    std::optional<double> touchedSize_;  ///< diagonal of the first obstacle that the part touched
};

}  // namespace

std::optional<Lift> findLift(const Problem& problem, ProblemScenes& scenes,
                             const std::vector<FoundOverlap>& overlaps, bool isAsked) {
    LiftSearch search(problem, scenes);
    const WhyInvalid::Kind kind = search.whyStartIsInvalid(0).kind;
    if (kind != WhyInvalid::Kind::kCollides && kind != WhyInvalid::Kind::kInSolid) return std::nullopt;
    double depth = 0;
    for (const FoundOverlap& found : overlaps) depth = std::max(depth, found.deepest.lower);
    const Clock::time_point begin = Clock::now();
    return search.find(depth, (isAsked ? kMostAskedLift : kMostLift) * search.size(),
                       [&] { return !isAsked && secondsSince(begin) > kMostLiftSeconds; });
}

void tell(const Lift& lift) {
    facts()["lift"] = {{"overlap", toJson(lift.least)}, {"try_first", toJson(lift.tryFirst)}};
    printRow("frees the start", "overlap = " + depthText(lift.least));
    printRow("to try first", "overlap = " + depthText(lift.tryFirst));
}

std::optional<Lift> tellLiftIfAny(const Problem& problem, ProblemScenes& scenes) {
    try {
        const std::optional<Lift> lift =
            findLift(problem, scenes, overlapsAtStart(problem, scenes.meshes()), false);
        if (lift) tell(*lift);
        return lift;
    } catch (const std::invalid_argument& refusal) {
        printRow("overlap", std::string("not known: ") + refusal.what());
    } catch (const ShrinkStopped&) {
        printRow("overlap", "not known: interrupted");
    }
    return std::nullopt;
}

}  // namespace clearway::cli
