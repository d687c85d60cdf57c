#include "bench/builds.h"

#include "clearway/model.h"
#include "core/clock.h"

namespace clearway::testing {
namespace {

std::size_t trianglesOf(const BenchTask& task) {
    return task.part.triangles.size() + task.environment.triangles.size();
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

std::vector<BuildRow> measureBuilds(const BenchTask& task, BuildOptions options,
                                    const BuildSchedule& schedule) {
    std::vector<BuildRow> rows(2);
    rows[0].name = "clearway, 1 thread";
    rows[1].name = "clearway, 2 threads";
    const auto start = Clock::now();
    for (int round = 0; round < schedule.rounds; ++round) {
        if (round > 0 && secondsSince(start) * (round + 1) / round > schedule.seconds) break;
        const double fclSeconds = makeFclRss(task.part, task.environment).buildSeconds;
        for (options.threads = 1; options.threads <= 2; ++options.threads)
            buildOnce(rows[std::size_t(options.threads - 1)], task, options, fclSeconds);
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
