// Compares a space that gives velocities (a StateMotion) with one that only bounds displacements, on the motions of a planner or of a
// path: verdicts, times and work.
//   benchmarks certified_motions PROBLEM.cfg PLANNER|PATH COUNT [SCENE TABLE.csv]
// PLANNER: one of OMPL's, whose motions are recorded. PATH: a path file, whose segments are the motions.
// TABLE.csv: the figures are appended to it, under the scene's name. Ends with 1 when velocities lose a verdict: valid by the bound,
// but not by them.
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/planners.h"
#include "clearway/planning/validity_checker.h"
#include "clearway/problem.h"
#include "clearway/scene_clearance.h"
#include "core/clock.h"
#include "core/number.h"
#include "planning/space/ompl_states.h"

namespace clearway::testing::certified_motions {

using planning::MotionValidator;

constexpr std::size_t kLeastClearances = 20;  // by the bound, one takes up to 4 s

struct RecordedMotion {
    ob::ScopedState<> from, to;
    bool isForward;
};

/// Passes motions on and keeps them.
class MotionRecorder : public ob::MotionValidator {
  public:
    MotionRecorder(const ob::SpaceInformationPtr& si, const Scene& scene)
        : ob::MotionValidator(si), space_(si->getStateSpace()), validator_(si, scene) {}
    bool checkMotion(const ob::State* s1, const ob::State* s2) const override {
        motions.push_back({ob::ScopedState<>(space_, s1), ob::ScopedState<>(space_, s2), false});
        return validator_.checkMotion(s1, s2);
    }
    bool checkMotion(const ob::State* s1, const ob::State* s2,
                     std::pair<ob::State*, double>& lastValid) const override {
        motions.push_back({ob::ScopedState<>(space_, s1), ob::ScopedState<>(space_, s2), true});
        return validator_.checkMotion(s1, s2, lastValid);
    }
    mutable std::vector<RecordedMotion> motions;

  private:
    ob::StateSpacePtr space_;
    planning::MotionValidator validator_;
};

/// An answer, its time and the work of its queries.
struct Answer {
    bool isValid = false;
    double certifiedTime = 0, seconds = 0;
    std::uint64_t visits = 0, triangleTests = 0, undecided = 0;
};

class Comparison {
  public:
    explicit Comparison(const Problem& problem)
        : problem_(problem),
          scene_(Model::build(loadPart(problem)), Model::build(loadEnvironment(problem)), problem.margin) {
        space_ =
            planning::makeSpace(problem.space, boundsOf(problem, scene_.environmentBox(), scene_.part.box()),
                                scene_.part.radiusAboutOrigin());
        si_ = std::make_shared<ob::SpaceInformation>(space_);
        si_->setStateValidityChecker(std::make_shared<planning::ValidityChecker>(si_, scene_));
        si_->setup();
    }

    void record(const std::string& planner, std::size_t count) {
        const auto recorder = std::make_shared<MotionRecorder>(si_, scene_);
        si_->setMotionValidator(recorder);
        while (recorder->motions.size() < count) {
            const auto definition = std::make_shared<ob::ProblemDefinition>(si_);
            definition->setStartAndGoalStates(planning::toOmpl(space_, problem_.space, problem_.start),
                                              planning::toOmpl(space_, problem_.space, problem_.goal));
            const ob::PlannerPtr made = planning::makePlanner(si_, planner);
            if (planning::hasParameter(*made, "range")) {
                planning::setParameter(*made, "range",
                                       shortNumber(0.25 * scene_.part.box().diagonal().norm()));
            }
            made->setProblemDefinition(definition);
            made->setup();
            made->solve(ob::PlannerTerminationCondition([&] { return recorder->motions.size() >= count; }));
        }
        motions_ = recorder->motions;
        motions_.erase(motions_.begin() + static_cast<long>(count), motions_.end());
    }

    void read(const std::string& path, std::size_t count) {
        const std::vector<PartState> states = readPath(path, problem_.space);
        for (std::size_t i = 0; i + 1 < states.size() && motions_.size() < count; ++i) {
            motions_.push_back({planning::toOmpl(space_, problem_.space, states[i]),
                                planning::toOmpl(space_, problem_.space, states[i + 1]), false});
        }
    }

