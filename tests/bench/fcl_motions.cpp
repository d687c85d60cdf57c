// Compares FCL and clearway as checkers of one planner. Both judge equal recorded states and motions, behind
// OMPL's discrete motion validator at its default resolution, and at states the problem's fineness apart.
//   benchmarks fcl_motions PROBLEM.cfg EDGES SEED [OUT.csv]
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <stdexcept>

#include "bench/fcl_planning.h"
#include "bench/recorded_edges.h"
#include "bench/stepped_motion_validator.h"
#include "core/clock.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "support/oracle.h"

namespace clearway::testing::fcl_motions {

constexpr double kRangePerFineness = 20;  // as in `clearway plan`
constexpr int kPasses =
    3;  ///< passes over all questions; the checkers take turns, and each question counts with its least time

struct Question {
    double seconds = std::numeric_limits<double>::infinity();
    bool answer = false;
};

struct Asked {
    std::vector<Question> states, motions, stepped;
};

/// Two space informations that differ only in their checker.
struct Side {
    Side(const std::string& itsName, const ob::StateSpacePtr& space)
        : name(itsName), si(std::make_shared<ob::SpaceInformation>(space)) {}
    void finish(const ob::StateValidityCheckerPtr& checker, const Model& part, double step) {
        si->setStateValidityChecker(checker);
        inSteps = std::make_shared<SteppedMotionValidator>(si, part, step);
        si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
        si->setup();
    }
    std::string name;
    ob::SpaceInformationPtr si;
    ob::MotionValidatorPtr inSteps;
    Asked asked;
};

template <typename Ask>
void time(Question& question, const Ask& ask) {
    const auto begin = Clock::now();
    question.answer = ask();
    question.seconds = std::min(question.seconds, secondsSince(begin));
}

void pass(Side& side, const std::vector<Edge>& edges) {
    side.asked.states.resize(edges.size());
    side.asked.motions.resize(edges.size());
    side.asked.stepped.resize(edges.size());
    const auto forEach = [&](std::vector<Question>& questions, const auto& ask) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            time(questions[i], [&] { return ask(edges[i].from.get(), edges[i].to.get()); });
        }
    };
    // All states are asked before all motions. Otherwise a checker that keeps its last answer would know a
    // motion's end state.
    forEach(side.asked.states, [&](const ob::State*, const ob::State* to) { return side.si->isValid(to); });
    forEach(side.asked.motions,
            [&](const ob::State* from, const ob::State* to) { return side.si->checkMotion(from, to); });
    forEach(side.asked.stepped,
            [&](const ob::State* from, const ob::State* to) { return side.inSteps->checkMotion(from, to); });
}

/// Sums over the questions that clearway answers alike: all valid, or all invalid.
struct Sums {
    std::size_t count = 0;
    double clearway = 0, fcl = 0;
};

Sums sum(const std::vector<Question>& clearway, const std::vector<Question>& fcl, bool which) {
    Sums sums;
    for (std::size_t i = 0; i < clearway.size(); ++i) {
        if (clearway[i].answer != which) continue;
        ++sums.count;
        sums.clearway += clearway[i].seconds;
        sums.fcl += fcl[i].seconds;
    }
    return sums;
}

std::string rowOf(const std::string& what, const Sums& sums) {
    const double count = static_cast<double>(sums.count);
    return what + "," + std::to_string(sums.count) + "," + shortNumber(sums.clearway / count * 1e6) + "," +
           shortNumber(sums.fcl / count * 1e6) + "," + shortNumber(sums.fcl / sums.clearway) + "\n";
}

std::string rows(const std::string& what, const std::vector<Question>& clearway,
                 const std::vector<Question>& fcl) {
    const Sums valid = sum(clearway, fcl, true), invalid = sum(clearway, fcl, false);
    const Sums all{valid.count + invalid.count, valid.clearway + invalid.clearway, valid.fcl + invalid.fcl};
    return rowOf(what, all) + rowOf("valid " + what, valid) + rowOf("invalid " + what, invalid);
}

/// Has the oracle decide the states at which both differ; motions can differ only by their states. Returns
/// the number of clearway's errors.
int settle(const std::vector<Edge>& edges, const Side& clearway, const Side& fcl, const MeshOracle& oracle,
           const Problem& problem) {
    int different = 0, wrong = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool ours = clearway.asked.states[i].answer;
        if (ours == fcl.asked.states[i].answer || !clearway.si->satisfiesBounds(edges[i].to.get())) continue;
        ++different;
        wrong += ours == oracle.collides(poseOf(planning::fromOmpl(problem.space, edges[i].to.get())));
    }
    std::cout << "states answered differently: " << different << ", by the oracle clearway is wrong in "
              << wrong << "\n";
    return wrong;
}

int run(int count, char** words) {
    if (count < 4) {
        std::cerr << "usage: benchmarks fcl_motions PROBLEM.cfg EDGES SEED [OUT.csv]\n";
        return 2;
    }
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(static_cast<std::uint32_t>(parseInteger(words[3]).value()));
    const Problem problem = readProblem(words[1]);
    const Mesh partMesh = loadPart(problem), environmentMesh = loadEnvironment(problem);
    const Scene scene{Model::build(partMesh), Model::build(environmentMesh), 0};
    if (!problem.fineness)
        throw std::invalid_argument("the problem has no fineness, expected one in [clearway]");
    const EdgeRecorder recorder(problem, scene, kRangePerFineness * *problem.fineness);
    const std::vector<Edge> edges = recorder.record(static_cast<std::size_t>(parseInteger(words[2]).value()));

    Side clearway("clearway", recorder.space()), fcl("FCL", recorder.space());
    clearway.finish(std::make_shared<planning::ValidityChecker>(clearway.si, scene), scene.part,
                    *problem.fineness);
    fcl.finish(std::make_shared<FclValidityChecker>(fcl.si, makeFclMeshes(partMesh, environmentMesh)),
               scene.part, *problem.fineness);
    for (int i = 0; i < kPasses; ++i) {
        pass(clearway, edges);
        pass(fcl, edges);
    }
    const std::string table =
        "what,count,clearway_us,fcl_us,times_faster\n" +
        rows("states", clearway.asked.states, fcl.asked.states) +
        rows("motions at OMPL's default", clearway.asked.motions, fcl.asked.motions) +
        rows("motions at the problem's step", clearway.asked.stepped, fcl.asked.stepped);
    std::cout << table;
    if (count > 4) replaceFile(words[4], [&](std::ostream& out) { out << table; });
    const MeshOracle oracle(partMesh, environmentMesh);
    return settle(edges, clearway, fcl, oracle, problem) == 0 ? 0 : 1;
}

}  // namespace clearway::testing::fcl_motions
