#include "program/report/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "core/json.h"
#include "core/replace_file.h"
#include "program/render/colour.h"
#include "program/report/coding.h"
#include "program/report/frames.h"
#include "program/report/page_mesh.h"

namespace clearway::report {

// The page's files, which the build embeds in the program (cmake/embed.cmake).
extern const char kPageHtml[];       ///< page/page.html, a template with {{places}}
extern const char kPageViewer[];     ///< page/viewer.js, a module
extern const char kThreeModule[];    ///< three.js
extern const char kOrbitControls[];  ///< its controls, a separate module

namespace {

/// The part is redrawn at every place of the slider. With this many triangles a redraw takes well below 0.2 s
/// in headless Chromium without a graphics card. The environment is redrawn only when the camera moves, so
/// its limit follows from the size of the page.
constexpr std::size_t kMostPartTriangles = 100000, kMostEnvironmentTriangles = 600000;
constexpr std::size_t kFrames = 401, kStretches = 600, kColours = 33, kMostTroubles = 200;

using Places = std::vector<std::pair<std::string, std::string>>;

Json pointOf(const Vector3& point) {
    return {point.x(), point.y(), point.z()};
}

Json jsonOf(const PageMesh& mesh, const Vector3& origin) {
    return {{"low", pointOf(mesh.box.min() - origin)},
            {"extent", pointOf(mesh.box.diagonal())},
            {"positions", base64(mesh.positions.data(), 6 * mesh.positions.size())},
            {"triangles", base64(mesh.triangles.data(), 12 * mesh.triangles.size())}};
}

/// "position" is that of the middle of the part's box.
Json jsonOf(const ReportFrame& frame, const Vector3& partMiddle, const Vector3& origin) {
    const Eigen::Quaterniond q(frame.X_environmentPart.rotation);
    Json json = {{"share", frame.share},
                 {"position", pointOf(frame.X_environmentPart * partMiddle - origin)},
                 {"rotation", {q.x(), q.y(), q.z(), q.w()}},
                 {"clearance", frame.isInReach ? Json(frame.clearance.lower) : Json()}};
    if (frame.isInReach && std::isinf(frame.clearance.lower)) json["isFree"] = true;
    if (!frame.partMesh.empty()) {
        const SceneDistance& nearest = frame.clearance.nearest;
        json["distance"] = nearest.distance;
        json["pair"] = {pointOf(nearest.pointOnPart - origin), pointOf(nearest.pointOnEnvironment - origin)};
        json["between"] = {frame.partMesh, frame.environmentMesh};
    }
    return json;
}

std::size_t nearestFrame(const std::vector<ReportFrame>& frames, double share) {
    const auto isCloser = [&](const ReportFrame& a, const ReportFrame& b) {
        return std::abs(a.share - share) < std::abs(b.share - share);
    };
    return static_cast<std::size_t>(std::min_element(frames.begin(), frames.end(), isCloser) -
                                    frames.begin());
}

Json jsonOf(const ReportTable& table, const std::vector<ReportFrame>& frames) {
    Json jumps;
    for (const double share : table.shares) jumps.push_back(nearestFrame(frames, share));
    return {{"title", table.title}, {"header", table.header}, {"rows", table.rows}, {"frames", jumps}};
}

Json colourScale() {
    Json colours;
    for (std::size_t i = 0; i < kColours; ++i)
        colours.push_back(render::toSRgb(render::clearanceColour(double(i) / double(kColours - 1))));
    return colours;
}

std::string shortly(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string noteOn(const char* what, const PageMesh& page, std::size_t all) {
    const std::size_t shown = page.triangles.size();
    return std::string("The ") + what + " is drawn with " +
           (shown >= all ? "all of its " : std::to_string(shown) + " of its ") + std::to_string(all) +
           (shown >= all ? " triangles" : "") + ", each vertex within " + shortly(page.error) +
           " of its place. ";
}

/// The data that the page shows.
class PageData {
  public:
    explicit PageData(const ReportInput& input)
        : input_(input),
          part_(pageMeshOf(input.part, kMostPartTriangles)),
          environment_(pageMeshOf(input.environment, kMostEnvironmentTriangles)),
          origin_(environment_.box.center()),
          line_(input.path, input.scene.part.radiusAboutOrigin()),
          frames_(framesAlong(line_, planning::SceneClearance(input.scene), kFrames,
                              tightPlaces(line_, input.audit, kMostTroubles))) {
        for (const ReportFrame& frame : frames_) {
            if (!frame.isInReach || !std::isfinite(frame.clearance.lower)) continue;
            least_ = std::min(least_, frame.clearance.lower);
            most_ = std::max(most_, frame.clearance.lower);
        }
    }

    Json json() const {
        Json frames = Json::array(), tables = Json::array();
        for (const ReportFrame& frame : frames_) frames.push_back(jsonOf(frame, part_.box.center(), origin_));
        for (const ReportTable& table : input_.tables) tables.push_back(jsonOf(table, frames_));
        const double scaleMost = render::scaleFor(least_, most_);
        return {{"verdict", input_.verdict},
                {"note", note()},
                {"radius", environment_.box.diagonal().norm() / 2},
                {"middle", {0, 0, 0}},
                {"scale", colourScale()},
                {"scaleMost", scaleMost},
                {"profileMost", scaleMost},
                {"tightest", tightest()},
                {"certified", certifiedStretches(line_, input_.audit, kStretches)},
                {"tables", std::move(tables)},
                {"frames", std::move(frames)},
                {"part", jsonOf(part_, part_.box.center())},
                {"environment", jsonOf(environment_, origin_)}};
    }

    std::size_t partTriangles() const { return part_.triangles.size(); }
    std::size_t environmentTriangles() const { return environment_.triangles.size(); }

  private:
    std::size_t tightest() const {
        const auto isTighter = [](const ReportFrame& a, const ReportFrame& b) {
            return a.isInReach && (!b.isInReach || a.clearance.lower < b.clearance.lower);
        };
        return static_cast<std::size_t>(std::min_element(frames_.begin(), frames_.end(), isTighter) -
                                        frames_.begin());
    }

    std::string note() const {
        return noteOn("environment", environment_, input_.environment.triangles.size()) +
               noteOn("part", part_, input_.part.triangles.size()) +
               "Clearances are those of the original meshes: lower bounds of distance - margin. The line in "
               "the view is the path of the middle of the part's box. Drawn with three.js (MIT licence), "
               "which this page contains.";
    }

    const ReportInput& input_;
    PageMesh part_, environment_;
    Vector3 origin_;
    PathLine line_;
    std::vector<ReportFrame> frames_;
    double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
};

std::string moduleAddress(const char* text) {
    const std::string_view view(text);
    return "data:text/javascript;base64," + base64(view.data(), view.size());
}

/// Fills the {{places}} of a template.
std::string filled(std::string_view page, const Places& places) {
    std::string result;
    for (std::size_t at = page.find("{{"); at != std::string_view::npos; at = page.find("{{")) {
        result += page.substr(0, at);
        const std::size_t end = page.find("}}", at);
        const std::string_view name = page.substr(at + 2, end - at - 2);
        const auto place =
            std::find_if(places.begin(), places.end(), [&](const auto& p) { return p.first == name; });
        result += place->second;
        page.remove_prefix(end + 2);
    }
    return result += page;
}

/// Rounds towards zero, so that a certified clearance is never rounded up.
std::string shortened(double value) {
    if (!std::isfinite(value)) return "-";
    if (value == 0) return "0";
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::trunc(value / unit) * unit);
    return text;
}

std::string verdictOf(const planning::SegmentAudit& segment) {
    if (segment.isValid()) return "valid";
    if (!segment.motion.problem.empty()) return segment.motion.problem;
    if (segment.motion.verdict == planning::MotionVerdict::kUndecided) return "undecided";
    return segment.motion.leavesBounds ? "out of bounds" : "collides";
}

}  // namespace

WrittenReport writeReport(const ReportInput& input, const std::string& file) {
    const PageData data(input);
    const std::string page = filled(kPageHtml, {{"title", htmlText(input.title)},
                                                {"three", moduleAddress(kThreeModule)},
                                                {"controls", moduleAddress(kOrbitControls)},
                                                {"data", jsonText(data.json())},
                                                {"viewer", kPageViewer}});
    replaceFile(file, [&](std::ostream& stream) { stream << page; });
    return {page.size(), data.partTriangles(), data.environmentTriangles()};
}

ReportTable segmentTable(const planning::PathAudit& audit, const std::vector<PartState>& path,
                         double turnRadius) {
    ReportTable table;
    table.title = "Segments";
    table.header = {"", "verdict", "length", "clearance", "closest pair"};
    const PathLine line(path, turnRadius);
    for (std::size_t i = 0; i < audit.segments.size(); ++i) {
        const planning::SegmentAudit& segment = audit.segments[i];
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
