#include "program/render/render.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "program/render/exposure.h"
#include "program/render/legend.h"
#include "program/render/marks.h"
#include "program/render/samples.h"

namespace clearway::render {

namespace {

constexpr double kWayRadius = 0.0035;  ///< radius of the line along the path, share of the picture's height

/// Maps environment coordinates to those of the stage, in which the environment has a diagonal of 1.
struct Frame {
    Vector3 centre;
    double scale;

    explicit Frame(const Box& box)
        : centre(box.center()), scale(1 / std::max(box.diagonal().norm(), 1e-300)) {}
    Vector3 operator()(const Vector3& point) const { return scale * (point - centre); }
    Placement operator()(const Pose& pose, const Vector3& partCentre) const {
        return {pose.rotation.cast<float>(), (*this)(pose * partCentre).cast<float>()};
    }
    CutPlane operator()(const CutPlane& plane) const {
        return {plane.normal, scale * (plane.offset - plane.normal.dot(centre))};
    }
};

/// Slightly different greys: they tell neighbouring components apart and carry no meaning.
std::vector<Colour> environmentColours(const Mesh& environment) {
    std::vector<Colour> colours;
    for (std::uint32_t i = 0; i < std::max<std::size_t>(1, environment.components.size()); ++i) {
        const float lightness = 0.50f + 0.16f * unitFloat(mixed(2 * i + 1));
        const float warmth = 0.07f * (unitFloat(mixed(2 * i + 2)) - 0.5f);
        colours.push_back(lightness * Colour(1 + warmth, 1.0f, 1.03f - warmth));
    }
    return colours;
}

double scaleOf(const std::vector<PosedPart>& poses, const std::vector<PosedPart>& way) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const auto* list : {&poses, &way}) {
        for (const PosedPart& pose : *list) {
            if (!std::isfinite(pose.clearance)) continue;
            least = std::min(least, pose.clearance);
            most = std::max(most, pose.clearance);
        }
    }
    return scaleFor(least, most);
}

/// Looks across the longer horizontal extent of the poses, a little from above and from the side.
Vector3 insideDirection(const std::vector<PosedPart>& poses) {
    Box positions;
    for (const PosedPart& pose : poses) positions.extend(pose.state.position);
    const Vector3 extent = positions.diagonal();
    return extent.y() > extent.x() ? Vector3(1, -0.3, 0.28) : Vector3(-0.3, -1, 0.28);
}

/// An upright plane through the middle of the part at its tightest pose. Its normal is the horizontal axis
/// closest to the direction.
CutPlane insideCut(const Vector3& from, const Box& partBox, const std::vector<PosedPart>& poses) {
    const bool isAlongX = std::abs(from.x()) > std::abs(from.y());
    const auto tightest =
        std::min_element(poses.begin(), poses.end(),
                         [](const PosedPart& a, const PosedPart& b) { return a.clearance < b.clearance; });
    const Vector3 normal = isAlongX ? Vector3::UnitX() : Vector3::UnitY();
    return {normal, normal.dot(poseOf(tightest->state) * partBox.center())};
}

std::vector<Vector3f> cornersOf(const Surface& surface, const Placement& placement) {
    std::vector<Vector3f> points;
    points.reserve(surface.vertices.size());
    for (const Vector3f& vertex : surface.vertices)
        points.push_back(placement.rotation * vertex + placement.translation);
    return points;
}

void requireOptions(const std::vector<PosedPart>& poses, const RenderOptions& options) {
    const auto refuse = [](const std::string& what, double value, const std::string& expected) {
        throw std::invalid_argument(what + " is " + std::to_string(value) + ", expected " + expected);
    };
    if (poses.empty()) throw std::invalid_argument("there is no pose to show, expected at least 1");
    if (options.width < 16) refuse("width", options.width, "at least 16 pixels");
    if (options.height < 16) refuse("height", options.height, "at least 16 pixels");
    if (options.samples < 1) refuse("samples", options.samples, "at least 1");
    if (!(options.angle > 0 && options.angle < 170)) refuse("angle", options.angle, "0 to 170 degrees");
    if (options.cut && std::abs(options.cut->normal.norm() - 1) > 1e-6)
        refuse("length of the cut's normal", options.cut->normal.norm(), "1");
    if (options.scaleMost && !(*options.scaleMost > 0))
        refuse("scale", *options.scaleMost, "a clearance above 0");
}

/// Sets up stage and camera from the options. All coordinates are those of the stage.
class Arrangement {
  public:
    Arrangement(const Mesh& part, const Mesh& environment, const std::vector<PosedPart>& poses,
                const std::vector<PosedPart>& way, const RenderOptions& options)
        : options_(options),
          poses_(poses),
          partBox_(boundingBox(part)),
          frame_(boundingBox(environment)),
          most_(options.scaleMost.value_or(scaleOf(poses, way))),
          partSurface_(surfaceOf(part, partBox_.center(), frame_.scale)),
          wall_(surfaceOf(environment, frame_.centre, frame_.scale)) {
        chooseDirection();
        cutEnvironment();
        chooseCamera();
        addWay(way);
        addBodies(environment);
    }

