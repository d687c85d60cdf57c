#include "bench/bench_report.h"

#include <fmt/format.h>

#include <ostream>
#include <sstream>

#include "core/number.h"

namespace clearway::testing {
namespace {

/// The mean work of a query.
struct Work {
    double nodeVisits = 0, volumeTests = 0, triangleTests = 0, refinedPairs = 0;
};

Work workOf(const Series& series) {
    Work work;
    const auto n = static_cast<double>(series.answers.size());
    for (const Answer& answer : series.answers) {
        work.nodeVisits += static_cast<double>(answer.counters.nodeVisits) / n;
        work.volumeTests += static_cast<double>(answer.counters.volumeTests) / n;
        work.triangleTests += static_cast<double>(answer.counters.triangleTests) / n;
        work.refinedPairs += static_cast<double>(answer.counters.refinedPairs) / n;
    }
    return work;
}

/// A field of a CSV file.
std::string quoted(const std::string& text) {
    return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

int wrongOf(const BenchReport& report, const Series& series) {
    return report.judgement.wrong[static_cast<std::size_t>(&series - report.all.data())];
}

/// Six significant digits, for tables.
std::string figure(double value) {
    return fmt::format("{:.6g}", value);
}

/// Time and work of one side of a comparison.
void writeSide(std::ostream& out, const BenchReport& report, const Series& series) {
    const std::vector<double> times = series.medians();
    const Work work = workOf(series);
    for (const double value : {mean(times) / 1000, median(times) / 1000, work.nodeVisits, work.volumeTests,
                               work.triangleTests, work.refinedPairs}) {
        out << ',' << figure(value);
    }
    out << ',' << wrongOf(report, series);
}

/// The median, the least and the largest value as CSV fields, or three empty fields.
void writeRange(std::ostream& out, const std::vector<double>& values) {
    if (values.empty()) {
        out << ",,,";
    } else {
        out << ',' << figure(median(values)) << ',' << figure(least(values)) << ','
            << figure(largest(values));
    }
}

}  // namespace

std::string summaryHeader() {
    return "scene,scene_name,part_triangles,environment_triangles,poses,colliding,question,engine,over_"
           "question,"
           "over_engine,ratio,ratio_least,ratio_largest,repetitions,us_mean,us_median,node_visits,volume_"
           "tests,triangle_tests,refined_pairs,wrong,"
           "over_us_mean,over_us_median,over_node_visits,over_volume_tests,over_triangle_tests,"
           "over_refined_pairs,over_wrong\n";
}

std::string summaryRows(const BenchReport& report) {
    std::ostringstream out;
    for (const Comparison& row : comparisons(report.all)) {
        const std::vector<double> values = ratios(*row.ours, *row.theirs);
        out << report.task.name << ',' << report.task.sceneName << ',' << report.task.part.triangles.size()
            << ',' << report.task.environment.triangles.size() << ',' << report.task.poses.size() << ','
            << report.judgement.collidingPoses() << ',' << quoted(row.ours->asked) << ','
            << quoted(row.ours->engine) << ',' << quoted(row.theirs->asked) << ','
            << quoted(row.theirs->engine);
        writeRange(out, values);
        out << ',' << values.size();
        writeSide(out, report, *row.ours);
        writeSide(out, report, *row.theirs);
        out << '\n';
    }
    return out.str();
}

std::string buildsHeader() {
    return "scene,part_triangles,environment_triangles,build,seconds,over_fcl_rss,over_fcl_rss_least,"
           "over_fcl_rss_largest,rounds,bytes_per_triangle\n";
}

std::string buildsRows(const BenchReport& report) {
    std::ostringstream out;
    for (const BuildRow& row : report.builds) {
        out << report.task.name << ',' << report.task.part.triangles.size() << ','
            << report.task.environment.triangles.size() << ',' << quoted(row.name) << ','
            << figure(median(row.seconds));
        writeRange(out, row.ratios);
        out << ',' << row.seconds.size() << ',' << figure(row.bytesPerTriangle) << '\n';
    }
    return out.str();
}

std::string posesTable(const BenchReport& report) {
    std::ostringstream out;
    out << "pose,distance,by_oracle,lower,upper";
    std::vector<std::vector<double>> times;
    for (const Series& series : report.all) {
        const std::string name = series.asked + "; " + series.engine;
        out << ',' << quoted(name) << ',' << quoted(name + "; ns");
        if (series.isClearway) out << ',' << quoted(name + "; nodes");
        times.push_back(series.medians());
    }
    out << '\n';
    for (std::size_t i = 0; i < report.task.poses.size(); ++i) {
        out << i << ',' << formatNumber(report.judgement.distances[i]) << ',' << report.judgement.byOracle[i]
            << ',' << formatNumber(report.all.front().answers[i].lower) << ','
            << formatNumber(report.all.front().answers[i].upper);
        for (std::size_t k = 0; k < report.all.size(); ++k) {
            const Answer& answer = report.all[k].answers[i];
            out << ',' << formatNumber(answer.value) << ',' << figure(times[k][i]);
            if (report.all[k].isClearway) out << ',' << answer.counters.nodeVisits;
        }
        out << '\n';
    }
    return out.str();
}

}  // namespace clearway::testing