    /// Returns how many verdicts are lost. label: begins the rows of the table.
    std::size_t compare(std::ostream* table, const std::string& label) {
        const MotionValidator byVelocities(si_, scene_);
        const MotionValidator byBound(
            si_, planning::SharedScene(scene_, planning::stateToPose(*space_),
                                       planning::displacementBound(*space_, scene_.part)));
        byBound_.assign(motions_.size(), {});
        Rows rows{table, label, {}};
        std::vector<Answer> withVelocities(motions_.size());
        for (int turn = 0; turn < 2; ++turn) {
            for (std::size_t i = 0; i < motions_.size(); ++i)
                withVelocities[i] = ask(byVelocities, motions_[i], withVelocities[i]);
            for (std::size_t i = 0; i < motions_.size(); ++i)
                byBound_[i] = ask(byBound, motions_[i], byBound_[i]);
        }
        const auto areValid = [](const Answer& bound, const Answer& velocities) {
            return bound.isValid && velocities.isValid;
        };
        rows.verdicts = countVerdicts(byBound_, withVelocities);
        print("valid", byBound_, withVelocities, areValid, rows);
        print(
            "invalid", byBound_, withVelocities,
            [&](const Answer& a, const Answer& b) { return !areValid(a, b); }, rows);
        printLeastClearances(rows);
        double further = 0, shorter = 0;
        for (std::size_t i = 0; i < motions_.size(); ++i) {
            if (!motions_[i].isForward || byBound_[i].isValid || withVelocities[i].isValid) continue;
            const double length = planning::displacementBound(*space_, scene_.part)(motions_[i].from.get(),
                                                                                    motions_[i].to.get());
            const double more = (withVelocities[i].certifiedTime - byBound_[i].certifiedTime) * length;
            further = std::max(further, more);
            shorter = std::max(shorter, -more);
        }
        std::cout << "forward up to " << further << " further, " << shorter << " shorter\n";
        return rows.verdicts.lost;
    }

  private:
    struct Verdicts {
        std::size_t lost = 0, gained = 0;  ///< valid by the bound alone; valid by velocities alone
    };

    Answer ask(const MotionValidator& validator, const RecordedMotion& motion, const Answer& sofar) const {
        Answer answer;
        const auto undecided = validator.counters().undecided;
        takeQueryTally();
        std::pair<ob::State*, double> lastValid(nullptr, 1);
        const auto begin = Clock::now();
        answer.isValid = motion.isForward
                             ? validator.checkMotion(motion.from.get(), motion.to.get(), lastValid)
                             : validator.checkMotion(motion.from.get(), motion.to.get());
        answer.seconds = secondsSince(begin);
        if (sofar.seconds > 0) answer.seconds = std::min(answer.seconds, sofar.seconds);
        answer.certifiedTime = answer.isValid ? 1 : lastValid.second;
        const QueryTally tally = takeQueryTally();
        answer.visits = tally.work.nodeVisits;
        answer.triangleTests = tally.work.kernelPairs;
        answer.undecided = validator.counters().undecided - undecided;
        return answer;
    }

    /// Writes the table, if there is one.
    struct Rows {
        std::ostream* out;
        std::string label;
        Verdicts verdicts;
        void add(const char* what, std::size_t count, double byBound, double byVelocities,
                 double visitsByBound, double visitsByVelocities) const {
            if (out == nullptr || count == 0) return;
            *out << label << "," << what << "," << count << "," << byBound * 1e6 << "," << byVelocities * 1e6
                 << "," << byBound / byVelocities << "," << visitsByBound << "," << visitsByVelocities << ","
                 << verdicts.lost << "," << verdicts.gained << "\n";
        }
    };

    template <class Counts>
    void print(const char* what, const std::vector<Answer>& byBound, const std::vector<Answer>& byVelocities,
               const Counts& counts, const Rows& rows) const {
        double boundSeconds = 0, velocitySeconds = 0, boundVisits = 0, velocityVisits = 0, boundPairs = 0,
               velocityPairs = 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < motions_.size(); ++i) {
            if (!counts(byBound[i], byVelocities[i])) continue;
            ++count;
            boundSeconds += byBound[i].seconds;
            velocitySeconds += byVelocities[i].seconds;
            boundVisits += double(byBound[i].visits);
            velocityVisits += double(byVelocities[i].visits);
            boundPairs += double(byBound[i].triangleTests);
            velocityPairs += double(byVelocities[i].triangleTests);
        }
        const double n = std::max<double>(1, double(count));
        std::cout << what << ": " << count << " motions; us a motion " << boundSeconds / n * 1e6 << " -> "
                  << velocitySeconds / n * 1e6 << " (" << boundSeconds / velocitySeconds << " times); visits "
                  << boundVisits / n << " -> " << velocityVisits / n << "; pairs " << boundPairs / n << " -> "
                  << velocityPairs / n << "\n";
        rows.add(what, count, boundSeconds / n, velocitySeconds / n, boundVisits / n, velocityVisits / n);
    }

