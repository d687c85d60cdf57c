// The parts that stand in the tunnel or are bolted to it.
#include "demos/scenes/tunnel_body.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

/// A rib: a plate between the skins and an opening that follows the console's hat, with its rim bent over.
void addRib(TunnelBody& body, double s, const RibGaps& gaps) {
    const TunnelConsoleDesign& design = body.design;
    const double floor = design.floorTop() + TunnelBody::kSlit;
    const int segments = body.metal.detail().segmentsPerQuarter;
    const Polyline inner = ribOpening(design, gaps, floor, segments);

    // Each point is cast from the middle of the floor to the skins and the roof.
    const double wall = design.wallHalfWidth - TunnelBody::kSlit,
                 roof = design.roofHeight - 2 * TunnelBody::kSlit - design.skinThickness;
    Polyline outer;
    for (const Vector2& p : inner) {
        const double rise = p.y() - floor;
        const double toWall = wall / std::max(std::abs(p.x()), 1e-9),
                     toRoof = (roof - floor) / std::max(rise, 1e-9);
        outer.push_back({p.x() * std::min(toWall, toRoof), floor + rise * std::min(toWall, toRoof)});
    }
    body.metal.part("rib", body.swept(bandSection(inner, outer), s, s + design.ribThickness));

    const auto beside = [&](double off) {
        RibGaps wider = gaps;
        for (double& gap : wider.sides) gap += off;
        return ribOpening(design, wider, floor, segments);
    };
    const double from = s + design.ribThickness + 0.1;
    body.metal.part("rib_flange", body.swept(bandSection(beside(0.6), beside(2.4)), from, from + 13));
}

constexpr double kUnder = 78;  // mm from the floor down to propeller shaft and exhaust

/// The radius of a corrugated hose or conduit along its length.
std::function<double(double)> corrugated(double radius, double pitch, double depth) {
    return [=](double at) { return radius - depth * (0.5 - 0.5 * std::cos(2 * M_PI * at / pitch)); };
}

Line fine(const Line& line, double step) {
    return smooth(line, step);
}

/// A clip around a line at a straight point.
void addClip(TunnelBody& body, const Vector3& at, double radius) {
    const int n = body.metal.detail().segmentsPerTurn;
    const Polyline loop{{radius + 0.4, -5}, {radius + 2.4, -5}, {radius + 2.4, 5}, {radius + 0.4, 5}};
    body.metal.part("clip", body.rigid(ring(loop, n), at, Vector3::UnitX()));
}

