#include "program/scenes/roof_slot.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kLeastClearance = 1, kMostClearance = 12;  // mm; beyond, the slot reaches the sides

/// The gap is this much of the clearance wider than it must be: sampling planners need a little more than
/// nothing.
constexpr double kEase = 0.1;

constexpr double kLongestCell = 88;  // mm along the roof
constexpr double kStretch = 1.2;     // of cells beside openings
constexpr double kChord = 40;        // mm between two states along the roof
constexpr double kRounding = 0.02;   // mm: to float, and of normals where the profile has corners
constexpr double kHalfWidth = 620;   // of the profile

constexpr double kBeads[] = {-360, -240, -120, 0, 120, 240, 360};
constexpr double kBeadHalf = 20, kBeadFlank = 16, kBeadRounding = 11;
constexpr double kEmbossingPitch = 44;

double squared(double x) {
    return x * x;
}

/// By how much a chord of a circle of that radius is off it.
double sagitta(double chord, double radius) {
    return squared(chord) / (8 * radius);
}

/// How many chords each of the beads' roundings has: as many as the coarser of both meshes has room for.
int roundingChords(const SceneOptions& options) {
    const std::size_t room = std::min(options.partTriangles, options.environmentTriangles / 4);
    return room < 12000 ? 0 : room < 50000 ? 1 : 3;
}

Polyline profileOf(double crown, double depth, int chords) {
    Polyline line;
    std::vector<double> radii;
    const auto add = [&](double v, double below, double radius) {
        line.push_back({v, -crown * squared(v / kHalfWidth) - below});
        radii.push_back(radius);
    };
    for (const double v : {-kHalfWidth, -520.0, -450.0}) add(v, 0, 0);
    for (const double bead : kBeads) {
        add(bead - kBeadHalf - kBeadFlank, 0, kBeadRounding);
        add(bead - kBeadHalf, depth, kBeadRounding);
        if (chords > 0) add(bead, depth, 0);
        add(bead + kBeadHalf, depth, kBeadRounding);
        add(bead + kBeadHalf + kBeadFlank, 0, kBeadRounding);
    }
    for (const double v : {450.0, 520.0, kHalfWidth}) add(v, 0, 0);
    if (chords == 0) return line;
    radii.erase(radii.begin());
    radii.pop_back();
    // A bead's corner turns by about a fifth of a quarter.
    return filleted(line, radii, 4 * chords);
}

}  // namespace

RoofSlot designRoofSlot(const SceneOptions& options) {
    requireClearance(options.clearance, kLeastClearance, kMostClearance);
    Random random(options.seed);
    RoofSlot roof;
    roof.clearance = options.clearance;
    roof.radius = random.between(6700, 7300);
    roof.crown = random.between(38, 50);
    roof.beadDepth = random.between(5, 7.5);
    // Of two facing sheets, cut into chords, one comes nearer and the other goes away; so does the path.
    const double chords =
        sagitta(kStretch * kLongestCell, 0.97 * roof.radius) + sagitta(kChord, 0.97 * roof.radius);
    roof.gap = roof.clearance * (1 + kEase) + chords + kRounding;
    roof.lower = roof.upper + 55 + roof.gap;
    roof.profile = profileOf(roof.crown, roof.beadDepth, roundingChords(options));
    const Polyline offset = offsetLine(roof.profile, 1);
    for (std::size_t i = 0; i < offset.size(); ++i) roof.mitre.push_back(offset[i] - roof.profile[i]);
    for (double u = roof.trayFront - 2 * kLongestCell; u < 3000; u += kLongestCell)
        roof.keptULines.push_back(u);
    return roof;
}

Vector3 RoofSlot::at(double u, double v, double depth, double offset) const {
    const auto before = [](const Vector2& p, double value) { return p.x() < value; };
    const auto next = std::lower_bound(profile.begin() + 1, profile.end() - 1, v, before);
    const auto i = static_cast<std::size_t>(next - profile.begin());
    const double share = (v - profile[i - 1].x()) / (profile[i].x() - profile[i - 1].x());
    const Vector2 p =
        (1 - share) * (profile[i - 1] + offset * mitre[i - 1]) + share * (profile[i] + offset * mitre[i]);
    const double angle = (u - middle) / radius, r = radius - depth + p.y();
    return {middle + r * std::sin(angle), p.x(), top - radius + r * std::cos(angle)};
}

Vector3 RoofSlot::smoothAt(double u, double v, double depth, double height) const {
    const double angle = (u - middle) / radius, r = radius - depth + height - crown * squared(v / kHalfWidth);
    return {middle + r * std::sin(angle), v, top - radius + r * std::cos(angle)};
}

double RoofSlot::embossed(double u, double v) const {
    const double turn = 2 * M_PI / kEmbossingPitch;
    return embossing * smoothStep(std::sin(turn * u) * std::sin(turn * v), 0.25, 0.7);
}

/// By a bow in each direction; of faces that are as near everywhere, all pairs of triangles are the nearest.
double RoofSlot::receding(double u, double v) const {
    const double most = 1.8 + 0.17 * gap;
    return most * (squared((u - 1690) / (trayRear - trayFront)) + squared(v / trayHalf));
}

PartState RoofSlot::moved(double along) const {
    const Vector3 centre(middle, 0, top - radius);
    PartState state;
    state.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(along / radius, Vector3::UnitY()));
    state.position = centre - state.rotation * centre;
    return state;
}

std::vector<PartState> RoofSlot::path() const {
    const double out = slotRear - trayFront + 60;
    const int chords = static_cast<int>(std::ceil(out / kChord));
    std::vector<PartState> path;
    for (int i = 0; i <= chords; ++i) path.push_back(moved(out * i / chords));
    // Then lifted and levelled, so that it passes above the car's rear.
    const Vector3 tray = at((trayFront + trayRear) / 2, 0, lower, 0);
    const Vector3 behind = path.back().rotation * tray + path.back().position;
    const auto placedAt = [&](const Vector3& place, double pitch) {
        PartState state;
        state.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(pitch, Vector3::UnitY()));
        state.position = place - state.rotation * tray;
        return state;
    };
    path.push_back(placedAt(behind + Vector3(160, 0, 20), 0.1));
    path.push_back(placedAt(behind + Vector3(420, 0, 130), -0.1));
    path.push_back(placedAt(behind + Vector3(900, 0, 260), 0));
    return path;
}

}  // namespace clearway::scenes