    Image picture() {
        Exposure exposure;
        exposure.width = options_.width;
        exposure.height = options_.height;
        exposure.samples = options_.samples;
        exposure.lineWidth = std::max(1.0f, 1.4f * static_cast<float>(options_.height) / 720);
        Image image = expose(stages_, camera_, exposure);
        std::vector<Vector3f> marks;
        for (const Vector3& mark : options_.marks) marks.push_back(frame_(mark).cast<float>());
        if (!marks.empty()) drawMarks(marks, camera_, image);
        std::vector<double> clearances;
        for (const PosedPart& pose : poses_) clearances.push_back(pose.clearance);
        drawLegend(most_, clearances, image);
        return image;
    }

  private:
    Placement placementOf(const PosedPart& pose) const {
        return frame_(poseOf(pose.state), partBox_.center());
    }

    void chooseDirection() {
        isInside_ = options_.view == "inside" && !options_.eye;
        isClose_ = options_.isClose || isInside_;
        direction_ =
            isInside_ ? insideDirection(poses_) : viewNamed(options_.eye ? "iso" : options_.view).from;
        if (options_.eye) direction_ = *options_.eye - options_.lookAt.value_or(frame_.centre);
    }

    void cutEnvironment() {
        std::optional<CutPlane> cut = options_.cut;
        if (!cut && isInside_) cut = insideCut(direction_, partBox_, poses_);
        if (!cut) return;
        const double side =
            options_.eye ? cut->normal.dot(*options_.eye) - cut->offset : cut->normal.dot(direction_);
        if (side < 0) cut = CutPlane{-cut->normal, -cut->offset};
        wall_ = cutBy(frame_(*cut), wall_);
    }

    void chooseCamera() {
        const Area area = areaBesideLegend(options_.width, options_.height);
        const double angle = options_.angle * M_PI / 180;
        if (options_.eye) {
            camera_ =
                cameraAt(frame_(*options_.eye), frame_(options_.lookAt.value_or(frame_.centre)), angle, area);
            return;
        }
        std::vector<Vector3f> points;
        if (!isClose_) points = wall_.vertices;
        for (const PosedPart& pose : poses_) {
            const auto corners = cornersOf(partSurface_, placementOf(pose));
            points.insert(points.end(), corners.begin(), corners.end());
        }
        camera_ = cameraAround(points, direction_, angle, area);
    }

    void addWay(const std::vector<PosedPart>& way) {
        if (way.size() < 2) return;
        Body body;
        std::vector<Vector3f> points;
        for (const PosedPart& pose : way) {
            points.push_back(placementOf(pose).translation);
            body.colours.push_back(clearanceColour(pose.clearance / most_));
        }
        const double pixels = std::max(2.0, kWayRadius * options_.height);
        const float depth = (points[points.size() / 2] - camera_.eye).norm();
        const float radius = static_cast<float>(pixels) * depth / camera_.focal;
        body.shape = stages_.solids.addShape(tubeAlong(points, radius));
        body.hasSeams = false;
        body.isOnScale = true;
        stages_.solids.addBody(body);
    }

    void addBodies(const Mesh& environment) {
        const std::size_t wall = stages_.solids.addShape(std::move(wall_));
        stages_.solids.addBody({wall, {}, environmentColours(environment)});
        const bool hasGhosts =
            std::any_of(poses_.begin(), poses_.end(), [](const PosedPart& pose) { return pose.isGhost; });
        if (hasGhosts) stages_.ghosts.addShape(partSurface_);
        const std::size_t part = stages_.solids.addShape(std::move(partSurface_));
        for (const PosedPart& pose : poses_) {
            Body body{part, placementOf(pose), {clearanceColour(pose.clearance / most_)}};
            body.isOnScale = true;
            if (pose.isGhost) body.shape = 0;
            (pose.isGhost ? stages_.ghosts : stages_.solids).addBody(body);
        }
        stages_.solids.finish();
        stages_.ghosts.finish();
    }

    const RenderOptions& options_;
    const std::vector<PosedPart>& poses_;
    Box partBox_;
    Frame frame_;
    double most_;
    Surface partSurface_, wall_;
    bool isInside_ = false, isClose_ = false;
    Vector3 direction_ = Vector3::UnitZ();
    Camera camera_;
    Stages stages_;
};

}  // namespace

Image render(const Mesh& part, const Mesh& environment, const std::vector<PosedPart>& poses,
             const std::vector<PosedPart>& way, const RenderOptions& options) {
    requireOptions(poses, options);
    return Arrangement(part, environment, poses, way, options).picture();
}

}  // namespace clearway::render
