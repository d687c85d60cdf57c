#include "demos/scenes/tunnel_body.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace clearway::scenes {

namespace {

constexpr double kFloorHalfWidth = 330;
constexpr double kRailInside = 60;  // mm between the part's flanges and the seat rails

/// Half widths of the beads' bottoms and of their flanks.
constexpr double kLongBead = 24, kLongFlank = 12, kCrossBead = 13, kCrossFlank = 9;
constexpr double kBeadPitch = 118;

std::vector<double> edgesOf(double middle, double half, double flank) {
    return {middle - half - flank, middle - half, middle + half, middle + half + flank};
}

/// The depth of the floor's beads: two along the floor outside the tunnel, a row across it under the console.
double floorBeads(double s, double u, double from, double to) {
    const double fade = beadAt(s, (from + to) / 2, (to - from) / 2 - 70, 40);
    const double along = 9 * fade * beadAt(std::abs(u), 250, kLongBead, kLongFlank);
    const double row = s - kBeadPitch * std::round(s / kBeadPitch);
    const double across = 6 * fade * beadAt(row, 0, kCrossBead, kCrossFlank) * beadAt(u, 0, 62, 14);
    return std::max(along, across);
}

struct Stretch {
    double from, to;
};

void addFloor(TunnelBody& body, const std::string& name, const Stretch& stretch) {
    const double middle = body.design.floorTop() - body.design.floorThickness / 2;
    PanelShape floor;
    floor.surface = [&body, middle, stretch](double s, double u) {
        return body.bend(s, u, middle - floorBeads(s, u, stretch.from, stretch.to));
    };
    floor.low = {stretch.from, -kFloorHalfWidth};
    floor.high = {stretch.to, kFloorHalfWidth};
    floor.thickness = body.design.floorThickness;
    floor.vLines = edgesOf(250, kLongBead, kLongFlank);
    for (const double line : edgesOf(-250, kLongBead, kLongFlank)) floor.vLines.push_back(line);
    for (const double line : {-76.0, -62.0, 62.0, 76.0}) floor.vLines.push_back(line);
    for (double s = kBeadPitch * std::ceil(stretch.from / kBeadPitch); s < stretch.to; s += kBeadPitch) {
        for (const double line : edgesOf(s, kCrossBead, kCrossFlank)) floor.uLines.push_back(line);
        // Drain holes beside the beads, and holes under the console between them.
        for (const double side : {-1.0, 1.0}) {
            floor.openings.push_back({{s + 30, side * 306}, {9, 9}, 2});
            floor.openings.push_back({{s + kBeadPitch / 2, side * 30}, {16, 10}, 2});
        }
    }
    body.metal.panel(name, floor);
}

/// A hat profile below the floor, closed by it.
void addRail(TunnelBody& body, const std::string& name, double u) {
    Polyline hat = hatLine(54, -44, 14);
    const double under = body.design.floorTop() - body.design.floorThickness - 1.2;
    for (Vector2& p : hat) p += Vector2(u, under);
    body.metal.part(name, body.swept(sheetSection(body.metal.rounded(hat, 7), 1.8), -TunnelBody::kCabin + 30,
                                     body.design.tunnelLength + 30));
}

void addSeatRail(TunnelBody& body, const std::string& name, double side) {
    const double floor = body.design.floorTop() + TunnelBody::kSlit + 1.1;
    const double at = side * (body.design.flangeHalfWidth + body.design.gap + kRailInside);
    const auto profile = std::make_shared<Profile>(
        Polyline{{at + 20, floor + 34}, {at + 20, floor}, {at - 20, floor}, {at - 20, floor + 34}},
        std::vector<double>{4, 4});
    PanelShape rail;
    rail.surface = [&body, profile](double s, double w) {
        const Vector2 p = profile->at(w);
        return body.bend(s, p.x(), p.y());
    };
    rail.low = {-TunnelBody::kCabin + 20, 0};
    rail.high = {-40, profile->length()};
    rail.thickness = 2.2;
    rail.vLines = profile->arcLines(body.metal.detail().segmentsPerQuarter);
    for (double s = -TunnelBody::kCabin + 40; s < -60; s += 24)
        rail.openings.push_back({{s, profile->length() / 2}, {6, 7}, 4});
    body.metal.panel(name, rail);
}

void addSkin(TunnelBody& body, const std::string& name, double side) {
    const TunnelConsoleDesign& design = body.design;
    const double t = design.skinThickness, wall = design.wallHalfWidth + t / 2;
    const double foot = design.floorTop() + TunnelBody::kSlit + t / 2,
                 head = design.roofHeight - TunnelBody::kSlit - t / 2;
    const auto profile =
        std::make_shared<Profile>(Polyline{{wall + 45, foot}, {wall, foot}, {wall, head}, {wall + 30, head}},
                                  std::vector<double>{7, 5});
    const double low = profile->corner(0), high = profile->corner(1), middle = (low + high) / 2;
    const double length = design.tunnelLength;
    PanelShape skin;
    skin.surface = [&body, profile, side, middle, length](double s, double w) {
        const Vector2 p = profile->at(w);
        const double bead = beadAt(w, middle, 9, 8) * beadAt(s, length / 2, length / 2 - 60, 40);
        return body.bend(s, side * (p.x() + 5 * bead), p.y());
    };
    skin.low = {0, 0};
    skin.high = {length, profile->length()};
    skin.thickness = t;
    skin.vLines = profile->arcLines(body.metal.detail().segmentsPerQuarter);
    for (const double line : edgesOf(middle, 9, 8)) skin.vLines.push_back(line);
    for (double s = 70; s < length - 40; s += 97) {
        skin.openings.push_back({{s, low + 0.24 * (high - low)}, {24, 15}, 3});
        skin.openings.push_back({{s + 48, low + 0.8 * (high - low)}, {11, 11}, 2});
        skin.openings.push_back({{s + 25, profile->length() - 11}, {4, 4}, 2});
        skin.openings.push_back({{s + 40, 20}, {5, 5}, 2});
    }
    body.metal.panel(name, skin);
}

void addRoof(TunnelBody& body) {
    const TunnelConsoleDesign& design = body.design;
    const double t = design.skinThickness, edge = design.wallHalfWidth + t / 2 + 30;
    const double roof = design.roofHeight + t / 2, crown = body.random.between(9, 13);
    const auto profile = std::make_shared<Profile>(
        Polyline{
            {edge, roof}, {64, roof}, {48, roof + crown}, {-48, roof + crown}, {-64, roof}, {-edge, roof}},
        std::vector<double>{10, 10, 10, 10});
    const double length = design.tunnelLength, middle = profile->length() / 2;
    PanelShape sheet;
    sheet.surface = [&body, profile, length](double s, double w) {
        const Vector2 p = profile->at(w);
        const double row = s - 90 * std::round(s / 90);
        const double beside = beadAt(std::abs(p.x()), 100, 16, 8);
        const double bead = 4 * beside * beadAt(row, 0, 14, 8) * beadAt(s, length / 2, length / 2 - 70, 30);
        return body.bend(s, p.x(), p.y() + bead);
    };
    sheet.low = {0, 0};
    sheet.high = {length, profile->length()};
    sheet.thickness = t;
    sheet.vLines = profile->arcLines(body.metal.detail().segmentsPerQuarter);
    for (double s = 90; s < length - 60; s += 90) {
        for (const double line : edgesOf(s, 14, 8)) sheet.uLines.push_back(line);
    }
    sheet.openings.push_back({{0.42 * length, middle}, {72, 36}, 4});  // for the gear lever
    sheet.openings.push_back({{0.68 * length, middle}, {48, 14}, 4});  // for the hand brake
    for (double s = 45; s < length - 20; s += 90) {
        for (const double side : {-1.0, 1.0})
            sheet.openings.push_back({{s, middle + side * (middle - 13)}, {4.5, 4.5}, 2});
        sheet.openings.push_back({{s, middle}, {12, 12}, 2});
    }
    body.metal.panel("tunnel_roof", sheet);
}

/// The front wall closes the tunnel in front of the part's front end and leaves a way for the duct below.
void addFrontWall(TunnelBody& body) {
    const TunnelConsoleDesign& design = body.design;
    const double squeeze =
        1 - design.height / design.screw.radius;  // millimetres of s are shorter at the part's top
    const double at = design.startAt + design.length + 1.1 * design.gap / squeeze + design.room;
    PanelShape wall;
    wall.surface = [&body, at](double u, double v) {
        return body.bend(at + 1.5 + 4 * beadAt(std::abs(u), 90, 14, 9) * beadAt(v, 130, 26, 8), u, v);
    };
    const double half = design.wallHalfWidth - TunnelBody::kSlit;
    wall.low = {-half, design.height - design.innerDepth};
    wall.high = {half, design.roofHeight - 2 * TunnelBody::kSlit - design.skinThickness};
    wall.thickness = 3;
    wall.uLines = edgesOf(90, 14, 9);
    for (const double line : edgesOf(-90, 14, 9)) wall.uLines.push_back(line);
    wall.vLines = edgesOf(130, 26, 8);
    wall.openings = {{{0, 128}, {34, 20}, 4},
                     {{55, 105}, {9, 9}, 2},
                     {{-55, 105}, {9, 9}, 2},
                     {{-55, 150}, {6, 6}, 2},
                     {{55, 150}, {6, 6}, 2}};
    body.metal.panel("front_wall", wall);
    for (const double side : {-1.0, 1.0}) {
        const Polyline lip{{10.5, -4}, {13, -4}, {13, -1.2}, {11.5, 0}, {13, 1.2}, {13, 4}, {10.5, 4}};
        body.metal.part("grommet", body.rigid(ring(lip, body.metal.detail().segmentsPerTurn),
                                              {at + 1.5, side * 55, 105}, Vector3::UnitX()));
        for (const double v : {100.0, 160.0})
            body.addBolt("front_wall_bolt", {at + 3.5, side * 128, v}, Vector3::UnitX(), 3);
    }
}

void addFloors(TunnelBody& body) {
    addFloor(body, "floor_pan", {0, body.design.tunnelLength + 40});
    addFloor(body, "floor_pan_rear", {-TunnelBody::kCabin, -TunnelBody::kSlit});
    addRail(body, "underfloor_rail_right", 160);
    addRail(body, "underfloor_rail_left", -160);
    addSeatRail(body, "seat_rail_right", 1);
    addSeatRail(body, "seat_rail_left", -1);
}

void addWalls(TunnelBody& body) {
    addSkin(body, "tunnel_skin_right", 1);
    addSkin(body, "tunnel_skin_left", -1);
    addRoof(body);
    addFrontWall(body);
}

}  // namespace

