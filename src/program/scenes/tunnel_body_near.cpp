// What comes near the console: ribs with flanges, guides on the walls, mounts on the floor, the heater duct.
#include <algorithm>
#include <cmath>

#include "program/scenes/tunnel_body.h"

namespace clearway::scenes {

namespace {

constexpr double kSlit = 0.3;  // mm between neighbours

/// A plate between the skins and an opening that follows the console's hat, its rim bent over.
void addRib(TunnelBody& body, double s, const RibGaps& gaps) {
    const TunnelConsoleDesign& design = body.design;
    const double floor = design.floorTop() + kSlit;
    const int segments = body.metal.detail().segmentsPerQuarter;
    const Polyline inner = ribOpening(design, gaps, floor, segments);

    // Each point is cast from the middle of the floor to the skins and the roof.
    const double wall = design.wallHalfWidth - kSlit,
                 roof = design.roofHeight - 2 * kSlit - design.skinThickness;
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

}  // namespace

/// A near rib is near on one side: right, left and over the console in turn.
void TunnelBody::addRibs() {
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

void TunnelBody::addSupports() {
    const int guides = std::clamp(count(4), 4, 24);
    const double wall = design.wallHalfWidth - 2;  // the wall is oblique, their pads are not
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
void TunnelBody::addDuct() {
    const double low = design.floorTop() + 1, half = 55 - design.gap;
    const double under =
        design.gap + random.between(8, 14) + design.room / 2;  // what lowest hangs in the part
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

}  // namespace clearway::scenes
