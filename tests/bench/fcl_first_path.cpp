// Measures the time to the first path that is really free, by RRTConnect with certified motions and by
// RRTConnect with FCL at states a step apart. The step is the coarsest at which 95 % of the paths are free. A
// path counts if every motion of it is certified. A run without such a path counts with the time limit. Times
// are processor times of one thread, so other work on the machine hardly matters.
//   benchmarks fcl_first_path PROBLEM.cfg SEEDS LIMIT STEP|find [OUT.csv]
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <optional>

#include "bench/fcl_planning.h"
#include "bench/stepped_motion_validator.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "planning/space/ompl_states.h"

namespace clearway::testing::fcl_first_path {

using planning::MotionValidator;
using planning::ValidityChecker;

constexpr double kRangePerFineness = 20, kRangePerDiagonal = 0.25;  // as in `clearway plan`
constexpr double kCoarsestPerDiagonal = 0.02;  ///< the first step tried; each further step is half as long
constexpr int kMostHalvings = 12;
constexpr double kEnough = 0.95;  ///< share of the paths found

struct Run {
    double seconds = 0;
    bool isFound = false;
    bool isFree = false;  ///< the whole path is certified
};

/// The checker and the validator of a planner.
struct Checking {
    std::function<ob::StateValidityCheckerPtr(const ob::SpaceInformationPtr&)> checker;
    std::function<ob::MotionValidatorPtr(const ob::SpaceInformationPtr&)> validator;
};

class Bench {
  public:
    Bench(const Problem& problem, double limit)
        : problem_(problem),
          limit_(limit),
          partMesh_(loadPart(problem)),
          environmentMesh_(loadEnvironment(problem)),
          scene_{Model::build(partMesh_), Model::build(environmentMesh_), 0},
          fcl_(makeFclMeshes(partMesh_, environmentMesh_)) {}

    Checking certified() const {
        return {[this](const auto& si) { return std::make_shared<ValidityChecker>(si, scene_); },
                [this](const auto& si) { return std::make_shared<MotionValidator>(si, scene_); }};
    }
    /// Makes the checker and validator in steps. Both libraries get one step, so that a seed gives both equal
    /// trees wherever their verdicts agree.
    Checking stepped(double step, bool isFcl) const {
        return {[this, isFcl](const ob::SpaceInformationPtr& si) -> ob::StateValidityCheckerPtr {
                    if (isFcl) return std::make_shared<FclValidityChecker>(si, fcl_);
                    return std::make_shared<ValidityChecker>(si, scene_);
                },
                [this, step](const auto& si) {
                    return std::make_shared<SteppedMotionValidator>(si, scene_.part, step);
                }};
    }

    Run run(const Checking& checking, std::uint32_t seed) const {
        ompl::RNG::setSeed(seed);
        const auto si = std::make_shared<ob::SpaceInformation>(planning::makeSpace(
            problem_.space, boundsOf(problem_, scene_.environmentBox(), scene_.part.box()),
            scene_.part.radiusAboutOrigin()));
        si->setStateValidityChecker(checking.checker(si));
        si->setMotionValidator(checking.validator(si));
        si->setup();
        const auto definition = std::make_shared<ob::ProblemDefinition>(si);
        definition->setStartAndGoalStates(
            planning::toOmpl(si->getStateSpace(), problem_.space, problem_.start),
            planning::toOmpl(si->getStateSpace(), problem_.space, problem_.goal));
        og::RRTConnect planner(si);
        planner.setRange(problem_.fineness ? kRangePerFineness * *problem_.fineness
                                           : kRangePerDiagonal * diagonal());
        planner.setProblemDefinition(definition);
        planner.setup();
        const std::clock_t begin = std::clock();
        const auto seconds = [&] { return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC; };
        planner.solve(ob::PlannerTerminationCondition([&] { return seconds() >= limit_; }));
        Run result;
        result.seconds = std::min(seconds(), limit_);
        result.isFound = definition->hasExactSolution();
        if (result.isFound) {
            result.isFree = isFree(si, *definition->getSolutionPath()->as<og::PathGeometric>());
        }
        return result;
    }

    double diagonal() const { return scene_.part.box().diagonal().norm(); }
    double limit() const { return limit_; }

