#include "program/cli/print_audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <ostream>

#include "core/number.h"
#include "problem/clearance_word.h"
#include "program/cli/csv_cells.h"
#include "program/report/frames.h"

namespace clearway::cli {

namespace {

using planning::MotionReport;
using planning::PathAudit;
using planning::PathProfilePoint;
using planning::SegmentAudit;

/// Names the closest pair of meshes and its triangles.
std::string pairOf(const SegmentAudit& segment) {
    if (segment.partMesh.empty()) return "";
    return "'" + segment.partMesh + "' (" + std::to_string(segment.motion.closest.witness->partTriangle) +
           ") and '" + segment.environmentMesh + "' (" +
           std::to_string(segment.motion.closest.witness->environmentTriangle) + ")";
}

/// Says up to where an invalid segment is valid.
std::string validUpTo(const SegmentAudit& segment) {
    const double time = segment.motion.certifiedTime;
    return time > 0 ? "valid up to t = " + shortened(time) : "not valid from its beginning";
}

void printCells(const std::string& segment, const std::string& verdict, const std::string& length,
                const std::string& rotation, const std::string& clearance, const std::string& time,
                const std::string& between) {
    std::cout << fmt::format("{:>7}  {:<14} {:>9} {:>8} {:>10} {:>7}{}{}\n", segment, verdict, length,
                             rotation, clearance, time, between.empty() ? "" : "  ", between);
}

/// Where the part was within a contact zone; empty: nowhere.
std::string contactSpans(const PathAudit& audit, std::optional<planning::TimeSpan> MotionReport::*contact) {
    std::string spans;
    for (std::size_t k = 0; k < audit.segments.size(); ++k) {
        const std::optional<planning::TimeSpan>& span = audit.segments[k].motion.*contact;
        if (!span) continue;
        spans += (spans.empty() ? "in segment " : "; ") + std::to_string(k + 1) +
                 " from t = " + shortened(span->first) + " to " + shortened(span->last);
    }
    return spans.empty() ? "" : "used " + spans;
}

/// The closest pair at a pose: mesh, triangle and point of the part, then those of the environment.
std::string pairCells(const SceneClearance& clearance, const Pose& X_environmentPart) {
    SceneDistance nearest;
    if (!clearance.isOutOfRange(X_environmentPart)) nearest = clearance.at(X_environmentPart).nearest;
    if (!nearest.witness) return ",,,,,,,,,";
    const MeshNames names = distinctMeshNames(clearance.scene(), nearest);
    return textCell(names.part) + "," + std::to_string(nearest.witness->partTriangle) + "," +
           numberCells(nearest.witness->pointOnPart) + "," + textCell(names.environment) + "," +
           std::to_string(nearest.witness->environmentTriangle) + "," +
           numberCells(nearest.witness->pointOnEnvironment);
}

/// Says where the path is closest. Points are in the environment's frame, as the pose is.
void printClosest(const PathAudit& audit, const Scene& scene) {
    const SegmentAudit& closest = audit.segments[audit.closest];
    const SceneDistance& pair = closest.motion.closest;
    const Obstacle& obstacle = scene.obstacles[*pair.obstacle];
    const auto point = [](const std::string& mesh, std::int64_t triangle, bool isShrunk,
                          const Vector3& place) {
        return "triangle " + std::to_string(triangle) + " of '" + mesh +
               (isShrunk ? "' as it is shrunk, at " : "', at ") + shownPlace(place);
    };
    printRow("  on the path",
             "segment " + std::to_string(audit.closest + 1) + " of " + std::to_string(audit.segments.size()) +
                 ", t = " + shortened(closest.motion.closestTime) + " (0 its start, 1 its end)");
    printRow("  on the part", point(closest.partMesh, pair.witness->partTriangle, obstacle.shrunk != nullptr,
                                    pair.witness->pointOnPart));
    printRow("  on the obstacle", point(closest.environmentMesh, pair.witness->environmentTriangle,
                                        obstacle.shrunkBy > 0, pair.witness->pointOnEnvironment));
    const Eigen::Quaterniond q(closest.X_environmentPart.rotation);
    PartState state;
    state.position = closest.X_environmentPart.translation;
    state.rotation.coeffs() = q.coeffs();
    printRow("  pose of the part", shownState(state));
    printRow("", "(in the environment's frame; triangles count from 0)");
}

// The size of the plot, in characters.
constexpr int kColumns = 66;
constexpr int kRows = 14;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Column {
    double certain = kInfinity;  ///< no pose in this column has less clearance
    double found = kInfinity;    ///< least clearance at the queried poses, else interpolated between them
};

int columnOf(double travel, double whole) {
    return std::clamp(static_cast<int>(kColumns * travel / whole), 0, kColumns - 1);
}

std::vector<Column> columnsOf(const std::vector<PathProfilePoint>& profile) {
    std::vector<Column> columns(kColumns);
    const double whole = profile.back().travel;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const PathProfilePoint& here = profile[k];
        const PathProfilePoint& next = profile[std::min(k + 1, profile.size() - 1)];
        const int first = columnOf(here.travel, whole), last = columnOf(next.travel, whole);
        columns[first].found = std::min(columns[first].found, here.clearance);
        for (int c = first; c <= last; ++c) {
            columns[c].certain = std::min(columns[c].certain, here.lowerToNext);
            if (c == first || c == last) continue;
            const double share = (whole * (c + 0.5) / kColumns - here.travel) / (next.travel - here.travel);
            columns[c].found = here.clearance + share * (next.clearance - here.clearance);
        }
    }
    return columns;
}

/// The clearances of the plot's rows, lowest first, evenly spaced on a logarithmic scale.
std::vector<double> levelsOf(const std::vector<Column>& columns) {
    double low = kInfinity, high = 0;
    for (const Column& column : columns) {
        for (const double value : {column.certain, column.found}) {
            if (value > 0) low = std::min(low, value);
        }
        if (std::isfinite(column.found)) high = std::max(high, column.found);
    }
    std::vector<double> levels;
    if (!(low < kInfinity) || !(high > 0)) return levels;
    low = std::max(low, 1e-6 * high);  // a clearance near 0 must not flatten the rest
    for (int row = 0; row < kRows; ++row) {
        levels.push_back(low * std::pow(high / low, static_cast<double>(row) / (kRows - 1)));
    }
    return levels;
}

char footOf(const Column& column) {
    if (column.found <= 0) return 'x';
    return column.certain > 0 ? '-' : '?';
}

}  // namespace