void addPipe(TunnelBody& body, const std::string& name, const Vector2& at, double radius, double from) {
    const double to = body.design.tunnelLength + 20;
    const int n = std::max(8, body.metal.detail().segmentsPerTurn / 2);
    const Line line = body.along(from, to, [&](double s) {
        // A jog around the parts on the floor.
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

/// Two corrugated heater hoses along the left skin, clamped at their ends.
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

/// Cables side by side along the right skin and over the roof, with connectors at their ends.
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
                 foot = design.floorTop() + design.skinThickness + 3 * TunnelBody::kSlit + 1.2;
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

/// Angles between skins and floor on the outside, bolted on both legs.
void addBrackets(TunnelBody& body) {
    const TunnelConsoleDesign& design = body.design;
    const int brackets = std::clamp(body.count(4), 4, 20);
    for (int i = 0; i < brackets; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, thickness = body.random.between(2, 3);
        const double s = 40 + (design.tunnelLength - 120) * (i + body.random.between(0.2, 0.8)) / brackets;
        const double inner = body.outerWall() + TunnelBody::kSlit + thickness / 2;
        const double foot =
            design.floorTop() + 2 * TunnelBody::kSlit + design.skinThickness + thickness / 2 + 1;
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

/// Bolts along both edges of the roof.
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
        const double s = -TunnelBody::kCabin / 2 +
                         (length + TunnelBody::kCabin / 2 - 40) * (i + body.random.between(0.2, 0.8)) / nuts;
        BossShape shape;
        shape.radius = body.random.between(5, 8);
        shape.height = body.random.between(8, 20);
        const double u = side * body.random.between(292, 300);
        body.metal.part("weld_nut",
                        body.rigid(body.boss(shape), {s, u, body.design.floorTop() + TunnelBody::kSlit},
                                   Vector3::UnitZ()));
    }
}

struct TunnelFittings : TunnelBody {
    void addRibs();      ///< with flanges
    void addSupports();  ///< guides on the walls, mounts on the floor
    void addDuct();
    void addUnderbody();  ///< propeller shaft, exhaust, heat shield
    void addLines();      ///< pipes, hoses, cables and their holders
    void addFasteners();  ///< straps, brackets, bolts, weld nuts
    void addStuds(int studs);
};

/// A near rib is near on one side: right, left and above the console in turn.
void TunnelFittings::addRibs() {
    const int ribs = std::clamp(count(5), 5, 17);
    const double first = 6, last = design.tunnelLength - 80;
    int near = 0;
    for (int i = 0; i < ribs; ++i) {
        const double jitter = i == 0 ? 0 : random.between(-0.2, 0.2);
        RibGaps gaps;
        for (double& gap : gaps.sides) gap = design.gap + farther();
        if (isNear(i, ribs)) gaps.sides[near++ % 3] = design.gap;
        addRib(*this, first + (last - first) * std::min((i + jitter) / (ribs - 1), 1.0), gaps);
    }
}

void TunnelFittings::addSupports() {
    const int guides = std::clamp(count(4), 4, 24);
    const double wall = design.wallHalfWidth - 2;  // sinks the pads into the wall, which is oblique
    for (int i = 0; i < guides; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, v = random.between(70, 105);
        const double s = 60 + (design.tunnelLength - 160) * (i + random.between(0.25, 0.75)) / guides;
        BossShape shape;
        shape.radius = random.between(7, 9);
        shape.foot = 3;
        const double reach = shape.radius + 2.1 * shape.foot;
        shape.height = wall - design.halfWidthAt(v - reach) - design.gap - random.between(0, 4);
        if (!isNear(i, guides)) shape.height -= farther();
        metal.part("guide", rigid(boss(shape), {s, side * wall, v}, {0, -side, 0}));
    }
    const int mounts = std::clamp(count(3), 3, 16);
    const double floor = design.floorTop() + kSlit,
                 across = (design.footHalfWidth + design.flangeHalfWidth) / 2;
    for (int i = 0; i < mounts; ++i) {
        const double u = (i % 2 == 0 ? 1 : -1) * across;
        const double s = 40 + (design.tunnelLength - 180) * (i + random.between(0.2, 0.8)) / mounts;
        const double height = design.room - kSlit - (isNear(i, mounts) ? 0 : 0.75 * farther());
        if (i % 3 == 1) {
            const Section rail = rectangleSection({u - 6, floor}, {u + 6, floor + height});
            metal.part("mount_rail", swept(rail, s, s + random.between(40, 70)));
            continue;
        }
        BossShape shape;
        shape.radius = random.between(6, 8);
        shape.height = height;
        shape.foot = shape.rounding = std::min(2.0, height / 4);
        shape.pad = shape.foot / 2;
        metal.part("mount", rigid(boss(shape), {s, u, floor}, Vector3::UnitZ()));
    }
}

/// A heater duct that the console straddles, in lengths with sleeves over their joints.
void TunnelFittings::addDuct() {
    const double low = design.floorTop() + 1, half = 55 - design.gap;
    const double under =
        design.gap + random.between(8, 14) + design.room / 2;  // below the lowest point inside the part
    const double high = design.height - design.innerDepth - under, wall = 2;
    const int n = metal.detail().segmentsPerQuarter;
    const double from = random.between(90, 130), to = design.tunnelLength - 20;
    const auto tube = [&](double more, double thick) {
        return ringSection(
            roundedRectangle({-half - more, low - more / 2}, {half + more, high + more}, 12 + more, n),
            roundedRectangle({-half - more + thick, low - more / 2 + thick},
                             {half + more - thick, high + more - thick}, 12 + more - thick, n));
    };
    constexpr int kLengths = 3;
    for (int i = 0; i < kLengths; ++i) {
        const double begin = from + (to - from) * i / kLengths, end = from + (to - from) * (i + 1) / kLengths;
        metal.part("heater_duct", swept(tube(0, wall), begin + 1, end - 1));
        if (i > 0) metal.part("duct_sleeve", swept(tube(1.9, 1.6), begin - 14, begin + 14));
    }
    const int straps = std::clamp(count(2), 2, 9);
    for (int i = 0; i < straps; ++i) {
        const double s = from + 60 + (to - from - 140) * (i + 0.5) / straps;
        const Polyline over{{half + 26, low},      {half + 4, low},  {half + 4, high + 4},
                            {-half - 4, high + 4}, {-half - 4, low}, {-half - 26, low}};
        metal.part("duct_strap", swept(sheetSection(filleted(over, {3, 13, 13, 3}, n), 1.8), s, s + 16));
        for (const double side : {-1.0, 1.0})
            addBolt("duct_bolt", {s + 8, side * (half + 16), low + 1.1}, Vector3::UnitZ(), 2.5);
    }
}

void TunnelFittings::addUnderbody() {
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

void TunnelFittings::addLines() {
    const double floor = design.floorTop() + 6;
    addPipe(*this, "fuel_line", {215 + design.room, floor + 5}, 5, -kCabin + 40);
    addPipe(*this, "brake_line_front", {-212 - design.room, floor + 4}, 4, -kCabin + 70);
    addPipe(*this, "brake_line_rear", {-226 - design.room, floor + 3}, 3, -kCabin + 100);
    addHoses(*this);
    addCables(*this);
    // A tube across the car, above the mouth.
    const double half = 330, radius = 24;
    const Polyline outline{{0, -half}, {radius, -half}, {radius, half}, {0, half}};
    const Piece tube =
        turned(filleted(outline, {5, 5}, metal.detail().segmentsPerQuarter), metal.detail().segmentsPerTurn);
    metal.part("cross_beam",
               rigid(tube, {random.between(250, 330), 0, design.roofHeight + 90}, Vector3::UnitY()));
}

void TunnelFittings::addFasteners() {
    addStraps(*this);
    addBrackets(*this);
    addRoofBolts(*this);
    addWeldNuts(*this);
}

/// Studs in rows on the floor, outside the tunnel.
void TunnelFittings::addStuds(int studs) {
    const Piece dome = turned(domeOutline(2.6, 4, 2), 12);
    for (int i = 0; i < studs; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const double s = 20 + (design.tunnelLength - 40) * ((i / 2 % 90) + 0.5) / 90;
        const double u = side * (319 - 6.5 * (i / 180 % 4));
        metal.part("stud", rigid(dome, {s, u, design.floorTop() + kSlit}, Vector3::UnitZ()));
    }
}

}  // namespace

void addTunnelFittings(TunnelBody& body, int studs) {
    TunnelFittings fittings{body};
    fittings.addRibs();
    fittings.addSupports();
    fittings.addDuct();
    fittings.addUnderbody();
    fittings.addLines();
    fittings.addFasteners();
    fittings.addStuds(studs);
}

}  // namespace clearway::scenes
