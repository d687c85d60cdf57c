#include "program/cli/lift.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "clearway/scene_clearance.h"
#include "core/number.h"
#include "program/cli/overlaps.h"
#include "program/options/facts.h"
#include "program/options/print.h"

namespace clearway::cli {
namespace {

constexpr double kMostLift = 0.01;   ///< of the part's diagonal: what reaches in deeper does not just touch
constexpr double kLeastLift = 1e-6;  ///< of the most
constexpr double kLiftStep = 0.25;   ///< from one overlap to the next that may free the start
constexpr double kLiftError = 0.02;  ///< of the least overlap that frees a start
constexpr double kToTryFirst = 7;    ///< times the least, with which there is hardly any room to move

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
        size_ = clearance.scene().part.box().diagonal().norm();
        return clearance.whyInvalid(poseOf(problem_.start));
    }

    bool isFree(double overlap) { return whyStartIsInvalid(overlap).isValid(); }
    double size() const { return size_; }  ///< of the part, once it was asked about

    /// The least overlap that frees the start, to kLiftError; none up to `most`.
    std::optional<double> least(double most) {
        if (!isFree(most)) return std::nullopt;
        double enough = most, tooLittle = 0;
        while (enough > kLeastLift * most && tooLittle == 0) {
            const double next = kLiftStep * enough;
            (isFree(next) ? enough : tooLittle) = next;
        }
        while (tooLittle > 0 && enough - tooLittle > kLiftError * enough) {
            const double middle = std::sqrt(tooLittle * enough);
            (isFree(middle) ? enough : tooLittle) = middle;
        }
        return awayFromZero(enough, 3);
    }

  private:
    Problem problem_;
    ProblemScenes& scenes_;
    double size_ = 0;
};

}  // namespace

std::optional<Lift> findLift(Problem problem, ProblemScenes& scenes) {
    LiftSearch search(std::move(problem), scenes);
    if (search.whyStartIsInvalid(0).kind != WhyInvalid::Kind::kCollides) return std::nullopt;
    const std::optional<double> least = search.least(kMostLift * search.size());
    if (!least) return std::nullopt;
    return Lift{*least, awayFromZero(kToTryFirst * *least, 3)};
}

void tell(const Lift& lift) {
    facts()["lift"] = {{"overlap", toJson(lift.least)}, {"try_first", toJson(lift.tryFirst)}};
    printRow("frees the start", "overlap = " + depthText(lift.least));
    printRow("to try first", "overlap = " + depthText(lift.tryFirst));
}

std::optional<Lift> tellLiftIfAny(const Problem& problem, ProblemScenes& scenes) {
    try {
        const std::optional<Lift> lift = findLift(problem, scenes);
        if (lift) tell(*lift);
        return lift;
    } catch (const std::invalid_argument& refusal) {
        printRow("overlap", std::string("cannot be allowed: ") + refusal.what());
        return std::nullopt;
    }
}

}  // namespace clearway::cli
