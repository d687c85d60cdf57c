#include "program/cli/path_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "clearway/animation.h"
#include "clearway/swept_volume.h"
#include "problem/rotation.h"
#include "program/cli/print_audit.h"
#include "program/options/facts.h"
#include "program/report/report.h"

namespace clearway::cli {

namespace {

constexpr double kUsualTolerance = 0.01;      ///< of the part's diagonal
constexpr double kErrorPerTolerance = 0.125;  ///< that sweptVolume allows
constexpr double kLeftOut = 2e-4;             ///< radians: OMPL may leave out turns below this
constexpr double kFloatRounding = 1e-6;       ///< of the largest coordinate, in the file

report::ReportTable tableOf(const std::string& title, const Rows& rows) {
    report::ReportTable table;
    table.title = title;
    for (const auto& [label, value] : rows) table.rows.push_back({label, value});
    return table;
}

std::string shortName(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

Rows problemRows(const Problem& problem, const Model& partModel, const Mesh& part, const Mesh& environment) {
    std::string worlds;
    for (const std::string& file : worldFiles(problem)) worlds += shortName(file) + ", ";
    Rows rows = {{"problem", shortName(problem.file)},
                 {"part", movingNames(problem, partModel) + shortName(problem.meshes.robot) + ", " +
                              counted(part.triangles.size(), "triangle")},
                 {"environment", worlds + counted(environment.triangles.size(), "triangle")},
                 {"margin", statedLength(problem.margin)}};
    for (const Mesh* mesh : {&part, &environment}) {
        for (const std::string& warning : mesh->origin.warnings) rows.push_back({"warning", warning});
    }
    return rows;
}

Rows pathRows(const std::vector<PartState>& path, const planning::PathAudit& audit, const Scene& scene) {
    const planning::SegmentAudit& closest = audit.segments[audit.closest];
    Rows rows = {{"states", std::to_string(path.size())},
                 {"length", shownLength(audit.length)},
                 {"rotation", readable(audit.rotation * 180 / M_PI) + " degrees"}};
    for (const Rows& more : {leastClearanceRow(audit, scene), deflectionRows(), contactRows(audit)})
        rows.insert(rows.end(), more.begin(), more.end());
    if (!closest.partMesh.empty()) {
        rows.push_back({"there", fmt::format("{} and {}, segment {}", closest.partMesh,
                                             closest.environmentMesh, audit.closest + 1)});
    }
    return rows;
}

report::ReportTable overlapTable(const std::vector<FoundOverlap>& overlaps) {
    report::ReportTable table;
    table.title = "Overlaps, where they are deepest";
    table.header = {"obstacle", "deep", "at"};
    for (const FoundOverlap& found : overlaps) {
        table.rows.push_back(
            {found.obstacle, inUnit(depthText(found.deepest.lower)), shownPlace(found.deepest.point)});
        table.shares.push_back(found.share);
    }
    return table;
}

std::string verdictOf(const planning::PathAudit& audit, const Scene& scene) {
    if (audit.isValid()) return "valid along the whole path, certified" + certificateScope(scene);
    return fmt::format("NOT valid: {} of {}", audit.notValid.size(),
                       counted(audit.segments.size(), "segment"));
}

std::string megabytes(std::size_t bytes) {
    return fmt::format("{:.1f} MB", double(bytes) * 1e-6);
}

void writePage(const Problem& problem, const Mesh& part, const Mesh& environment, const Scene& scene,
               const std::vector<PartState>& path, const planning::PathAudit& audit, const Rows& planner,
               const std::vector<FoundOverlap>& overlaps, const PathOutputs& outputs) {
    report::ReportInput input{
        problem.name.empty() ? shortName(problem.file) : problem.name,
        (outputs.isOfMiss ? "no path was found; the nearest miss is " : "") + verdictOf(audit, scene),
        part,
        environment,
        scene,
        path,
        audit,
        {}};
    input.unit = problem.unit;
    input.tables.push_back(tableOf("Problem", problemRows(problem, scene.part, part, environment)));
    if (!planner.empty()) input.tables.push_back(tableOf("Planner", planner));
    input.tables.push_back(tableOf("Path", pathRows(path, audit, scene)));
    if (!overlaps.empty()) input.tables.push_back(overlapTable(overlaps));
    input.tables.push_back(report::segmentTable(audit, path, scene));
    const report::WrittenReport written = writeReport(input, outputs.report);
    printRow("report", outputs.report + ", " + megabytes(written.bytes) +
                           (outputs.isOfMiss ? ", of the nearest miss" : ""));
}

/// The motions between the states of a path. OMPL interpolates positions evenly, and turns by the shorter way.
std::vector<RigidMotion> motionsOf(const std::vector<PartState>& path) {
    std::vector<RigidMotion> motions;
    for (std::size_t i = 0; i + 1 < path.size() || i == 0; ++i) {
        const PartState &from = path[i], &to = path[std::min(i + 1, path.size() - 1)];
        AxisAngle turn = toAxisAngle(from.rotation.conjugate() * to.rotation);
        if (turn.angle > M_PI) turn.angle -= 2 * M_PI;
        motions.push_back({poseOf(from), to.position - from.position, turn.angle * turn.axis});
    }
    return motions;
}

/// The tolerance of --swept: the stated one, or 1 % of the part's diagonal.
double toleranceOf(const PathOutputs& outputs, const Model& part) {
    return outputs.sweptTolerance.value_or(kUsualTolerance * part.box().diagonal().norm());
}

/// How far places of the part may be off a path's motions: by small turns, which OMPL may leave out, and by the floats of
/// the file. radius: the part's about its origin.
double sweptPlaceError(const std::vector<PartState>& path, double radius) {
    double turn = 0, farthest = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const PartState &from = path[i], &to = path[std::min(i + 1, path.size() - 1)];
        const double angle = from.rotation.angularDistance(to.rotation);
        if (angle < kLeftOut) turn = std::max(turn, angle);
        farthest = std::max(farthest, from.position.norm() + (to.position - from.position).norm());
    }
    return radius * turn + kFloatRounding * (radius + farthest);
}

bool isGlb(const std::string& file) {
    return boost::iequals(std::filesystem::path(file).extension().string(), ".glb");
}

/// Returns false when interrupted.
bool writeSwept(const Problem& problem, const Mesh& part, const Model& model,
                const std::vector<PartState>& path, double tolerance, const std::string& file) {
    const std::vector<RigidMotion> motions = motionsOf(path);
    SweptVolumeOptions options;
    options.tolerance = tolerance;
    options.poseError = sweptPlaceError(path, model.radiusAboutOrigin());
    options.isStopped = isInterrupted;
    heedInterrupts();
    const ElapsedLine elapsed("sweeping");
    const Mesh swept = sweptVolume(part, motions, options);
    if (swept.triangles.empty()) {
        printRow("swept", "none, interrupted; a larger --swept-tolerance takes less time");
        facts()["interrupted"] = true;
        return false;
    }
    const std::optional<double> metres = metresPerUnit(problem);
    if (isGlb(file)) {
        saveAnimation(swept, {}, metres.value_or(1), file);
    } else {
        saveMesh(swept, file);
    }
    const std::string unit = !metres ? "" : isGlb(file) ? ", in metres" : ", in " + problem.unit;
    printRow("swept",
             fmt::format("{}{}, {}, within {} of the part's places", file, unit,
                         counted(swept.triangles.size(), "triangle"), shownLength(options.tolerance)));
    return true;
}

}  // namespace

void PathOutputs::require(OutputFiles& files) const {
    files.add("--report", report, {".html", ".htm"});
    files.add("--export", motion, {".glb"});
    files.add("--swept", swept, {".stl", ".obj", ".ply", ".glb", ".3mf"});
    if (swept.empty() && sweptTolerance)
        throw std::invalid_argument("--swept-tolerance is given without --swept, expected both");
}

bool PathOutputs::write(const Problem& problem, const SceneMeshes& meshes, const Scene& scene,
                        const std::vector<PartState>& path, const planning::PathAudit& audit,
                        const Rows& planner, const std::vector<FoundOverlap>& overlaps) const {
    if (isEmpty()) return true;
    const Mesh& part = meshes.part;
    const Mesh environment = shownEnvironment(problem, meshes.worlds);
    if (!report.empty()) writePage(problem, part, environment, scene, path, audit, planner, overlaps, *this);
    if (!motion.empty()) {
        const std::optional<double> metres = metresPerUnit(problem);
        saveAnimation(environment, {{part, path}}, metres.value_or(1), motion);
        printRow("export", motion + (metres ? ", in metres" : ", lengths as they are: no unit is stated"));
    }
    return swept.empty() ||
           writeSwept(problem, part, scene.part, path, toleranceOf(*this, scene.part), swept);
}

void PathOutputs::tellUnwritten(const std::string& why) const {
    if (!report.empty()) printRow("report", "not written: " + why);
    if (!motion.empty()) printRow("export", "not written: " + why);
    if (!swept.empty()) printRow("swept", "not written: " + why);
}

std::string whySweptIsTooFine(const PathOutputs& outputs, const Scene& scene,
                              const std::vector<PartState>& path) {
    if (outputs.swept.empty()) return "";
    const double tolerance = toleranceOf(outputs, scene.part);
    const double error = sweptPlaceError(path, scene.part.radiusAboutOrigin());
    if (error < kErrorPerTolerance * tolerance) return "";
    return "--swept-tolerance is " + shownLength(tolerance) +
           (outputs.sweptTolerance ? "" : ", 1 % of the part's diagonal") +
           ", too fine for how exactly the part's places are known, expected at least " +
           inUnit(shortenedUp(error / kErrorPerTolerance * (1 + 1e-6)));
}

void addPathOutputs(CommandLine& commandLine, PathOutputs& outputs) {
    commandLine.option(
        "--report FILE",
        "writes a page to look at the path in a browser: 3D view, clearance profile, tables; where plan "
        "finds no path, at the nearest miss",
        to(outputs.report));
    commandLine.option("--export FILE", "writes the motion as an animated .glb file, for Blender and others",
                       to(outputs.motion));
    commandLine.option(
        "--swept FILE",
        "writes the volume that the part sweeps along the path, as a closed mesh: .stl, .obj, .ply or .glb",
        to(outputs.swept));
    commandLine.option(
        "--swept-tolerance D",
        "how far the mesh of --swept may be from the part's places (1 % of the part's diagonal)",
        positive(outputs.sweptTolerance));
}

Mesh shownEnvironment(const Problem& problem, const std::vector<Mesh>& worlds) {
    Problem allAlike = problem;
    allAlike.margin = 0;
    allAlike.rules = ObstacleRules();
    allAlike.rules.ignored = problem.rules.ignored;
    const ObstacleGroups obstacles = obstaclesOf(allAlike, worlds);
    return obstacles.groups.empty() ? joinedEnvironment(worlds) : obstacles.groups[0].mesh;
}

}  // namespace clearway::cli
