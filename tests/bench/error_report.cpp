#include "bench/error_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/number.h"

namespace clearway::testing {
namespace {

std::string inShort(double value) {
    return fmt::format("{:.4g}", value);
}

/// The median, the 99.9th percentile and the worst value as CSV fields; empty fields without values.
std::vector<std::string> fields(const Spread& spread) {
    if (spread.count == 0) return {"", "", ""};
    return {inShort(spread.median), inShort(spread.p999), inShort(spread.worst)};
}

}  // namespace

Spread spreadOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = static_cast<std::size_t>(std::ceil(0.999 * static_cast<double>(values.size()))) - 1;
    return {values.size(), median(values), values[at], values.back()};
}

ModeFigures figuresOf(const Mode& mode, const Series& floatOnly, const std::vector<Truth>& truths,
                      double sceneSize) {
    const Series& series = mode.series;
    ModeFigures figures;
    figures.mode = mode.name();
    figures.isQuery = mode.isQuery;
    figures.queriesPerSecond = 1e9 / mean(series.medians());
    figures.overFloatOnly = mean(series.medians()) / mean(floatOnly.medians());
    figures.passRatios = ratios(floatOnly, series);
    if (mode.says == Mode::Says::kVerdict) return figures;
    std::vector<double> errors, widths;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const Answer& answer = series.answers[i];
        const auto [truth, oracleError] = truths[i];
        const bool isBeyondCap = mode.isQuery && std::isinf(answer.value);
        figures.beyondCap += isBeyondCap;
        if (!isBeyondCap) errors.push_back(std::abs(answer.value - truth) / sceneSize);
        if (!mode.isProved()) continue;
        figures.outside += !(answer.lower <= truth + oracleError && answer.upper >= truth - oracleError);
        if (mode.says == Mode::Says::kInterval && !isBeyondCap) {
            widths.push_back((answer.upper - answer.lower) / sceneSize);
        }
    }
    figures.errors = spreadOf(errors);
    figures.widths = spreadOf(widths);
    return figures;
}

std::vector<std::string> faults(const ErrorReport& report) {
    std::vector<std::string> lines;
    for (const ModeFigures& mode : report.modes) {
        if (!mode.isQuery) continue;
        const auto tell = [&](int count, const std::string& what) {
            if (count > 0)
                lines.push_back(report.scene + ", " + mode.mode + ": " + std::to_string(count) + ' ' + what);
        };
        tell(mode.outside, "intervals do not hold the true distance");
        for (std::size_t k = 0; k < report.margins.size(); ++k) {
            const std::string where =
                " at a margin of " + inShort(report.marginShares[k]) + " of the scene's size";
            tell(mode.verdicts[k].falseValid, "poses falsely called valid" + where);
            if (mode.widths.count == 0)
                tell(mode.verdicts[k].falseInvalid, "poses falsely called invalid" + where);
        }
    }
    return lines;
}

std::string errorHeader(const std::vector<double>& marginShares) {
    std::string header =
        "scene,mode,poses,colliding,queries_per_second,time_over_float_only,time_over_float_only_least,"
        "time_over_float_only_largest,repetitions,error_median,error_p999,error_worst,width_median,width_"
        "p999,"
        "width_worst,beyond_cap,outside";
    for (const double share : marginShares) {
        const std::string at = "_at_" + shortNumber(share);
        header +=
            ",poses" + at + ",valid" + at + ",left_out" + at + ",false_valid" + at + ",false_invalid" + at;
    }
    return header + '\n';
}

std::string errorRows(const ErrorReport& report) {
    std::ostringstream out;
    for (const ModeFigures& mode : report.modes) {
        out << report.scene << ',' << mode.mode << ',' << report.poses << ',' << report.colliding << ','
            << inShort(mode.queriesPerSecond) << ',' << inShort(mode.overFloatOnly) << ','
            << inShort(least(mode.passRatios)) << ',' << inShort(largest(mode.passRatios)) << ','
            << mode.passRatios.size();
        for (const Spread* spread : {&mode.errors, &mode.widths}) {
            for (const std::string& field : fields(*spread)) out << ',' << field;
        }
        out << ',' << mode.beyondCap << ',' << mode.outside;
        for (std::size_t k = 0; k < report.margins.size(); ++k) {
            const PosesNearMargin& near = report.margins[k];
            out << ',' << near.poses.size() << ',' << near.validPoses() << ',' << near.undecided << ','
                << mode.verdicts[k].falseValid << ',' << mode.verdicts[k].falseInvalid;
        }
        out << '\n';
    }
    return out.str();
}

}  // namespace clearway::testing
