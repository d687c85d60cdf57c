#include "report/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string_view>

#include "core/colour.h"
#include "core/json_text.h"
#include "core/replace_file.h"
#include "report/coding.h"
#include "report/frames.h"
#include "report/page_mesh.h"
#include "report/page_texts.h"

namespace clearway {

namespace {

/// The part is drawn anew wherever the slider goes: measured in headless Chromium without a graphics card,
/// that stays well below 0.2 s. The environment is drawn when the camera moves; what counts is the size of
/// the page.
constexpr std::size_t kMostPartTriangles = 100000, kMostEnvironmentTriangles = 600000;
constexpr std::size_t kFrames = 401, kStretches = 600, kColours = 33, kMostTroubles = 200;

using Places = std::vector<std::pair<std::string, std::string>>;

std::string field(const std::string& name, const std::string& json) {
    return jsonText(name) + ":" + json;
}

std::string object(const std::vector<std::string>& fields) {
    std::string list = jsonList(fields);
    list.front() = '{';
    list.back() = '}';
    return list;
}

std::string jsonMesh(const PageMesh& mesh, const Vector3& origin) {
    return object(
        {field("low", jsonPoint(mesh.box.min() - origin)), field("extent", jsonPoint(mesh.box.diagonal())),
         field("positions", '"' + base64(mesh.positions.data(), 6 * mesh.positions.size()) + '"'),
         field("triangles", '"' + base64(mesh.triangles.data(), 12 * mesh.triangles.size()) + '"')});
}

/// position: of the middle of the part's box.
std::string jsonFrame(const ReportFrame& frame, const Vector3& partMiddle, const Vector3& origin) {
    const Eigen::Quaterniond q(frame.X_environmentPart.rotation);
    std::vector<std::string> fields = {
        field("share", jsonNumber(frame.share)),
        field("position", jsonPoint(frame.X_environmentPart * partMiddle - origin)),
        field("rotation",
              jsonList({jsonNumber(q.x()), jsonNumber(q.y()), jsonNumber(q.z()), jsonNumber(q.w())})),
        field("clearance", frame.isInReach ? jsonNumber(frame.clearance.lower) : "null")};
    if (frame.isInReach && std::isinf(frame.clearance.lower)) fields.push_back(field("isFree", "true"));
    if (!frame.partMesh.empty()) {
        const SceneDistance& nearest = frame.clearance.nearest;
        fields.push_back(field("distance", jsonNumber(nearest.distance)));
        fields.push_back(field("pair", jsonList({jsonPoint(nearest.pointOnPart - origin),
                                                 jsonPoint(nearest.pointOnEnvironment - origin)})));
        fields.push_back(
            field("between", jsonList({jsonText(frame.partMesh), jsonText(frame.environmentMesh)})));
    }
    return object(fields);
}

std::size_t nearestFrame(const std::vector<ReportFrame>& frames, double share) {
    const auto isCloser = [&](const ReportFrame& a, const ReportFrame& b) {
        return std::abs(a.share - share) < std::abs(b.share - share);
    };
    return static_cast<std::size_t>(std::min_element(frames.begin(), frames.end(), isCloser) -
                                    frames.begin());
}

std::string jsonTable(const ReportTable& table, const std::vector<ReportFrame>& frames) {
    const auto texts = [](const std::vector<std::string>& cells) {
        std::vector<std::string> items;
        for (const std::string& cell : cells) items.push_back(jsonText(cell));
        return jsonList(items);
    };
    std::vector<std::string> rows, jumps;
    for (const auto& row : table.rows) rows.push_back(texts(row));
    for (const double share : table.shares) jumps.push_back(std::to_string(nearestFrame(frames, share)));
    return object({field("title", jsonText(table.title)), field("header", texts(table.header)),
                   field("rows", jsonList(rows)), field("frames", jumps.empty() ? "null" : jsonList(jumps))});
}

std::string jsonColours() {
    std::vector<std::string> colours;
    for (std::size_t i = 0; i < kColours; ++i) {
        const auto rgb = toSRgb(clearanceColour(double(i) / double(kColours - 1)));
        colours.push_back(jsonList({std::to_string(rgb[0]), std::to_string(rgb[1]), std::to_string(rgb[2])}));
    }
    return jsonList(colours);
}

std::string shortly(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string noteOn(const char* what, const PageMesh& page, std::size_t all) {
    const std::size_t shown = page.triangles.size();
    return std::string("The ") + what + " is drawn with " +
           (shown >= all ? "all of its " : std::to_string(shown) + " triangles in place of its ") +
           std::to_string(all) + (shown >= all ? " triangles" : "") + ", no vertex more than " +
           shortly(page.error) + " from its place. ";
}

/// All that the page shows.
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

    std::string json() const {
        std::vector<std::string> frames, tables, certified;
        for (const ReportFrame& frame : frames_)
            frames.push_back(jsonFrame(frame, part_.box.center(), origin_));
        for (const ReportTable& table : input_.tables) tables.push_back(jsonTable(table, frames_));
        for (const double clearance : certifiedStretches(line_, input_.audit, kStretches))
            certified.push_back(jsonNumber(clearance));
        const std::string scaleMost = jsonNumber(scaleFor(least_, most_));
        return object({field("verdict", jsonText(input_.verdict)), field("note", jsonText(note())),
                       field("radius", jsonNumber(environment_.box.diagonal().norm() / 2)),
                       field("middle", "[0,0,0]"), field("scale", jsonColours()),
                       field("scaleMost", scaleMost), field("profileMost", scaleMost),
                       field("tightest", std::to_string(tightest())), field("certified", jsonList(certified)),
                       field("tables", jsonList(tables)), field("frames", jsonList(frames)),
                       field("part", jsonMesh(part_, part_.box.center())),
                       field("environment", jsonMesh(environment_, origin_))});
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
               "Clearances are those of the whole meshes: distance less margin, lower bounds. The line "
               "through the view "
               "is the way of the middle of the part's box. Drawn with three.js (MIT licence), which this "
               "page holds.";
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

/// The template with its {{places}} filled.
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

}  // namespace

WrittenReport writeReport(const ReportInput& input, const std::string& file) {
    const PageData data(input);
    const std::string page = filled(kPageHtml, {{"title", htmlText(input.title)},
                                                {"three", moduleAddress(kThreeModule)},
                                                {"controls", moduleAddress(kOrbitControls)},
                                                {"data", data.json()},
                                                {"viewer", kPageViewer}});
    replaceFile(file, [&](std::ostream& stream) { stream << page; });
    return {page.size(), data.partTriangles(), data.environmentTriangles()};
}

}  // namespace clearway
