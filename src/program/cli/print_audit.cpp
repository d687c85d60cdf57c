#include "program/cli/print_audit.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <ostream>
#include <utility>

#include "core/number.h"
#include "core/replace_file.h"
#include "program/cli/print.h"

namespace clearway::cli {

namespace {

using planning::MotionReport;
using planning::PathAudit;
using planning::SegmentAudit;

/// So many digits, towards zero: what is certified is never rounded up.
std::string shortened(double value, int digits = 4) {
    if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : "inf";
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits);
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, std::trunc(value / unit) * unit);
    return text;
}

/// In one word.
std::string nameOf(const SegmentAudit& segment) {
    constexpr std::pair<const char*, const char*> kNames[] = {{"in collision", "collides"},
                                                              {"too close", "too close"},
                                                              {"outside", "outside"},
                                                              {"undecided", "undecided"}};
    if (segment.isValid()) return "valid";
    for (const auto& [begin, name] : kNames) {
        if (segment.trouble.rfind(begin, 0) == 0) return name;
    }
    return "unusable";
}

/// The pair that is closest, and its triangles.
std::string pairOf(const SegmentAudit& segment) {
    if (segment.partMesh.empty()) return "";
    return "'" + segment.partMesh + "' (" + std::to_string(segment.motion.closest.partTriangle) + ") and '" +
           segment.environmentMesh + "' (" + std::to_string(segment.motion.closest.environmentTriangle) + ")";
}

/// How far a segment that is not valid is so.
std::string validUpTo(const SegmentAudit& segment) {
    const double time = segment.motion.certifiedTime;
    return time > 0 ? "valid up to t = " + shortened(time) : "not valid from its beginning";
}

void printCells(const std::string& segment, const std::string& verdict, const std::string& length,
                const std::string& turned, const std::string& clearance, const std::string& time,
                const std::string& between) {
    char text[160];
    std::snprintf(text, sizeof text, "%7s  %-9s %9s %8s %10s %7s", segment.c_str(), verdict.c_str(),
                  length.c_str(), turned.c_str(), clearance.c_str(), time.c_str());
    std::cout << text << (between.empty() ? "" : "  ") << between << "\n";
}

/// Where obstacles were ignored for the part was within a contact zone.
void printContact(const char* label, const PathAudit& audit,
                  std::optional<planning::TimeSpan> MotionReport::*contact) {
    std::string spans;
    for (std::size_t k = 0; k < audit.segments.size(); ++k) {
        const std::optional<planning::TimeSpan>& span = audit.segments[k].motion.*contact;
        if (!span) continue;
        spans += (spans.empty() ? "in segment " : "; ") + std::to_string(k + 1) +
                 " from t = " + shortened(span->first) + " to " + shortened(span->last);
    }
    if (!spans.empty()) printRow(label, "used " + spans);
}

}  // namespace

std::string leastClearanceOf(const PathAudit& audit) {
    if (std::isinf(audit.lowerClearance)) return "nothing to keep clear of";
    if (std::isinf(audit.upperClearance)) return readable(audit.lowerClearance) + " or more";
    return readable(audit.lowerClearance) + " to " + readable(audit.upperClearance);
}

void printAudit(const PathAudit& audit) {
    const std::size_t count = audit.segments.size();
    if (audit.isValid()) {
        printRow("audit", "valid along the whole path, certified");
    } else {
        const SegmentAudit& first = audit.segments[audit.notValid[0]];
        printRow("audit",
                 "NOT valid: " + std::to_string(audit.notValid.size()) + " of " + counted(count, "segment"));
        printRow("first", "segment " + std::to_string(audit.notValid[0] + 1) + ", " + validUpTo(first) +
                              ", is " + first.trouble);
    }
    printContact("start contact", audit, &MotionReport::startContact);
    printContact("goal contact", audit, &MotionReport::goalContact);
    const SegmentAudit& closest = audit.segments[audit.closest];
    const std::string where = closest.partMesh.empty()
                                  ? ""
                                  : ", in segment " + std::to_string(audit.closest + 1) +
                                        " at t = " + shortened(closest.motion.closestTime) + ", " +
                                        readable(closest.X_environmentPart.translation) + ", between " +
                                        pairOf(closest);
    printRow("least clearance", leastClearanceOf(audit) + where);
}

void printSegments(const PathAudit& audit) {
    printCells("segment", "verdict", "length", "turned", "clearance", "at t", "between (triangles)");
    for (std::size_t k = 0; k < audit.segments.size(); ++k) {
        const SegmentAudit& segment = audit.segments[k];
        const MotionReport& motion = segment.motion;
        const bool isLooked = motion.problem.empty() && !std::isinf(motion.upperClearance);
        const double clearance = segment.isValid() ? motion.lowerClearance : motion.upperClearance;
        const bool isTold = segment.isValid() || isLooked;
        const std::string between = isLooked ? pairOf(segment) : "";
        const std::string trouble = segment.isValid() ? "" : validUpTo(segment);
        printCells(std::to_string(k + 1), nameOf(segment), shortened(segment.length),
                   shortened(segment.turned * 180 / M_PI), isTold ? shortened(clearance) : "-",
                   isTold ? shortened(motion.closestTime) : "-",
                   between + (between.empty() || trouble.empty() ? "" : "; ") + trouble);
    }
}

void writeProfile(const PathAudit& audit, const std::string& file) {
    replaceFile(file, [&](std::ostream& stream) {
        stream << "segment,t,travel,clearance,clearance_to_next\n";
        for (const planning::PathProfilePoint& point : audit.profile) {
            stream << point.segment + 1 << "," << formatNumber(point.time) << ","
                   << formatNumber(point.travel) << "," << formatNumber(point.clearance) << ","
                   << formatNumber(point.lowerToNext) << "\n";
        }
    });
}

}  // namespace clearway::cli
