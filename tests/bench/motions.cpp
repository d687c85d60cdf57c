// Measures the cost of certified motions on the edges that RRTConnect proposes, valid and invalid edges
// apart. Compares them with OMPL's discrete validator and clearway's checker at OMPL's default resolution,
// and with steps as short as a small margin.
//   benchmarks motions PROBLEM.cfg|SCENE [EDGES [SEED [OUT.csv NAME]]]      NAME: the scene's, in the table
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "bench/recorded_edges.h"
#include "bench/stepped_motion_validator.h"
#include "clearway/planning/motion_validator.h"
#include "core/clock.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "demos/scenes/scenes.h"

namespace clearway::testing::motions {

using namespace scenes;
namespace {

using planning::MotionValidator;
using planning::ValidityChecker;

constexpr double kRangePerDiagonal = 0.25;  // as in `clearway plan` where no fineness is stated
constexpr double kSmallMargin = 0.1;        // environment units
constexpr double kRoomy = 5;                // mean clearance, environment units
constexpr int kIntegralPoses = 400;

struct Figures {
    std::vector<double> certified, discrete, margined, stepped;  // seconds
    double queries = 0, integral = 0;                            // over all edges
};

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

double sum(const std::vector<double>& values) {
    double all = 0;
    for (const double value : values) all += value;
    return all;
}

class Bench {
  public:
    Bench(const Problem& problem, const Mesh& partMesh, const Mesh& environmentMesh)
        : scene_{Model::build(partMesh), Model::build(environmentMesh), problem.margin},
          recorder_(problem, scene_, kRangePerDiagonal * scene_.part.box().diagonal().norm()) {}

    /// Returns the figures as rows of a table that begin with `scene`.
    std::string run(std::size_t edges, const std::string& scene) {
        const std::vector<Edge> recorded = recorder_.record(edges);
        const auto si = recorder_.makeSpaceInformation(scene_);
        si->setup();
        const MotionValidator certified(si, scene_);
        const ob::DiscreteMotionValidator discrete(si);
        const Pass certifiedPass = pass(certified, recorded), discretePass = pass(discrete, recorded);
        for (std::size_t i = 0; i < recorded.size(); ++i) {
            Figures& figures = certifiedPass.isValid[i] ? valid_ : invalid_;
            figures.certified.push_back(certifiedPass.seconds[i]);
            figures.discrete.push_back(discretePass.seconds[i]);
            if (certifiedPass.isValid[i]) measureValid(si, certified, recorded[i]);
        }
        const double share = sum(roomy_.stepped) / sum(roomy_.margined);
        std::string rows;
        for (const auto* figures : {&valid_, &invalid_}) {
            const double certifiedUs = 1e6 * median(figures->certified),
                         discreteUs = 1e6 * median(figures->discrete);
            rows += row(scene,
                        figures == &valid_ ? "valid, OMPL's default steps" : "invalid, OMPL's default steps",
                        figures->certified.size(), certifiedUs, discreteUs, discreteUs / certifiedUs);
        }
        const auto roomy = static_cast<double>(roomy_.margined.size());
        rows += row(scene, "valid with clearance, steps of the margin", roomy_.margined.size(),
                    1e6 * sum(roomy_.margined) / roomy, 1e6 * sum(roomy_.stepped) / roomy, share);
        return rows + row(scene, "queries over the integral of ds / clearance", valid_.certified.size(), 0, 0,
                          valid_.queries / valid_.integral);
    }

    static constexpr const char* kHeader = "scene,what,count,us_certified,us_compared,times\n";

  private:
    struct Pass {
        std::vector<double> seconds;
        std::vector<char> isValid;
    };

    /// Runs twice and measures the second pass only.
    static Pass pass(const ob::MotionValidator& validator, const std::vector<Edge>& edges) {
        Pass result;
        for (int turn = 0; turn < 2; ++turn) {
            result = {};
            for (const Edge& edge : edges) {
                bool isValid = false;
                result.seconds.push_back(seconds(validator, edge, isValid));
                result.isValid.push_back(isValid);
            }
        }
        return result;
    }

    void measureValid(const ob::SpaceInformationPtr& si, const MotionValidator& validator, const Edge& edge) {
        const auto queriesBefore = validator.counters().queries;
        validator.checkMotion(edge.from.get(), edge.to.get());
        valid_.queries += double(validator.counters().queries - queriesBefore);
        const auto& checker = static_cast<const ValidityChecker&>(*si->getStateValidityChecker());
        const auto bound = planning::displacementBound(*si->getStateSpace(), scene_.part);
        const double length = bound(edge.from.get(), edge.to.get());
        ob::ScopedState<> state(si->getStateSpace());
        double mean = 0;
        for (int i = 0; i < kIntegralPoses; ++i) {
            const double time = (i + 0.5) / kIntegralPoses;
            si->getStateSpace()->interpolate(edge.from.get(), edge.to.get(), time, state.get());
            const double clearance = checker.clearance(state.get());
            valid_.integral += length / kIntegralPoses / clearance;
            mean += clearance / kIntegralPoses;
        }
        if (mean < kRoomy) return;
        Scene scene = scene_;
        scene.obstacles[0].margin = kSmallMargin;
        const auto kept = recorder_.makeSpaceInformation(scene);
        const MotionValidator certified(kept, scene);
        const SteppedMotionValidator stepped(kept, scene.part, kSmallMargin);
        bool isValid = false;
        const double certifiedSeconds = seconds(certified, edge, isValid);
        if (!isValid) return;
        roomy_.margined.push_back(certifiedSeconds);
        roomy_.stepped.push_back(seconds(stepped, edge, isValid));
    }

    static double seconds(const ob::MotionValidator& validator, const Edge& edge, bool& isValid) {
        const auto begin = Clock::now();
        isValid = validator.checkMotion(edge.from.get(), edge.to.get());
        return secondsSince(begin);
    }

    /// Empty fields where nothing was measured.
    static std::string row(const std::string& scene, const std::string& what, std::size_t count,
                           double certified, double compared, double times) {
        std::string text = scene + ",\"" + what + "\"," + std::to_string(count);
        for (const double value : {certified, compared, times}) {
            text += "," + (value > 0 ? shortNumber(value) : std::string());
        }
        return text + "\n";
    }

    Scene scene_;
    EdgeRecorder recorder_;
    Figures valid_, invalid_, roomy_;
};

}  // namespace

int run(int count, char** words) {
    if (count < 2) {
        std::cerr << "usage: benchmarks motions PROBLEM.cfg|SCENE [EDGES [SEED [OUT.csv NAME]]]\n";
        return 2;
    }
    const std::string what = words[1];
    const auto edges = static_cast<std::size_t>(count > 2 ? parseInteger(words[2]).value() : 1000);
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(static_cast<std::uint32_t>(count > 3 ? parseInteger(words[3]).value() : 1));
    const std::string name = count > 5 ? words[5] : what;
    std::string table = Bench::kHeader;
    if (what.size() > 4 && what.substr(what.size() - 4) == ".cfg") {
        const Problem problem = readProblem(what);
        table += Bench(problem, loadPart(problem), loadEnvironment(problem)).run(edges, name);
    } else {
        const NamedScene& row = sceneNamed(what);
        const GeneratedScene made = row.make(row.defaults);
        table += Bench(made.problem, made.part, made.environment).run(edges, name);
    }
    std::cout << table;
    if (count > 4) replaceFile(words[4], [&](std::ostream& out) { out << table; });
    return 0;
}

}  // namespace clearway::testing::motions
