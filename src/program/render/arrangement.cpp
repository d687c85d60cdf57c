#include "program/render/arrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "program/render/legend.h"
#include "program/render/marks.h"
#include "program/render/samples.h"

namespace clearway::render {

namespace {

constexpr double kWayRadius = 0.0035;  ///< radius of the line along the path, share of the picture's height
constexpr double kHatching = 0.014;    ///< distance of the lines of hatching, share of the picture's height

/// The part is drawn this share of its distance nearer to the camera, where it looks as before. Faces that it
/// has in common with the environment are then its own, where rounding would choose one at each pixel.
constexpr float kNearer = 1e-5f;

/// Opacity of ghosts in a film, where they only stand by.
constexpr float kStillGhosts = 0.3f, kStillVeils = 0.1f;

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

/// The finite clearances of poses without contact.
struct Clearances {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    bool hasContact = false;
};

/// Poses in contact have a colour of their own, so the scale need not hold them.
Clearances clearancesOf(const Cast& cast) {
    Clearances found;
    for (const auto* list : {&cast.drawn, &cast.framed, &cast.way}) {
        for (const PosedPart& pose : *list) {
            found.hasContact = found.hasContact || pose.isInContact;
            if (pose.isInContact || !std::isfinite(pose.clearance)) continue;
            found.least = std::min(found.least, pose.clearance);
            found.most = std::max(found.most, pose.clearance);
        }
    }
    return found;
}

double scaleOf(const Cast& cast) {
    const Clearances found = clearancesOf(cast);
    return scaleFor(found.least, found.most, found.hasContact);
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

Pen penOf(PoseRole role) {
    return role == PoseRole::kStart ? Pen::kStart : role == PoseRole::kGoal ? Pen::kGoal : Pen::kPlain;
}

Colour partColour(const PosedPart& pose, double most) {
    return pose.isInContact ? contactColour() : clearanceColour(pose.clearance / most);
}

}  // namespace

StageFrame::StageFrame(const Box& box)
    : centre(box.center()), scale(1 / std::max(box.diagonal().norm(), 1e-300)) {}

Placement StageFrame::operator()(const Pose& pose, const Vector3& partCentre) const {
    return {pose.rotation.cast<float>(), (*this)(pose * partCentre).cast<float>()};
}

CutPlane StageFrame::operator()(const CutPlane& plane) const {
    return {plane.normal, scale * (plane.offset - plane.normal.dot(centre))};
}

Arrangement::Arrangement(const Mesh& part, const Mesh& environment, const Cast& cast,
                         const RenderOptions& options)
    : options_(options),
      cast_(cast),
      partBox_(boundingBox(part)),
      frame_(boundingBox(environment)),
      most_(options.scaleMost.value_or(scaleOf(cast))),
      mostClearance_(clearancesOf(cast).most),
      partSurface_(surfaceOf(part, partBox_.center(), frame_.scale)),
      wall_(surfaceOf(environment, frame_.centre, frame_.scale)) {
    chooseDirection();
    cutEnvironment();
    chooseCamera();
    chooseExposure();
    addPath();
    addBodies(environment);
}

void Arrangement::chooseDirection() {
    isInside_ = options_.view == "inside" && !options_.eye;
    isClose_ = options_.isClose || isInside_;
    direction_ =
        isInside_ ? insideDirection(cast_.framed) : viewNamed(options_.eye ? "iso" : options_.view).from;
    if (options_.eye) direction_ = *options_.eye - options_.lookAt.value_or(frame_.centre);
}

void Arrangement::cutEnvironment() {
    std::optional<CutPlane> cut = options_.cut;
    if (!cut && isInside_) cut = insideCut(direction_, partBox_, cast_.framed);
    if (!cut) return;
    const double side =
        options_.eye ? cut->normal.dot(*options_.eye) - cut->offset : cut->normal.dot(direction_);
    if (side < 0) cut = CutPlane{-cut->normal, -cut->offset};
    wall_ = cutBy(frame_(*cut), wall_);
}

void Arrangement::chooseCamera() {
    const Area area = areaBesideLegend(options_.width, options_.height);
    const double angle = options_.angle * M_PI / 180;
    if (options_.eye) {
        camera_ =
            cameraAt(frame_(*options_.eye), frame_(options_.lookAt.value_or(frame_.centre)), angle, area);
        return;
    }
    std::vector<Vector3f> points;
    if (!isClose_) points = wall_.vertices;
    for (const PosedPart& pose : cast_.framed) {
        const auto corners = cornersOf(partSurface_, placementOf(pose));
        points.insert(points.end(), corners.begin(), corners.end());
    }
    camera_ = cameraAround(points, direction_, angle, area);
}

void Arrangement::chooseExposure() {
    exposure_.width = options_.width;
    exposure_.height = options_.height;
    exposure_.samples = options_.samples;
    exposure_.lineWidth = std::max(1.0f, 1.4f * static_cast<float>(options_.height) / 720);
    exposure_.hatching = static_cast<float>(std::max(6.0, kHatching * options_.height));
    exposure_.isStopped = options_.isStopped;
}

void Arrangement::addPath() {
    const std::vector<PosedPart>& way = cast_.way;
    if (way.size() < 2) return;
    Body body;
    std::vector<Vector3f> points;
    for (const PosedPart& pose : way) {
        points.push_back(placementOf(pose).translation);
        body.colours.push_back(partColour(pose, most_));
    }
    const double pixels = std::max(2.0, kWayRadius * options_.height);
    const float depth = (points[points.size() / 2] - camera_.eye).norm();
    const float radius = static_cast<float>(pixels) * depth / camera_.focal;
    body.shape = stages_.solids.addShape(tubeAlong(points, radius));
    body.hasSeams = false;
    body.isOnScale = true;
    stages_.solids.addBody(body);
}

Body Arrangement::bodyOf(const PosedPart& pose) const {
    Placement placement = placementOf(pose);
    placement.rotation *= 1 - kNearer;
    placement.translation += kNearer * (camera_.eye - placement.translation);
    Body body{partShape_, placement, {partColour(pose, most_)}};
    body.isOnScale = true;
    body.isHatched = pose.isInContact;
    body.pen = penOf(pose.role);
    return body;
}

void Arrangement::addBodies(const Mesh& environment) {
    const std::size_t wall = stages_.solids.addShape(std::move(wall_));
    stages_.solids.addBody({wall, {}, environmentColours(environment)});
    partShape_ = stages_.solids.addShape(partSurface_);
    const bool hasGhosts = std::any_of(cast_.drawn.begin(), cast_.drawn.end(),
                                       [](const PosedPart& pose) { return pose.isGhost; });
    const std::size_t ghostShape = hasGhosts ? stages_.ghosts.addShape(partSurface_) : 0;
    for (const PosedPart& pose : cast_.drawn) {
        Body body = bodyOf(pose);
        if (pose.isGhost) body.shape = ghostShape;
        (pose.isGhost ? stages_.ghosts : stages_.solids).addBody(body);
    }
}

std::size_t Arrangement::addMover() {
    hasMover_ = true;
    exposure_.ghostShare = kStillGhosts;
    exposure_.veilShare = kStillVeils;
    stages_.solids.addBody(bodyOf(cast_.framed.front()));
    return stages_.solids.bodyCount() - 1;
}

void Arrangement::finish() {
    stages_.solids.finish();
    stages_.ghosts.finish();
}

PixelArea Arrangement::areaOf(const Placement& placement) const {
    constexpr int kRoom = 2;  // pixels, far more than rounding
    const PixelArea picture{0, 0, exposure_.width, exposure_.height};
    PixelArea area{picture.right, picture.bottom, picture.left, picture.top};
    for (const Vector3f& corner : cornersOf(partSurface_, placement)) {
        const std::optional<Eigen::Vector2f> place = camera_.placeOf(corner);
        if (!place) return picture;  // beside or behind the camera
        const auto bounded = [](float value, int most) {
            return static_cast<int>(std::clamp(value, -1.0f, static_cast<float>(most + 1)));
        };
        const int x = bounded(place->x(), picture.right), y = bounded(place->y(), picture.bottom);
        area = {std::min(area.left, x), std::min(area.top, y), std::max(area.right, x + 1),
                std::max(area.bottom, y + 1)};
    }
    return area.grownBy(kRoom).within(picture);
}

void Arrangement::drawOver(Image& image, const std::vector<PosedPart>& marked) const {
    std::vector<Vector3f> rings;
    for (const Vector3& mark : options_.marks) rings.push_back(frame_(mark).cast<float>());
    if (!rings.empty()) drawMarks(rings, camera_, image);
    if (options_.hasAxes) drawAxes(camera_, image);
    Legend legend;
    legend.most = most_;
    legend.isCutOff = mostClearance_ > most_ * (1 + 1e-6);
    legend.title = options_.scaleTitle;
    legend.unit = options_.unit;
    for (const PosedPart& pose : marked) {
        if (!pose.isInContact) legend.clearances.push_back(pose.clearance);
    }
    if (!options_.marksContacts) legend.signs = signsOf(cast_.drawn, hasMover_);
    if (cast_.way.size() > 1) legend.signs.push_back(Sign::kWay);
    const auto isInContact = [](const std::vector<PosedPart>& poses) {
        return std::any_of(poses.begin(), poses.end(),
                           [](const PosedPart& pose) { return pose.isInContact; });
    };
    if (isInContact(cast_.drawn) || isInContact(cast_.framed) || isInContact(cast_.way))
        legend.signs.push_back(Sign::kContact);
    if (!rings.empty()) legend.signs.push_back(options_.marksContacts ? Sign::kMeeting : Sign::kOverlap);
    drawLegend(legend, image);
}

}  // namespace clearway::render
