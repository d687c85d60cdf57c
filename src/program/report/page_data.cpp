#include "program/report/page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "mesh/components.h"
#include "problem/clearance_word.h"
#include "program/render/colour.h"
#include "program/report/coding.h"
#include "program/report/first_view.h"
#include "program/report/frames.h"
#include "program/report/obstacle_clearances.h"
#include "program/report/page_mesh.h"

namespace clearway::report {

namespace {

/// The part is redrawn at every place of the slider. With this many triangles a redraw takes well below 0.2 s
/// in headless Chromium without a graphics card. The environment is redrawn only when the camera moves, so
/// its limit follows from the size of the page.
constexpr PageMeshLimits kPartLimits{100000, 30000}, kEnvironmentLimits{600000, 150000};
constexpr std::size_t kFrames = 401, kStretches = 600, kColours = 33, kMostTroubles = 200;

/// Obstacles whose clearance is measured. The page lists these and counts the others.
constexpr std::size_t kMostMeasured = 80;

/// The points that the first view is to show: vertices of the part at places along the path.
constexpr std::size_t kViewPlaces = 24, kViewVertices = 12;
/// Distance of the camera in radii of what it is to show; about that of the page, which has an angle of 30 degrees.
constexpr double kCameraDistance = 4;

FloatJson pointOf(const Vector3& point) {
    return {point.x(), point.y(), point.z()};
}

/// Numbers as a text from which the same doubles can be read.
template <class Vector>
std::string exactText(const Vector& values) {
    std::string text;
    for (const double value : values) {
        text += fmt::format("{}{:.17g}", text.empty() ? "" : " ", value);
    }
    return text;
}

FloatJson jsonOf(const PageMesh& mesh, const Vector3& origin, FloatJson objects) {
    return {{"low", pointOf(mesh.box.min() - origin)},
            {"extent", pointOf(mesh.box.diagonal())},
            {"positions", base64(mesh.positions.data(), 6 * mesh.positions.size())},
            {"triangles", base64(mesh.triangles.data(), 12 * mesh.triangles.size())},
            {"edges", base64(mesh.edges.data(), 8 * mesh.edges.size())},
            {"objects", std::move(objects)}};
}

/// One entry for each component, which owns a run of the page's triangles and one of its edges.
FloatJson objectsOf(const Mesh& mesh, const PageMesh& page, const std::string& nameless) {
    FloatJson objects = FloatJson::array();
    const std::vector<Component> components = componentsOf(mesh);
    for (std::size_t i = 0; i < components.size(); ++i) {
        objects.push_back({{"name", components[i].name.empty() ? nameless : components[i].name},
                           {"triangles", page.triangleCounts[i]},
                           {"edges", page.edgeCounts[i]}});
    }
    return objects;
}

void addClearance(const ObstacleClearance& clearance, FloatJson& object) {
    if (!clearance.isInScene) {
        object["isIgnored"] = true;
        return;
    }
    if (!std::isfinite(clearance.lower)) return;
    object[clearance.isMeasured ? "clearance" : "atLeast"] = clearance.lower;
    if (clearance.isMeasured) object["frame"] = clearance.frame;
    if (clearance.trouble != WhyInvalid::Kind::kValid) object["trouble"] = nameOf(clearance.trouble);
    if (clearance.isLeftOutAtStart || clearance.isLeftOutAtGoal)
        object["leftOut"] = !clearance.isLeftOutAtGoal    ? "start"
                            : !clearance.isLeftOutAtStart ? "goal"
                                                          : "start and goal";
}

std::size_t nearestFrame(const std::vector<ReportFrame>& frames, double share) {
    const auto isCloser = [&](const ReportFrame& a, const ReportFrame& b) {
        return std::abs(a.share - share) < std::abs(b.share - share);
    };
    return static_cast<std::size_t>(std::min_element(frames.begin(), frames.end(), isCloser) -
                                    frames.begin());
}

FloatJson jsonOf(const ReportTable& table, const std::vector<ReportFrame>& frames) {
    FloatJson jumps;
    for (const double share : table.shares) jumps.push_back(nearestFrame(frames, share));
    return {{"title", table.title}, {"header", table.header}, {"rows", table.rows}, {"frames", jumps}};
}

FloatJson colourScale() {
    FloatJson colours;
    for (std::size_t i = 0; i < kColours; ++i)
        colours.push_back(render::toSRgb(render::clearanceColour(double(i) / double(kColours - 1))));
    return colours;
}

std::string noteOn(const char* what, const PageMesh& page, std::size_t all, const std::string& unit) {
    const std::size_t shown = page.triangles.size();
    const std::string few =
        page.edges.size() < page.allEdges
            ? fmt::format(", and the longest {} of its {} sharp edges", page.edges.size(), page.allEdges)
            : "";
    return fmt::format("The {} is drawn with {} of its {}{}, each vertex within {:.3g}{} of its place{}. ",
                       what, shown >= all ? "all" : std::to_string(shown), all,
                       shown >= all ? " triangles" : "", page.error, unit, few);
}

render::Surface surfaceOf(const PageMesh& mesh, const Vector3& origin) {
    render::Surface surface;
    for (const auto& stored : mesh.positions)
        surface.vertices.push_back((mesh.placeOf(stored) - origin).cast<float>());
    surface.triangles = mesh.triangles;
    return surface;
}

class PageMaker {
  public:
    explicit PageMaker(const ReportInput& input)
        : input_(input),
          part_(pageMeshOf(input.part, kPartLimits)),
          environment_(pageMeshOf(input.environment, kEnvironmentLimits)),
          origin_(environment_.box.center()),
          line_(input.path, input.scene.part.radiusAboutOrigin()),
          frames_(framesAlong(line_, SceneClearance(input.scene), kFrames,
                              tightPlaces(line_, input.audit, kMostTroubles))) {
        for (const ReportFrame& frame : frames_) {
            const bool isContact = !frame.whyInvalid.isValid();
            hasContact_ = hasContact_ || isContact;
            if (!frame.isInRange || isContact || !std::isfinite(frame.clearance.lower)) continue;
            least_ = std::min(least_, frame.clearance.lower);
            most_ = std::max(most_, frame.clearance.lower);
        }
    }