Rows contactRows(const PathAudit& audit) {
    Rows rows;
    const std::string atStart = contactSpans(audit, &MotionReport::startContact),
                      atGoal = contactSpans(audit, &MotionReport::goalContact);
    if (!atStart.empty()) rows.push_back({"start contact", atStart});
    if (!atGoal.empty()) rows.push_back({"goal contact", atGoal});
    return rows;
}

std::string leftOutAt(const PoseClearance& at) {
    if (at.isInStartContact && at.isInGoalContact)
        return ", leaving out the obstacles of contact.start and contact.goal";
    if (at.isInStartContact) return ", leaving out the obstacles of contact.start";
    return at.isInGoalContact ? ", leaving out the obstacles of contact.goal" : "";
}

std::string slackLimit(const Scene& scene, const SceneDistance& nearest) {
    if (!mayOverlap(scene) || !nearest.obstacle || !nearest.witness) return "";
    const Obstacle& obstacle = scene.obstacles[*nearest.obstacle];
    if (obstacle.overlap() > 0) return " before the overlap may exceed " + statedLength(obstacle.overlap());
    return obstacle.margin > 0 ? " before the margin " + statedLength(obstacle.margin) + " is reached"
                               : " before they touch";
}

Rows leastClearanceRow(const PathAudit& audit, const Scene& scene) {
    const std::string least = shortened(audit.lowerClearance);
    return {
        {std::string("least ") + clearanceWord(scene),
         std::isinf(audit.lowerClearance) ? "nothing to keep clear of"
         : std::isinf(audit.upperClearance)
             ? inUnit(least) + " or more"
             : inUnit(least + " to " + shortenedUp(audit.upperClearance)) +
                   (audit.isValid() ? slackLimit(scene, audit.segments[audit.closest].motion.closest) : "")}};
}

