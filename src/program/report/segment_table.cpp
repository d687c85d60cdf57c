#include <cmath>
#include <cstdio>

#include "program/report/frames.h"
#include "program/report/report.h"

namespace clearway::report {

namespace {

using planning::MotionVerdict;
using planning::SegmentAudit;

/// Towards zero: what is certified is never rounded up.
std::string shortened(double value) {
    if (!std::isfinite(value)) return "-";
    if (value == 0) return "0";
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::trunc(value / unit) * unit);
    return text;
}

std::string verdictOf(const SegmentAudit& segment) {
    if (segment.isValid()) return "valid";
    if (!segment.motion.problem.empty()) return segment.motion.problem;
    if (segment.motion.verdict == MotionVerdict::kUndecided) return "undecided";
    return segment.motion.leavesBounds ? "out of bounds" : "collides";
}

}  // namespace

ReportTable segmentTable(const planning::PathAudit& audit, const std::vector<PartState>& path,
                         double turnRadius) {
    ReportTable table;
    table.title = "Segments";
    table.header = {"", "verdict", "length", "clearance", "closest pair"};
    const PathLine line(path, turnRadius);
    for (std::size_t i = 0; i < audit.segments.size(); ++i) {
        const SegmentAudit& segment = audit.segments[i];
        const double clearance =
            segment.isValid() ? segment.motion.lowerClearance : segment.motion.upperClearance;
        const std::string pair =
            segment.partMesh.empty() ? "" : segment.partMesh + " and " + segment.environmentMesh;
        table.rows.push_back({std::to_string(i + 1), verdictOf(segment), shortened(segment.length),
                              shortened(clearance), pair});
        table.shares.push_back(shareIn(line, i, segment.motion.closestTime));
    }
    return table;
}

}  // namespace clearway::report
