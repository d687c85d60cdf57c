#include "bench/judge.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/number.h"
#include "support/oracle.h"

namespace clearway::testing {
namespace {

/// Peers may answer contact with a number below 0.
double distanceOf(const Answer& answer) {
    return answer.value < 0 ? 0 : answer.value;
}

bool isOff(double a, double b, double tolerance) {
    return !(std::abs(a - b) <= tolerance);  // NaN is too far off
}

/// Clearway's own distance at the pose, with its interval.
const Series& referenceOf(const std::vector<Series>& all) {
    for (const Series& series : all) {
        if (series.isClearway && series.question == Question::kDistance) return series;
    }
    throw std::invalid_argument("no series asks clearway for distances, expected at least one");
}

bool differs(const Series& series, const Answer& answer, const Answer& reference, double tolerance) {
    switch (series.question) {
        case Question::kDistance:
            return isOff(distanceOf(answer), reference.value, tolerance);
        case Question::kCollides:
            return (answer.value != 0) != (reference.upper == 0);
        case Question::kIsWithin:
            return (answer.value != 0) != (reference.value <= series.within);
    }
    return true;
}

bool contradictsTruth(const Series& series, const Answer& answer, double truth, double tolerance) {
    const bool yes = answer.value != 0;
    switch (series.question) {
        case Question::kDistance:
            return isOff(distanceOf(answer), truth, tolerance) ||
                   (series.isClearway &&
                    !(answer.lower <= truth + tolerance && answer.upper >= truth - tolerance));
        case Question::kCollides:
            return yes ? !(truth <= tolerance) : truth == 0;
        case Question::kIsWithin:
            return yes ? !(truth <= series.within + tolerance) : truth < series.within - tolerance;
    }
    return true;
}

bool contradictsItself(const Series& series, const Answer& answer, const Answer& reference) {
    const bool yes = answer.value != 0;
    switch (series.question) {
        case Question::kDistance:
            return (answer.upper == 0) != (reference.upper == 0);
        case Question::kCollides:
            return yes != (reference.upper == 0);
        case Question::kIsWithin:
            return yes ? reference.lower > series.within : reference.upper <= series.within;
    }
    return true;
}

bool isWrong(const Series& series, const Answer& answer, const Answer& reference, double truth,
             double tolerance) {
    return contradictsTruth(series, answer, truth, tolerance) ||
           (series.isClearway && contradictsItself(series, answer, reference));
}

bool isSpotChecked(std::size_t pose, std::size_t poses, std::size_t refereed) {
    return refereed > 0 && pose % std::max<std::size_t>(1, poses / refereed) == 0;
}

}  // namespace

Referee lazyOracle(const BenchTask& task) {
    auto oracle = std::make_shared<std::unique_ptr<MeshOracle>>();
    return [oracle, &task](std::size_t pose) {
        if (!*oracle) *oracle = std::make_unique<MeshOracle>(task.part, task.environment);
        return (*oracle)->distance(task.poses[pose]).distance;
    };
}

int Judgement::collidingPoses() const {
    return static_cast<int>(std::count(distances.begin(), distances.end(), 0.0));
}

int Judgement::askedPoses() const {
    return static_cast<int>(std::count(byOracle.begin(), byOracle.end(), true));
}

Judgement judge(const std::vector<Series>& all, std::size_t poses, double tolerance, const Referee& referee,
                std::size_t refereed) {
    const Series& reference = referenceOf(all);
    Judgement judgement;
    judgement.wrong.assign(all.size(), 0);
    for (std::size_t i = 0; i < poses; ++i) {
        const Answer& own = reference.answers[i];
        const bool asked = isSpotChecked(i, poses, refereed) ||
                           std::any_of(all.begin(), all.end(), [&](const Series& series) {
                               return differs(series, series.answers[i], own, tolerance);
                           });
        const double truth = asked ? referee(i) : own.value;
        judgement.distances.push_back(truth);
        judgement.byOracle.push_back(asked);
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (!isWrong(all[k], all[k].answers[i], own, truth, tolerance)) continue;
            ++judgement.wrong[k];
            if (!all[k].isClearway) continue;
            judgement.complaints.push_back("pose " + std::to_string(i) + ": " + all[k].asked + ", " +
                                           all[k].engine + ", says " + formatNumber(all[k].answers[i].value) +
                                           ", the true distance is " + formatNumber(truth));
        }
    }
    return judgement;
}

}  // namespace clearway::testing