void printAudit(const PathAudit& audit, const Scene& scene) {
    const std::size_t count = audit.segments.size();
    if (audit.isValid()) {
        printRow("audit", "valid along the whole path, certified" + certificateScope(scene));
    } else {
        const SegmentAudit& first = audit.segments[audit.notValid[0]];
        printRow("audit",
                 "NOT valid: " + std::to_string(audit.notValid.size()) + " of " + counted(count, "segment"));
        printRow("first", "segment " + std::to_string(audit.notValid[0] + 1) + ", " + validUpTo(first) +
                              ", is " + first.motion.whyInvalid.words());
    }
    printRows(contactRows(audit));
    const SegmentAudit& closest = audit.segments[audit.closest];
    printRows(leastClearanceRow(audit, scene));
    printRows(deflectionRows());
    if (!closest.partMesh.empty()) printClosest(audit, scene);
}

void printSegments(const PathAudit& audit, const Scene& scene) {
    if (!usedUnit().empty()) std::cout << "Lengths in " << usedUnit() << ", rotations in degrees\n";
    printCells("segment", "verdict", "length", "rotation", clearanceWord(scene), "at t",
               "between (triangles, from 0)");
    for (std::size_t k = 0; k < audit.segments.size(); ++k) {
        const SegmentAudit& segment = audit.segments[k];
        const MotionReport& motion = segment.motion;
        const bool isLooked = !motion.whyInvalid.isUnusable() && !std::isinf(motion.upperClearance);
        const double clearance = segment.isValid() ? motion.lowerClearance : motion.upperClearance;
        const bool isTold = segment.isValid() || isLooked;
        const std::string between = isLooked ? pairOf(segment) : "";
        const std::string trouble = segment.isValid() ? "" : validUpTo(segment);
        printCells(std::to_string(k + 1), nameOf(motion.whyInvalid.kind), shortened(segment.length),
                   shortened(segment.rotation * 180 / M_PI), isTold ? shortened(clearance) : "-",
                   isTold ? shortened(motion.closestTime) : "-",
                   between + (between.empty() || trouble.empty() ? "" : "; ") + trouble);
    }
}

void printProfile(const PathAudit& audit, const Scene& scene) {
    if (audit.profile.empty() || !(audit.profile.back().travel > 0)) return;
    const std::vector<Column> columns = columnsOf(audit.profile);
    const std::vector<double> levels = levelsOf(columns);
    std::cout << clearanceWord(scene) << " along the path" << (usedUnit().empty() ? "" : ", " + usedUnit())
              << ": # certain, : found" << (audit.isValid() ? "" : ", x not valid, ? not certified") << "\n";
    for (int row = static_cast<int>(levels.size()) - 1; row >= 0; --row) {
        const double level = levels[static_cast<std::size_t>(row)] * (1 - 1e-12);
        std::string line = fmt::format("{:9.3g} |", level);
        for (const Column& column : columns) {
            line += column.certain >= level ? '#' : column.found >= level ? ':' : ' ';
        }
        std::cout << line.substr(0, line.find_last_not_of(' ') + 1) << "\n";
    }
    std::string foot = "          +";
    for (const Column& column : columns) foot += footOf(column);
    const std::string end = inUnit("travelled " + readable(audit.profile.back().travel));
    std::cout << foot << "\n"
              << std::string(11, ' ') << "0" << std::string(kColumns - 1 - end.size(), ' ') << end << "\n";
}

void writeProfile(const PathAudit& audit, const Scene& scene, const std::vector<PartState>& path,
                  const std::string& file) {
    const SceneClearance clearance(scene);
    const PathLine line(path, scene.part.radiusAboutOrigin());
    writeOut(file, [&](std::ostream& stream) {
        stream << fmt::format(
            "segment,t,travel,{0},{0}_to_next,x,y,z,qx,qy,qz,qw,part_mesh,part_triangle,part_x,part_y,part_z,"
            "environment_mesh,environment_triangle,environment_x,environment_y,environment_z\n",
            clearanceWord(scene));
        for (const PathProfilePoint& point : audit.profile) {
            const PartState state = line.at(report::shareIn(line, point.segment, point.time));
            stream << point.segment + 1 << "," << formatNumber(point.time) << ","
                   << formatNumber(point.travel) << "," << formatNumber(point.clearance) << ","
                   << formatNumber(point.lowerToNext) << "," << numberCells(state) << ","
                   << pairCells(clearance, poseOf(state)) << "\n";
        }
    });
}

}  // namespace clearway::cli