    PageData data() const {
        FloatJson frames = FloatJson::array(), tables = FloatJson::array();
        for (const ReportFrame& frame : frames_) frames.push_back(frameJson(frame));
        for (const ReportTable& table : input_.tables) tables.push_back(jsonOf(table, frames_));
        FloatJson json = {{"title", input_.title},
                          {"verdict", input_.verdict},
                          {"unit", input_.unit},
                          {"note", note()},
                          {"radius", environment_.box.diagonal().norm() / 2},
                          {"scale", colourScale()},
                          {"contact", render::toSRgb(render::contactColour())},
                          {"scaleMost", render::scaleFor(least_, most_, hasContact_)},
                          {"most", most_},
                          {"measure", clearanceWord(input_.scene)},
                          {"margin", input_.scene.largestMargin()},
                          {"tightest", tightest()},
                          {"certified", certifiedStretches(line_, input_.audit, kStretches)},
                          {"tables", std::move(tables)},
                          {"frames", std::move(frames)}};
        addViews(json);
        json["part"] = jsonOf(part_, part_.box.center(), objectsOf(input_.part, part_, "part"));
        json["environment"] = jsonOf(environment_, origin_, obstacles());
        return {jsonText(std::move(json)), part_.triangles.size(), environment_.triangles.size()};
    }

  private:
    /// "position" is that of the middle of the part's box.
    FloatJson frameJson(const ReportFrame& frame) const {
        const Pose& X = frame.X_environmentPart;
        const Eigen::Quaterniond q(X.rotation);
        FloatJson json = {{"share", frame.share},
                          {"position", pointOf(X * part_.box.center() - origin_)},
                          {"rotation", {q.x(), q.y(), q.z(), q.w()}},
                          {"pose", exactText(X.translation) + " " + exactText(q.coeffs())},
                          {"clearance", frame.isInRange ? FloatJson(frame.clearance.lower) : FloatJson()}};
        if (frame.isInRange && std::isinf(frame.clearance.lower)) json["isFree"] = true;
        if (!frame.whyInvalid.isValid()) json["trouble"] = nameOf(frame.whyInvalid.kind);
        if (frame.partMesh.empty()) return json;
        const SceneDistance& nearest = frame.clearance.nearest;
        const Obstacle& obstacle = input_.scene.obstacles[*nearest.obstacle];
        if (obstacle.margin > 0) json["margin"] = obstacle.margin;
        if (obstacle.overlap() > 0) {
            json["overlap"] = obstacle.overlap();
            json["shrunk"] = obstacle.shrunk ? "part" : "obstacle";
        }
        json["distance"] = (nearest.witness->pointOnPart - nearest.witness->pointOnEnvironment).norm();
        json["pair"] = {pointOf(nearest.witness->pointOnPart - origin_),
                        pointOf(nearest.witness->pointOnEnvironment - origin_)};
        json["between"] = {frame.partMesh, frame.environmentMesh};
        json["triangles"] = {nearest.witness->partTriangle, nearest.witness->environmentTriangle};
        json["points"] = {exactText(nearest.witness->pointOnPart),
                          exactText(nearest.witness->pointOnEnvironment)};
        return json;
    }