Piece TunnelBody::swept(const Section& section, double from, double to) const {
    std::vector<double> stations;  // only both ends of the straight part
    if (from < 0) stations.push_back(from);
    if (to <= 0) stations.push_back(to);
    if (to > 0) {
        const std::vector<double> bent = stationsBetween(std::max(from, 0.0), to, metal.detail().step);
        stations.insert(stations.end(), bent.begin(), bent.end());
    }
    return placed(sweep(section, stations),
                  [this](const Vector3& p) { return design.screw.bendAfterStart(p); });
}

Piece TunnelBody::rigid(const Piece& piece, const Vector3& at, const Vector3& axis) const {
    const Piece standing = placed(piece, standingAt(Vector3::Zero(), axis));
    // In front of the mouth everything is straight.
    if (at.x() < 0) {
        const Vector3 foot = bend(at.x(), at.y(), at.z());
        return placed(standing, [foot](const Vector3& p) -> Vector3 { return p + foot; });
    }
    return placed(standing, rigidAt(design.screw, at));
}

Piece TunnelBody::boss(const BossShape& shape) const {
    return turned(bossOutline(shape, metal.detail().segmentsPerQuarter), metal.detail().segmentsPerTurn);
}

void TunnelBody::addBolt(const std::string& stem, const Vector3& at, const Vector3& axis, double shank) {
    BoltShape shape;
    shape.shank = shank;
    shape.head = 1.7 * shank;
    shape.height = 1.6 * shank;
    shape.length = 4 * shank;
    metal.part(stem, rigid(bolt(shape, metal.detail().segmentsPerTurn), at, axis));
}

Line TunnelBody::along(double from, double to, const std::function<Vector2(double s)>& place) const {
    Line line;
    for (const double s : stationsBetween(from, to, std::min(2 * metal.detail().step, 30.0))) {
        const Vector2 across = place(s);
        line.push_back(bend(s, across.x(), across.y()));
    }
    return line;
}

SheetMetal buildTunnelBody(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs,
                           bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    TunnelBody body{design, metal, random};
    addFloors(body);
    addWalls(body);
    addTunnelFittings(body, studs);
    return metal;
}

}  // namespace clearway::scenes
