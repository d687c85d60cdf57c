#include "program/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string_view>

#include "core/embed.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "problem/clearance_word.h"
#include "program/report/coding.h"
#include "program/report/frames.h"
#include "program/report/page_data.h"

// The page's files, whose names are global. page.html is a template with {{places}}. The scripts page/*.js are
// one module, in this order: the names of a file are known to the next ones. three.js and its controls are
// modules of their own.
CLEARWAY_EMBED(clearwayPage, CLEARWAY_REPORT "/page/page.html")
CLEARWAY_EMBED(clearwayPageStyle, CLEARWAY_REPORT "/page/page.css")
CLEARWAY_EMBED(clearwayPageShared, CLEARWAY_REPORT "/page/shared.js")
CLEARWAY_EMBED(clearwayPageMeshes, CLEARWAY_REPORT "/page/meshes.js")
CLEARWAY_EMBED(clearwayPageLayers, CLEARWAY_REPORT "/page/layers.js")
CLEARWAY_EMBED(clearwayPageEye, CLEARWAY_REPORT "/page/eye.js")
CLEARWAY_EMBED(clearwayPageView, CLEARWAY_REPORT "/page/view.js")
CLEARWAY_EMBED(clearwayPageProfile, CLEARWAY_REPORT "/page/profile.js")
CLEARWAY_EMBED(clearwayPagePanels, CLEARWAY_REPORT "/page/panels.js")
CLEARWAY_EMBED(clearwayPageMain, CLEARWAY_REPORT "/page/main.js")
CLEARWAY_EMBED(clearwayThreeModule, CLEARWAY_REPORT "/vendor/three/three.module.min.js")
CLEARWAY_EMBED(clearwayOrbitControls, CLEARWAY_REPORT "/vendor/three/OrbitControls.min.js")

namespace clearway::report {
namespace {

using Places = std::vector<std::pair<std::string, std::string>>;

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
    return std::isfinite(value) ? fmt::format("{:.4g}", towardsZero(value, 4)) : "-";
}

std::string verdictOf(const planning::SegmentAudit& segment) {
    const WhyInvalid& why = segment.motion.whyInvalid;
    return why.isUnusable() ? why.reason : nameOf(why.kind);
}

}  // namespace

WrittenReport writeReport(const ReportInput& input, const std::string& file) {
    const PageData data = pageDataOf(input);
    std::string viewer;
    for (const char* text : {clearwayPageShared, clearwayPageMeshes, clearwayPageLayers, clearwayPageEye,
                             clearwayPageView, clearwayPageProfile, clearwayPagePanels, clearwayPageMain})
        viewer += text;
    const std::string page = filled(clearwayPage, {{"title", htmlText(input.title)},
                                                   {"three", moduleAddress(clearwayThreeModule)},
                                                   {"controls", moduleAddress(clearwayOrbitControls)},
                                                   {"data", data.json},
                                                   {"style", clearwayPageStyle},
                                                   {"viewer", viewer}});
    replaceFile(file, [&](std::ostream& stream) { stream << page; });
    return {page.size(), data.partTriangles, data.environmentTriangles};
}

ReportTable segmentTable(const planning::PathAudit& audit, const std::vector<PartState>& path,
                         const Scene& scene) {
    ReportTable table;
    table.title = "Segments";
    const std::string in = scene.unit.empty() ? "" : " [" + scene.unit + "]";
    table.header = {"", "verdict", "length" + in, clearanceWord(scene) + in, "closest pair"};
    const PathLine line(path, scene.part.radiusAboutOrigin());
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