    FloatJson obstacles() const {
        FloatJson objects = objectsOf(input_.environment, environment_, "environment");
        const auto clearances = obstacleClearances(input_.scene, input_.environment, frames_, kMostMeasured);
        for (std::size_t i = 0; i < clearances.size(); ++i) addClearance(clearances[i], objects[i]);
        return objects;
    }

    std::size_t tightest() const {
        const auto isTighter = [](const ReportFrame& a, const ReportFrame& b) {
            return a.isInRange && (!b.isInRange || a.clearance.lower < b.clearance.lower);
        };
        return static_cast<std::size_t>(std::min_element(frames_.begin(), frames_.end(), isTighter) -
                                        frames_.begin());
    }

    /// Some of the part's vertices at a pose.
    std::vector<Vector3> viewPoints(const Pose& X) const {
        const std::size_t step = std::max<std::size_t>(1, part_.positions.size() / kViewVertices);
        std::vector<Vector3> points;
        for (std::size_t i = 0; i < part_.positions.size(); i += step)
            points.push_back(X * part_.placeOf(part_.positions[i]));
        return points;
    }

    Eigen::Vector3f onPage(const Vector3& point) const { return (point - origin_).cast<float>(); }

    void addViews(FloatJson& json) const {
        render::RayScene rays;
        rays.addBody(rays.addShape(surfaceOf(environment_, origin_)), {});
        rays.finish();

        ViewRequest way;
        Box box;
        for (const double share : evenShares(kViewPlaces)) {
            const Pose X = poseOf(line_.at(share));
            for (const Vector3& point : viewPoints(X)) {
                box.extend(point);
                way.points.push_back(onPage(point));
            }
        }
        way.centre = onPage(box.center());
        way.distance = static_cast<float>(kCameraDistance * (box.diagonal().norm() / 2));
        way.along = (input_.path.back().position - input_.path.front().position).cast<float>();
        const ChosenView chosen = chooseView(rays, way);
        json["view"] = {{"direction", pointOf(chosen.direction.cast<double>())}, {"visible", chosen.visible}};

        const ReportFrame& tight = frames_[tightest()];
        if (tight.partMesh.empty()) return;
        ViewRequest tightPart = way;
        tightPart.points.clear();
        for (const Vector3& point : viewPoints(tight.X_environmentPart))
            tightPart.points.push_back(onPage(point));
        json["view"]["tightVisible"] = visibleShare(rays, tightPart, chosen.direction);
        addTightView(tight, rays, json["view"]);
    }

    /// Looks along the gap of the closest pair. Tells whether the environment or the part hides it all around.
    void addTightView(const ReportFrame& tight, render::RayScene& rays, FloatJson& view) const {
        const Pose& X = tight.X_environmentPart;
        const Vector3 partMiddle = part_.box.center();
        rays.addBody(rays.addShape(surfaceOf(part_, partMiddle)),
                     {X.rotation.cast<float>(), onPage(X * partMiddle)});
        rays.finish();
        const auto& pair = *tight.clearance.nearest.witness;
        const Eigen::Vector3f middle = onPage(0.5 * (pair.pointOnPart + pair.pointOnEnvironment));
        const auto far = static_cast<float>(kCameraDistance * environment_.box.diagonal().norm());
        const Vector3 gap = pair.pointOnEnvironment - pair.pointOnPart;
        const ChosenView chosen = chooseView(rays, {{middle}, middle, far, gap.cast<float>(), true});
        view["tightDirection"] = pointOf(chosen.direction.cast<double>());
        view["isTightHidden"] = chosen.visible == 0;
    }

    std::string note() const {
        const std::string unit = input_.unit.empty() ? "" : " " + input_.unit;
        return noteOn("environment", environment_, input_.environment.triangles.size(), unit) +
               noteOn("part", part_, input_.part.triangles.size(), unit) +
               (mayOverlap(input_.scene)
                    ? "Slack is how much farther the part may move. Toward obstacles that may overlap it, it "
                      "is "
                      "the distance between the original meshes when one of them is shrunk for that; "
                      "otherwise "
                      "distance - margin. All are lower bounds. "
                    : "Clearances are those of the original meshes: lower bounds of distance - margin. ") +
               "The line in the view is the path of the middle of the part's box. " +
               (input_.unit.empty() ? "Lengths are in the files' unit, which the problem does not name. "
                                    : "") +
               "Drawn with three.js (MIT licence), which this page contains.";
    }

    const ReportInput& input_;
    PageMesh part_, environment_;
    Vector3 origin_;
    PathLine line_;
    std::vector<ReportFrame> frames_;
    double least_ = std::numeric_limits<double>::infinity(),
           most_ = 0;  ///< of the clearances without contact
    bool hasContact_ = false;
};

}  // namespace

PageData pageDataOf(const ReportInput& input) {
    return PageMaker(input).data();
}

}  // namespace clearway::report
