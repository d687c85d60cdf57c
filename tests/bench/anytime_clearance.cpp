// Records how the best certified least clearance grows with planning time, or with FMT's samples.
//   benchmarks anytime_clearance SECONDS SEEDS OUT.csv [SCENE...]
// SCENE: posts, gates, window, or a problem's .cfg; by default the first three and tunnel-console-small. The
// table has rows at SECONDS of processor time, and at a half, a quarter and an eighth of SECONDS.
// RRTConnect's row is for its first path.
#include <iostream>
#include <string>
#include <vector>

#include "clearway/planning/clearance_objectives.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "support/anytime_planner.h"
#include "support/planar_scenes.h"
#include "support/window_scene.h"

namespace clearway::testing::anytime_clearance {

using Parameters = AnytimePlanner::Parameters;

constexpr const char* kObjective = "max_min_clearance";
constexpr int kHalvings = 3;

struct Contender {
    const char* planner;
    Parameters parameters;
};

/// The planners, with the parameters of OMPL and of `clearway plan` except for those named here.
const std::vector<Contender> kAnytime = {
    {"RRTstar", {{"range", "60"}}},
    {"PRMstar", {}},
    {"AnytimePathShortening", {}},
    {"BITstar", {}},
    {"RisingFloor", {}},
};

struct Marching {
    const char* objective;
    std::vector<int> samples;
};

const std::vector<Marching> kMarching = {{"clearance_integral", {250, 500, 1000, 2000, 4000}},
                                         {kObjective, {250, 500, 1000}}};
constexpr double kMostSecondsOfFmt = 60;

struct Place {
    std::string name;
    Problem problem;
    Scene scene;
};

Place placeOf(const std::string& name) {
    if (name == "posts") return {name, postsScene().problem, postsScene().scene};
    if (name == "gates") return {name, gatesScene().problem, gatesScene().scene};
    if (name == "window") return {name, windowScene().problem, windowScene().scene};
    Problem problem = readProblem(name);
    const Scene scene(Model::build(loadPart(problem)), Model::build(loadEnvironment(problem)),
                      problem.margin);
    return {problem.name.empty() ? name : problem.name, problem, scene};
}

std::string joined(const Parameters& parameters) {
    std::string all;
    for (const auto& [name, value] : parameters) all += (all.empty() ? "" : " ") + name + "=" + value;
    return all;
}

class Table {
  public:
    void add(const Place& place, const Contender& contender, std::uint32_t seed, double seconds,
             AnytimePlanner& planner) {
        const auto& objective = dynamic_cast<const planning::ClearanceObjective&>(planner.objective());
        const planning::ObjectiveCounters counters = objective.counters();
        const std::optional<double> best = planner.best();
        const std::string row =
            place.name + "," + contender.planner + "," + joined(contender.parameters) + "," +
            objective.getDescription() + "," + std::to_string(seed) + "," + shortNumber(seconds) + "," +
            (best ? shortNumber(*best) : "") + "," + (best ? shortNumber(planner.certifiedClearance()) : "") +
            "," + std::to_string(counters.motions) + "," + std::to_string(counters.queries) + "\n";
        std::cout << row << std::flush;
        text_ += row;
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_ =
        "scene,planner,parameters,objective,seed,seconds,cost,certified_clearance,objective_motions,"
        "objective_queries\n";
};

/// Only for problems in the plane, because in space FMT's neighbourhoods have hundreds of states.
template <class PlannerFor>
void measureFmt(const Place& place, std::uint32_t seed, const PlannerFor& plannerFor, Table& table) {
    for (const Marching& marching : kMarching) {
        for (const int samples : marching.samples) {
            const Contender fmt{"FMT", {{"num_samples", std::to_string(samples)}}};
            AnytimePlanner planner = plannerFor(fmt, marching.objective);
            table.add(place, fmt, seed, planner.planSeconds(kMostSecondsOfFmt), planner);
        }
    }
}

void measure(const Place& place, std::uint32_t seed, double seconds, Table& table) {
    const auto plannerFor = [&](const Contender& contender, const char* objective = kObjective) {
        return AnytimePlanner(place.problem, place.scene, contender.planner, contender.parameters, objective,
                              seed);
    };
    for (const Contender& contender : kAnytime) {
        AnytimePlanner planner = plannerFor(contender);
        double spent = 0;
        for (int halving = kHalvings; halving >= 0; --halving) {
            const double until = seconds / (1 << halving);
            if (!planner.isSatisfied()) planner.planSeconds(until - spent);
            spent = until;
            table.add(place, contender, seed, spent, planner);
        }
    }
    if (place.problem.space == Space::kSe2) measureFmt(place, seed, plannerFor, table);
    const Contender first{"RRTConnect", {}};
    AnytimePlanner planner = plannerFor(first);
    table.add(place, first, seed, planner.planSeconds(seconds), planner);
}

int run(int count, char** words) {
    if (count < 4) {
        std::cerr << "usage: benchmarks anytime_clearance SECONDS SEEDS OUT.csv [SCENE...]\n";
        return 2;
    }
    const double seconds = parseNumber(words[1]).value();
    const auto seeds = static_cast<std::uint32_t>(parseInteger(words[2]).value());
    std::vector<std::string> scenes(words + 4, words + count);
    if (scenes.empty()) {
        scenes = {"posts", "gates", "window", CLEARWAY_DATA_DIR "/tunnel-console-small/tunnel-console.cfg"};
    }
    Table table;
    for (const std::string& scene : scenes) {
        const Place place = placeOf(scene);
        for (std::uint32_t seed = 1; seed <= seeds; ++seed) measure(place, seed, seconds, table);
    }
    replaceFile(words[3], [&](std::ostream& out) { out << table.text(); });
    return 0;
}

}  // namespace clearway::testing::anytime_clearance