    static Verdicts countVerdicts(const std::vector<Answer>& byBound,
                                  const std::vector<Answer>& byVelocities) {
        std::size_t lost = 0, gained = 0, undecidedByBound = 0, undecidedByVelocities = 0;
        for (std::size_t i = 0; i < byBound.size(); ++i) {
            lost += byBound[i].isValid && !byVelocities[i].isValid;
            gained += !byBound[i].isValid && byVelocities[i].isValid;
            undecidedByBound += byBound[i].undecided;
            undecidedByVelocities += byVelocities[i].undecided;
        }
        std::cout << byBound.size() << " verdicts: " << lost << " lost, " << gained << " gained; undecided "
                  << undecidedByBound << " -> " << undecidedByVelocities << "\n";
        return {lost, gained};
    }

    /// Times the least clearance, as MinClearanceObjective asks for it, of at most kLeastClearances valid motions.
    void printLeastClearances(const Rows& rows) const {
        const planning::MinClearanceObjective byVelocities(si_, scene_),
            byBound(si_, planning::SharedScene(scene_, planning::stateToPose(*space_),
                                               planning::displacementBound(*space_, scene_.part)));
        double boundSeconds = 0, velocitySeconds = 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < motions_.size() && count < kLeastClearances; ++i) {
            if (!byBound_[i].isValid) continue;
            const ob::State *from = motions_[i].from.get(), *to = motions_[i].to.get();
            const auto seconds = [&](const planning::MinClearanceObjective& objective) {
                const auto begin = Clock::now();
                objective.motionCost(from, to);
                return secondsSince(begin);
            };
            boundSeconds += seconds(byBound);
            velocitySeconds += seconds(byVelocities);
            ++count;
        }
        const double n = std::max<double>(1, double(count));
        std::cout << "least clearance: " << count << " valid motions; us a motion " << boundSeconds / n * 1e6
                  << " -> " << velocitySeconds / n * 1e6 << " (" << boundSeconds / velocitySeconds
                  << " times)\n";
        rows.add("least clearance", count, boundSeconds / n, velocitySeconds / n, 0, 0);
    }

    Problem problem_;
    Scene scene_;
    ob::StateSpacePtr space_;
    ob::SpaceInformationPtr si_;
    std::vector<RecordedMotion> motions_;
    std::vector<Answer> byBound_;
};

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

std::ofstream openTable(const std::string& file) {
    const bool isNew = !std::ifstream(file);
    std::ofstream out(file, std::ios::app);
    if (isNew)
        out << "scene,motions,kind,count,us_by_bound,us_by_velocities,times_faster,visits_by_bound,"
               "visits_by_velocities,verdicts_lost,verdicts_gained\n";
    return out;
}

int run(int count, char** words) {
    if (count != 4 && count != 6) {
        std::cerr << "usage: benchmarks certified_motions PROBLEM.cfg PLANNER|PATH COUNT [SCENE TABLE.csv]\n";
        return 2;
    }
    const std::string what = words[2];
    const bool hasTable = count == 6;
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(1);
    Comparison comparison(readProblem(words[1]));
    const auto most = static_cast<std::size_t>(parseInteger(words[3]).value());
    const bool isPath = endsWith(what, ".path");
    if (isPath) {
        comparison.read(what, most);
    } else {
        comparison.record(what, most);
    }
    std::cout << words[1] << " " << what << "\n";
    std::ofstream table;
    if (hasTable) table = openTable(words[5]);
    const std::string label = hasTable ? std::string(words[4]) + "," + (isPath ? "path" : what) : "";
    const std::size_t lost = comparison.compare(hasTable ? &table : nullptr, label);
    if (hasTable && !table.flush()) throw std::runtime_error(std::string("cannot write '") + words[5] + "'");
    return lost > 0;
}

}  // namespace clearway::testing::certified_motions
