#include "program/scenes/car_body.h"

#include <algorithm>
#include <cmath>

#include "program/scenes/scene_options.h"

namespace clearway::scenes {

namespace {

constexpr double kLeastClearance = 1, kMostClearance = 12;  // mm; beyond, the cowl is nearer than the pads

/// The gap is this much of the clearance wider than it must be: sampling planners need a little more than
/// nothing.
constexpr double kEase = 0.1;

double squared(double x) {
    return x * x;
}

}  // namespace

CarBody designCarBody(std::uint64_t seed, double clearance) {
    requireClearance(clearance, kLeastClearance, kMostClearance);
    Random random(seed);
    CarBody body;
    body.clearance = clearance;
    body.gap = clearance * (1 + kEase) + 0.01;  // faces at the gap are plane: only rounding takes from it
    body.beadDepth = random.between(5, 8);
    body.tunnelHeight = random.between(130, 145);
    body.crown = random.between(38, 50);
    body.approach = random.between(0.12, 0.16);
    body.entry = random.between(0.2, 0.26);
    return body;
}

double CarBody::halfWidth(double x, double z) const {
    const double ends = 90 * squared((x - 2000) / 2000), up = 2.2e-4 * squared(std::max(z - 600, 0.0));
    return 800 - ends - up - 2e-4 * squared(std::max(400 - z, 0.0));
}

double CarBody::floorZ(double x, double y) const {
    const double rear = smoothStep(x, 2360, 2560);
    const double tunnel = tunnelHeight * (1 - smoothStep(std::abs(y), 80, 190)) * (1 - rear);
    const double well = 170 * (1 - smoothStep(std::hypot(x - 3250, y), 210, 330));
    double beads = 0;  // along the car in front, down and away from the feet
    for (const double middle : {280.0, 380.0, 480.0, 580.0}) beads += beadAt(std::abs(y), middle, 18, 22);
    beads *= smoothStep(x, 1180, 1230) * (1 - smoothStep(x, 2250, 2300));
    double cross = 0;  // across it in the rear
    for (const double middle : {2680.0, 2780.0, 3620.0, 3700.0}) cross += beadAt(x, middle, 16, 22);
    cross *= 1 - smoothStep(std::abs(y), 420, 460);
    return 250 + tunnel + 130 * rear - well - beadDepth * (beads + cross);
}

double CarBody::roofZ(double x, double y) const {
    return 1420 - 55 * squared((x - 2300) / 900) - crown * squared(y / 620);
}

double CarBody::bonnetZ(double x, double y) const {
    const double along = std::clamp((x - 90) / 760, 0.0, 1.0);
    return 700 + 190 * std::sin(M_PI_2 * along) - 60 * squared(y / 650) + 12 * beadAt(y, 0, 120, 90) * along;
}

double CarBody::sideLowerEdge(double u) const {
    const double fromWheel = std::min(std::abs(u - kFrontWheel), std::abs(u - kRearWheel));
    return 200 + std::sqrt(std::max(0.0, squared(kWheelArch) - squared(fromWheel)));
}

Vector3 CarBody::side(double u, double v) const {
    // v from 200 to 1330 is spread over what the arch leaves.
    const double top = 1330, edge = sideLowerEdge(u);
    const double z = top - (top - v) * (top - edge) / (top - 200);
    const double lean = 0.9 * std::max(0.0, z - 900) * smoothStep(z, 860, 1000);
    const double x = u + lean * (1 - smoothStep(u, 1080, 2000)) * smoothStep(u, 700, 900);
    return {x, halfWidth(x, z), z};
}

Spine CarBody::dashProfile() const {
    return Spine::through({{1118, 0, 266}, {985, 0, 440}, {905, 0, 570}, {890, 0, 905}}, 70,
                          Vector3::UnitY());
}

Vector3 CarBody::dash(double u, double v) const {
    static const Spine profile = dashProfile();
    // The lower edge rises over the tunnel.
    const double edge = 245 * (1 - smoothStep(std::abs(u), 100, 215));
    const double length = edge + v * (1 - edge / profile.length());
    Vector3 point = profile.frameAt(length).translation;
    const double across = beadAt(u, 330, 45, 20) + beadAt(u, -330, 45, 20);
    point.x() -= 8 * squared(u / 620) + beadDepth * across * beadAt(length, 420, 90, 30);
    return {point.x(), u, point.z()};
}

void addFloorStuds(const CarBody& body, SheetMetal& metal, int studs) {
    const Polyline dome = domeOutline(4, 5, metal.detail().segmentsPerQuarter);
    for (int i = 0; i < studs; ++i) {
        // Rows between the underlay and the sills.
        const double side = i % 2 == 0 ? 1 : -1, x = 1190 + 12 * (i / 2 % 90) + 6 * (i / 360 % 2),
                     y = 623 + 9 * (i / 180 % 2);
        metal.turnedPart("stud", dome, {x, side * y, body.floorZ(x, y) + 0.9}, Vector3::UnitZ());
    }
}

SheetMetal buildCarBody(const CarBody& body, const Detail& detail, Random random, int studs, bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    addFloor(body, metal, random);
    addUnderbody(body, metal);
    addSides(body, metal, random);
    addDash(body, metal, random);
    addMountings(body, metal);
    addFrontEnd(body, metal, random);
    addRoof(body, metal);
    addRear(body, metal, random);
    addFloorStuds(body, metal, studs);
    return metal;
}

}  // namespace clearway::scenes