  private:
    /// True if the whole path is certified. The least interval here is finer than the planners', so that a
    /// motion that passed in one direction passes in the other.
    bool isFree(const ob::SpaceInformationPtr& si, const og::PathGeometric& path) const {
        planning::MotionOptions options;
        options.leastInterval = 1e-6 * diagonal();
        const MotionValidator validator(si, scene_, options);
        for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i) {
            if (!validator.checkMotion(path.getState(i), path.getState(i + 1))) return false;
        }
        return true;
    }

    Problem problem_;
    double limit_;
    Mesh partMesh_, environmentMesh_;
    Scene scene_;
    std::shared_ptr<const FclMeshes> fcl_;
};

struct Series {
    std::string name;
    double step = 0;  ///< 0: certified
    std::vector<Run> runs;

    int found() const {
        return static_cast<int>(
            std::count_if(runs.begin(), runs.end(), [](const Run& r) { return r.isFound; }));
    }
    int free() const {
        return static_cast<int>(
            std::count_if(runs.begin(), runs.end(), [](const Run& r) { return r.isFree; }));
    }
    /// The median of the seconds until a free path; runs without a free path count with the limit.
    double median(double limit) const {
        std::vector<double> seconds;
        for (const Run& run : runs) seconds.push_back(run.isFree ? run.seconds : limit);
        std::sort(seconds.begin(), seconds.end());
        return (seconds[(seconds.size() - 1) / 2] + seconds[seconds.size() / 2]) / 2;
    }
};

std::string rowOf(const Series& series, double limit) {
    return series.name + "," + shortNumber(series.step) + "," + std::to_string(series.runs.size()) + "," +
           std::to_string(series.found()) + "," + std::to_string(series.free()) + "," +
           shortNumber(series.median(limit)) + "," + shortNumber(limit) + "\n";
}

/// Finds the coarsest step at which 95 % of the paths found are free. Clearway's checker stands in for FCL
/// here: its verdicts are equal, and it is many times faster.
std::vector<Series> findStep(const Bench& bench, std::uint32_t seeds) {
    std::vector<Series> tried;
    double step = kCoarsestPerDiagonal * bench.diagonal();
    for (int i = 0; i <= kMostHalvings; ++i, step /= 2) {
        Series series{"clearway in steps", step, {}};
        for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
            series.runs.push_back(bench.run(bench.stepped(step, false), seed));
        }
        std::cout << rowOf(series, bench.limit()) << std::flush;
        tried.push_back(series);
        if (series.found() > 0 && series.free() >= kEnough * series.found()) return tried;
    }
    throw std::runtime_error("no step of those tried makes " + shortNumber(kEnough) + " of the paths free");
}

int run(int count, char** words) {
    if (count < 5) {
        std::cerr << "usage: benchmarks fcl_first_path PROBLEM.cfg SEEDS LIMIT STEP|find [OUT.csv]\n";
        return 2;
    }
    ompl::msg::noOutputHandler();
    const auto seeds = static_cast<std::uint32_t>(parseInteger(words[2]).value());
    const Bench bench(readProblem(words[1]), parseNumber(words[3]).value());
    std::string table = "checked_by,step,seeds,found,free,median_seconds_to_a_free_path,limit\n";
    std::cout << table;
    const std::optional<double> given = parseNumber(words[4]);
    const std::vector<Series> tried = given ? std::vector<Series>() : findStep(bench, seeds);
    for (const Series& series : tried) table += rowOf(series, bench.limit());
    // Both take turns, so that other work in the processor's caches disturbs them equally.
    Series certified{"clearway certified", 0, {}},
        fcl{"FCL in steps", given ? *given : tried.back().step, {}};
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        certified.runs.push_back(bench.run(bench.certified(), seed));
        fcl.runs.push_back(bench.run(bench.stepped(fcl.step, true), seed));
    }
    const double ratio = fcl.median(bench.limit()) / certified.median(bench.limit());
    table += rowOf(certified, bench.limit()) + rowOf(fcl, bench.limit());
    std::cout << rowOf(certified, bench.limit()) << rowOf(fcl, bench.limit())
              << "median over median: " << shortNumber(ratio) << "\n";
    if (count > 5) replaceFile(words[5], [&](std::ostream& out) { out << table; });
    return 0;
}

}  // namespace clearway::testing::fcl_first_path
