#include "bench/builds.h"

#include <tuple>

#include "clearway/model.h"
#include "core/clock.h"

namespace clearway::testing {
namespace {

std::size_t trianglesOf(const BenchTask& task) {
    return task.part.triangles.size() + task.environment.triangles.size();
}

bool makeTheSameTree(const BuildOptions& a, const BuildOptions& b) {
    return std::tie(a.generalSplit, a.leafSplit, a.leafSize, a.nodeWidth, a.fit) ==
           std::tie(b.generalSplit, b.leafSplit, b.leafSize, b.nodeWidth, b.fit);
}

void buildOnce(BuildRow& row, const BenchTask& task, const BuildOptions& options, double fclSeconds) {
    const auto start = Clock::now();
    const Model part = Model::build(task.part, options),
                environment = Model::build(task.environment, options);
    row.seconds.push_back(secondsSince(start));
    row.ratios.push_back(row.seconds.back() / fclSeconds);
    const auto bytes = static_cast<double>(part.report().tree.bytes + environment.report().tree.bytes);
    row.bytesPerTriangle =
        bytes / static_cast<double>(part.report().triangles + environment.report().triangles);
}

}  // namespace

std::vector<BuildChoice> buildChoices(const BuildOptions& chosen) {
    std::vector<BuildChoice> choices;
    bool isPreset = false;
    for (const std::string& name : buildPresetNames()) {
        choices.push_back({name, buildPreset(name)});
        isPreset = isPreset || makeTheSameTree(choices.back().options, chosen);
    }
    if (!isPreset) choices.push_back({"chosen", chosen});
    return choices;
}

std::vector<BuildRow> measureBuilds(const BenchTask& task, const std::vector<BuildChoice>& choices,
                                    const BuildSchedule& schedule) {
    std::vector<BuildRow> rows;
    for (const BuildChoice& choice : choices) {
        for (const char* threads : {"1 thread", "2 threads"}) {
            BuildRow row;
            row.name = "clearway " + choice.name + ", " + threads;
            rows.push_back(row);
        }
    }
    const auto start = Clock::now();
    for (int round = 0; round < schedule.rounds; ++round) {
        if (round > 0 && secondsSince(start) * (round + 1) / round > schedule.seconds) break;
        const double fclSeconds = makeFclRss(task.part, task.environment).buildSeconds;
        auto row = rows.begin();
        for (BuildChoice choice : choices) {
            for (const int threads : {1, 2}) {
                choice.options.threads = threads;
                buildOnce(*row++, task, choice.options, fclSeconds);
            }
        }
    }
    return rows;
}

std::vector<BuildRow> buildsOf(const std::vector<Peer>& peers, const BenchTask& task) {
    std::vector<BuildRow> rows;
    for (const Peer& peer : peers) {
        rows.push_back({peer.name,
                        {peer.buildSeconds},
                        {},
                        static_cast<double>(peer.bytes) / static_cast<double>(trianglesOf(task))});
    }
    return rows;
}

}  // namespace clearway::testing
