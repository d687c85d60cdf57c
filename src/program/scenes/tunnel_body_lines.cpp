// What is laid along the tunnel and bolted to it: propeller shaft, exhaust, pipes, hoses, cables, straps,
// brackets, weld nuts and studs.
#include <algorithm>
#include <cmath>

#include "program/scenes/loft.h"
#include "program/scenes/tunnel_body.h"

namespace clearway::scenes {

namespace {

constexpr double kSlit = 0.3;
constexpr double kCabin = 480;
constexpr double kUnder = 78;  // mm from the floor down to propeller shaft and exhaust

/// Rings a hose or a conduit is corrugated by.
std::function<double(double)> corrugated(double radius, double pitch, double depth) {
    return [=](double at) { return radius - depth * (0.5 - 0.5 * std::cos(2 * M_PI * at / pitch)); };
}

Line fine(const Line& line, double step) {
    return smooth(line, step);
}

/// A clip around a line at (u, v), with its foot on the floor or wall that lies `foot` along `axis`.
void addClip(TunnelBody& body, const Vector3& at, double radius) {
    const int n = body.metal.detail().segmentsPerTurn;
    const Polyline loop{{radius + 0.4, -5}, {radius + 2.4, -5}, {radius + 2.4, 5}, {radius + 0.4, 5}};
    body.metal.part("clip", body.rigid(ring(loop, n), at, Vector3::UnitX()));
}

void addPipe(TunnelBody& body, const std::string& name, const Vector2& at, double radius, double from) {
    const double to = body.design.tunnelLength + 20;
    const int n = std::max(8, body.metal.detail().segmentsPerTurn / 2);
    const Line line = body.along(from, to, [&](double s) {
        // A jog round what stands on the floor.
        const double jog = 9 * beadAt(s, 420, 60, 50) - 7 * beadAt(s, -200, 40, 60);
        return Vector2(at.x() + (at.x() > 0 ? jog : -jog), at.y());
    });
    body.metal.part(name, rod(line, radius, n));
    const int clips = std::clamp(body.count(2), 2, 8);
    for (int i = 0; i < clips; ++i) {
        const double s = 80 + (body.design.tunnelLength - 160) * (i + 0.5) / clips;
        if (std::abs(s - 420) > 120) addClip(body, {s, at.x(), at.y()}, radius);
    }
}

/// Two heater hoses along the left skin, corrugated, clamped at their ends.
void addHoses(TunnelBody& body) {
    const double u = -body.outerWall() - 19, to = body.design.tunnelLength - 30;
    const int n = body.metal.detail().segmentsPerTurn;
    for (const double v : {92.0, 117.0}) {
        const Line line = body.along(50, to, [&](double s) {
            return Vector2(u - 3 * std::sin(s / 90), v + 4 * std::sin(s / 130 + v));
        });
        const Line closer = fine(line, std::max(1.2, 0.35 * body.metal.detail().step));
        body.metal.part("heater_hose", variedRod(closer, corrugated(9, 14, 1.6), n));
        for (const double s : {60.0, to - 12})
            addClip(body, {s, u - 3 * std::sin(s / 90), v + 4 * std::sin(s / 130 + v)}, 9.4);
    }
}

/// Cables side by side along the right skin, and over the roof, with connectors at their ends.
void addCables(TunnelBody& body) {
    const int n = std::max(6, body.metal.detail().segmentsPerTurn / 3);
    const int quarter = body.metal.detail().segmentsPerQuarter;
    const double to = body.design.tunnelLength - 40;
    const int cables = std::clamp(body.count(1.5), 2, 6);
    for (int i = 0; i < cables; ++i) {
        const double phase = body.random.between(0, 6), radius = body.random.between(2.5, 4);
        const double u = body.outerWall() + 12, v = 76 + 80.0 * i / cables;
        const Line line = body.along(30 + 12 * i, to - 25 * i, [&](double s) {
            return Vector2(u + 3 * std::sin(s / 70 + phase), v + 5 * std::sin(s / 110 + phase));
        });
        body.metal.part("cable", rod(fine(line, 0.7 * body.metal.detail().step), radius, n));
        const Piece plug = roundedBox({-8, -6, -13}, {8, 6, 13}, 2, 1, quarter);
        body.metal.part("connector", body.rigid(plug, {to - 25 * i, u, v}, Vector3::UnitX()));
    }
    const double over = body.design.roofHeight + 36;
    for (const double side : {-1.0, 1.0}) {
        const Line line = body.along(0.42 * to, body.design.tunnelLength + 10, [&](double s) {
            return Vector2(side * (13 + 12 * std::sin((s - 0.42 * to) / 220)), over + 5 * std::sin(s / 95));
        });
        body.metal.part("shift_cable", variedRod(fine(line, std::max(1.5, 0.4 * body.metal.detail().step)),
                                                 corrugated(5.5, 11, 0.8), n));
    }
    const Piece housing = roundedBox({-30, -24, 0}, {30, 24, 34}, 8, 4, quarter);
    body.metal.part("shift_housing", body.rigid(housing, {0.42 * to - 34, 0, over - 14}, Vector3::UnitZ()));
}

void addStraps(TunnelBody& body) {
    const TunnelConsoleDesign& design = body.design;
    const double out = body.outerWall() + 38,
                 foot = design.floorTop() + design.skinThickness + 3 * kSlit + 1.2;
    const double roof = design.roofHeight + 18;
    const int straps = std::clamp(body.count(2), 2, 8);
    for (int i = 0; i < straps; ++i) {
        const double s = design.tunnelLength * (i + body.random.between(0.4, 0.6)) / straps;
        const Polyline over{{out + 30, foot}, {out, foot},  {out, roof},
                            {-out, roof},     {-out, foot}, {-out - 30, foot}};
        const Polyline rounded = filleted(over, {8, 25, 25, 8}, 2 * body.metal.detail().segmentsPerQuarter);
        body.metal.part("tunnel_strap", body.swept(sheetSection(rounded, 2.4), s, s + 36));
        for (const double side : {-1.0, 1.0})
            body.addBolt("strap_bolt", {s + 18, side * (out + 17), foot + 1.4}, Vector3::UnitZ(), 3.5);
    }
}

/// Angles between skins and floor, outside, bolted on both legs.
void addBrackets(TunnelBody& body) {
    const TunnelConsoleDesign& design = body.design;
    const int brackets = std::clamp(body.count(4), 4, 20);
    for (int i = 0; i < brackets; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, thickness = body.random.between(2, 3);
        const double s = 40 + (design.tunnelLength - 120) * (i + body.random.between(0.2, 0.8)) / brackets;
        const double inner = body.outerWall() + kSlit + thickness / 2;
        const double foot = design.floorTop() + 2 * kSlit + design.skinThickness + thickness / 2 + 1;
        Polyline line{{inner + 40, foot}, {inner, foot}, {inner, foot + body.random.between(50, 66)}};
        if (side < 0) {
            std::reverse(line.begin(), line.end());
            for (Vector2& p : line) p.x() = -p.x();
        }
        const Section angle = sheetSection(body.metal.rounded(line, 9), thickness);
        body.metal.part("bracket", body.swept(angle, s, s + 32));
        const double face = inner + thickness / 2 + 0.2;
        body.addBolt("bracket_bolt", {s + 16, side * face, foot + 36}, {0, side, 0}, 3);
        body.addBolt("bracket_bolt", {s + 16, side * (inner + 26), foot + thickness / 2 + 0.2},
                     Vector3::UnitZ(), 3);
    }
}

/// Along both edges of the roof.
void addRoofBolts(TunnelBody& body) {
    const TunnelConsoleDesign& design = body.design;
    const double u = body.outerWall() + 16, v = design.roofHeight + design.skinThickness + 0.2;
    const int bolts = std::clamp(body.count(4), 4, 22);
    for (int i = 0; i < bolts; ++i) {
        const double s = 20 + (design.tunnelLength - 60) * (i + 0.5) / bolts;
        for (const double side : {-1.0, 1.0})
            body.addBolt("roof_bolt", {s, side * u, v}, Vector3::UnitZ(), 2.5);
    }
}

void addWeldNuts(TunnelBody& body) {
    const int nuts = std::clamp(body.count(4), 4, 24);
    for (int i = 0; i < nuts; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, length = body.design.tunnelLength;
        const double s =
            -kCabin / 2 + (length + kCabin / 2 - 40) * (i + body.random.between(0.2, 0.8)) / nuts;
        BossShape shape;
        shape.radius = body.random.between(5, 8);
        shape.height = body.random.between(8, 20);
        const double u = side * body.random.between(292, 300);
        body.metal.part("weld_nut", body.rigid(body.boss(shape), {s, u, body.design.floorTop() + kSlit},
                                               Vector3::UnitZ()));
    }
}

}  // namespace

void TunnelBody::addUnderbody() {
    const double v = design.floorTop() - kUnder, to = design.tunnelLength + 30;
    const int n = metal.detail().segmentsPerTurn;
    const Line shaft = along(-kCabin + 10, to, [&](double) { return Vector2(0, v); });
    const Line closer = fine(shaft, std::max(2.0, 0.6 * metal.detail().step));
    metal.part("propeller_shaft", variedRod(
                                      closer,
                                      [](double at) {
                                          const double joint = beadAt(at, 560, 16, 5);
                                          return 27 + 13 * joint + 5 * beadAt(at, 640, 34, 12);
                                      },
                                      n));
    const Line pipeLine = along(-kCabin - 20, to, [&](double s) {
        return Vector2(-92 - 8 * std::sin(s / 260), v - 6 - 5 * std::sin(s / 300));
    });
    metal.part(
        "exhaust",
        variedRod(
            fine(pipeLine, std::max(2.0, 0.6 * metal.detail().step)),
            [](double at) { return 22 + 17 * beadAt(at, 900, 150, 25) + 2.5 * beadAt(at, 500, 20, 3); }, n));
    // A dimpled shell over the exhaust.
    PanelShape shield;
    constexpr double kRadius = 56;
    shield.surface = [this, v](double s, double w) {
        const double angle = 0.25 + w / kRadius;
        const double radius = kRadius + 0.9 * std::sin(s / 4.5) * std::sin(w / 4.5);
        return bend(s, -95 + radius * std::cos(angle), v - 6 + radius * std::sin(angle));
    };
    shield.low = {120, 0};
    shield.high = {design.tunnelLength - 60, 2.6 * kRadius};
    shield.thickness = 1.6;
    for (double s = 160; s < design.tunnelLength - 90; s += 130)
        for (const double w : {16.0, 2.6 * kRadius - 16}) shield.openings.push_back({{s, w}, {5, 5}, 2});
    metal.panel("heat_shield", shield);
}

void TunnelBody::addLines() {
    const double floor = design.floorTop() + 6;
    addPipe(*this, "fuel_line", {215 + design.room, floor + 5}, 5, -kCabin + 40);
    addPipe(*this, "brake_line_front", {-212 - design.room, floor + 4}, 4, -kCabin + 70);
    addPipe(*this, "brake_line_rear", {-226 - design.room, floor + 3}, 3, -kCabin + 100);
    addHoses(*this);
    addCables(*this);
    // A tube across the car, over the mouth.
    const double half = 330, radius = 24;
    const Polyline outline{{0, -half}, {radius, -half}, {radius, half}, {0, half}};
    const Piece tube =
        turned(filleted(outline, {5, 5}, metal.detail().segmentsPerQuarter), metal.detail().segmentsPerTurn);
    metal.part("cross_beam",
               rigid(tube, {random.between(250, 330), 0, design.roofHeight + 90}, Vector3::UnitY()));
}

void TunnelBody::addFasteners() {
    addStraps(*this);
    addBrackets(*this);
    addRoofBolts(*this);
    addWeldNuts(*this);
}

/// In rows on the floor, outside the tunnel.
void TunnelBody::addStuds(int studs) {
    const Piece dome = turned(domeOutline(2.6, 4, 2), 12);
    for (int i = 0; i < studs; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const double s = 20 + (design.tunnelLength - 40) * ((i / 2 % 90) + 0.5) / 90;
        const double u = side * (319 - 6.5 * (i / 180 % 4));
        metal.part("stud", rigid(dome, {s, u, design.floorTop() + kSlit}, Vector3::UnitZ()));
    }
}

}  // namespace clearway::scenes
