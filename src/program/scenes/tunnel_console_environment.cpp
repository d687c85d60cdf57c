// What the console is threaded out of: floor pan, skins, roof, ribs, duct, lines, brackets, bosses and the
// front wall.
#include <algorithm>
#include <cmath>

#include "program/scenes/random.h"
#include "program/scenes/solids.h"
#include "program/scenes/tunnel_console.h"

namespace clearway::scenes {

namespace {

constexpr double kSlit = 0.3;   // mm between neighbours
constexpr double kCabin = 480;  // mm of floor before the tunnel's mouth
constexpr double kFloorHalfWidth = 330;
constexpr double kRailInside = 60;  // mm between the part's flanges and the seat rails

struct Builder {
    const TunnelConsoleDesign& design;
    const Detail& detail;
    Random random;
    Assembly assembly{};

    int count(double atRichnessOne) const {
        return std::max(1, static_cast<int>(std::lround(atRichnessOne * detail.richness)));
    }
    Polyline rounded(const Polyline& line, const std::vector<double>& radii) const {
        return filleted(line, radii, detail.segmentsPerQuarter);
    }
    Piece swept(const Section& section, double from, double to) const {
        std::vector<double> stations;  // the straight part needs none between its ends
        if (from < 0) stations.push_back(from);
        if (to <= 0) stations.push_back(to);
        if (to > 0) {
            const std::vector<double> bent = stationsBetween(std::max(from, 0.0), to, detail.step);
            stations.insert(stations.end(), bent.begin(), bent.end());
        }
        return placed(sweep(section, stations),
                      [this](const Vector3& p) { return design.screw.bendAfterStart(p); });
    }
    Piece rigid(const Piece& piece, const Vector3& at, const Vector3& axis, double turn = 0) const {
        return placed(placed(piece, standingAt(Vector3::Zero(), axis, turn)), rigidAt(design.screw, at));
    }
    Piece boss(const BossShape& shape) const {
        return turned(bossOutline(shape, detail.segmentsPerQuarter), detail.segmentsPerTurn);
    }
    /// Of several alike, one in four and never many lie at the gap, the first among them.
    static bool isNear(int i, int several) { return i % std::max(4, several / 3) == 0; }
    /// What others leave beyond the gap.
    double farther() { return design.room > 0 ? design.room * random.between(0.25, 1) : 0; }
    double outerWall() const { return design.wallHalfWidth + design.skinThickness; }

    void addFloor();
    void addSkins();
    void addRib(double s, const RibGaps& gaps);
    void addRibs();
    void addDuct();
    void addLines();
    void addStraps();
    void addGuides();
    void addMounts();
    void addFloorBosses();
    void addBrackets();
    void addCabin();
    void addFrontWall();
    void addStuds(int studs);
};

/// Longitudinal beads point down, away from the part.
void Builder::addFloor() {
    const double middle = design.floorTop() - design.floorThickness / 2;
    Polyline line{{kFloorHalfWidth, middle}};
    std::vector<double> radii;
    for (const double at : {250.0, 0.0, -250.0}) {
        const double half = random.between(22, 30), depth = random.between(7, 11);
        for (const Vector2& p : {Vector2(half + 1.2 * depth, 0), Vector2(half, -depth),
                                 Vector2(-half, -depth), Vector2(-half - 1.2 * depth, 0)}) {
            line.push_back({at + p.x(), middle + p.y()});
            radii.push_back(6);
        }
    }
    line.push_back({-kFloorHalfWidth, middle});
    const Section section = sheetSection(rounded(line, radii), design.floorThickness);
    assembly.add("floor_pan", swept(section, 0, design.tunnelLength + 40));
    assembly.add("floor_pan_rear", swept(section, -kCabin, -kSlit));
}

void Builder::addSkins() {
    const double t = design.skinThickness, wall = design.wallHalfWidth + t / 2;
    const double foot = design.floorTop() + kSlit + t / 2, head = design.roofHeight - kSlit - t / 2;
    const Polyline right{{wall + 45, foot}, {wall, foot}, {wall, head}, {wall + 30, head}};
    Polyline left(right.rbegin(), right.rend());
    for (Vector2& p : left) p.x() = -p.x();
    // Fillets bulge away from the part: the corner at the foot is rounded on the outer side.
    assembly.add("tunnel_skin_right", swept(sheetSection(rounded(right, {7, 5}), t), 0, design.tunnelLength));
    assembly.add("tunnel_skin_left", swept(sheetSection(rounded(left, {5, 7}), t), 0, design.tunnelLength));
    const double roof = design.roofHeight + t / 2, crown = random.between(9, 13);
    const Polyline top{{wall + 30, roof},   {64, roof},  {48, roof + crown},
                       {-48, roof + crown}, {-64, roof}, {-wall - 30, roof}};
    assembly.add("tunnel_roof",
                 swept(sheetSection(rounded(top, {10, 10, 10, 10}), t), 0, design.tunnelLength));
}

/// A plate between the skins and an opening that follows the console's hat.
void Builder::addRib(double s, const RibGaps& gaps) {
    const double floor = design.floorTop() + kSlit;
    const Polyline inner = ribOpening(design, gaps, floor, detail.segmentsPerQuarter);

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
    assembly.addNumbered("rib", swept(bandSection(inner, outer), s, s + design.ribThickness));
}

/// A near rib is near on one side: right, left and over the console in turn.
void Builder::addRibs() {
    const int ribs = std::clamp(count(design.room > 0 ? 5 : 7), 5, 40);
    const double first = 6, last = design.tunnelLength - 80;
    int near = 0;
    for (int i = 0; i < ribs; ++i) {
        const double jitter = i == 0 ? 0 : random.between(-0.2, 0.2);
        RibGaps gaps;
        for (double& gap : gaps.sides) gap = design.gap + farther();
        if (isNear(i, ribs)) gaps.sides[near++ % 3] = design.gap;
        addRib(first + (last - first) * std::min((i + jitter) / (ribs - 1), 1.0), gaps);
    }
}

/// A heater duct that the console straddles.
void Builder::addDuct() {
    const double low = design.floorTop() + 1, half = 55 - design.gap;
    const double under =
        design.gap + random.between(8, 14) + design.room / 2;  // what lowest hangs in the part
    const double high = design.height - design.innerDepth - under, wall = 2;
    const int n = detail.segmentsPerQuarter;
    const double from = random.between(90, 130);
    const Section tube =
        ringSection(roundedRectangle({-half, low}, {half, high}, 12, n),
                    roundedRectangle({-half + wall, low + wall}, {half - wall, high - wall}, 12 - wall, n));
    assembly.add("heater_duct", swept(tube, from, design.tunnelLength - 20));
    for (int i = 0; i < count(2); ++i) {
        // Straps across the duct, lower than its top surface allows for.
        const double s = from + 60 + (design.tunnelLength - from - 160) * (i + 0.5) / count(2);
        const Polyline over{{half + 24, low},      {half + 2, low},  {half + 2, high + 2},
                            {-half - 2, high + 2}, {-half - 2, low}, {-half - 24, low}};
        assembly.addNumbered("duct_strap",
                             swept(sheetSection(rounded(over, {3, 13, 13, 3}), 1.8), s, s + 16));
    }
}

/// Pipes along the floor, outside the skins.
void Builder::addLines() {
    const double radius[] = {5, 4, 3};
    const double across[] = {215 + design.room, -212 - design.room, -226 - design.room};
    const char* const names[] = {"fuel_line", "brake_line_front", "brake_line_rear"};
    for (int i = 0; i < 3; ++i) {
        const Vector2 centre(across[i], design.floorTop() + radius[i] + 6);
        const Section pipe = fullSection(circle(centre, radius[i], std::max(8, detail.segmentsPerTurn / 2)));
        assembly.add(names[i], swept(pipe, -kCabin + 40 + 30 * i, design.tunnelLength + 20));
    }
}

/// Stiffening bands over skins and roof, outside.
void Builder::addStraps() {
    const double out = outerWall() + 34, foot = design.floorTop() + design.skinThickness + 3 * kSlit + 1.2;
    const double roof = design.roofHeight + 18;
    const int straps = count(2);
    for (int i = 0; i < straps; ++i) {
        const double s = design.tunnelLength * (i + random.between(0.4, 0.6)) / straps;
        const Polyline over{{out + 30, foot}, {out, foot},  {out, roof},
                            {-out, roof},     {-out, foot}, {-out - 30, foot}};
        assembly.addNumbered("tunnel_strap",
                             swept(sheetSection(rounded(over, {8, 25, 25, 8}), 2.4), s, s + 36));
    }
}

/// Round guides on the inside of the walls, over the flanges, up to the gap or near it.
void Builder::addGuides() {
    const int guides = count(3);
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
        assembly.addNumbered("guide", rigid(boss(shape), {s, side * wall, v}, {0, -side, 0}));
    }
}

/// Bosses and short rails under the flanges, on a floor that is farther off than the gap.
void Builder::addMounts() {
    if (design.room <= 0) return;
    const int mounts = std::clamp(count(3), 3, 16);
    const double floor = design.floorTop() + kSlit,
                 across = (design.footHalfWidth + design.flangeHalfWidth) / 2;
    for (int i = 0; i < mounts; ++i) {
        const double u = (i % 2 == 0 ? 1 : -1) * across;
        const double s = 40 + (design.tunnelLength - 180) * (i + random.between(0.2, 0.8)) / mounts;
        const double height = design.room - kSlit - (isNear(i, mounts) ? 0 : 0.75 * farther());
        if (i % 3 == 1) {
            const Section rail = rectangleSection({u - 6, floor}, {u + 6, floor + height});
            assembly.addNumbered("mount_rail", swept(rail, s, s + random.between(40, 70)));
            continue;
        }
        BossShape shape;
        shape.radius = random.between(6, 8);
        shape.height = height;
        shape.foot = shape.rounding = std::min(2.0, height / 4);
        shape.pad = shape.foot / 2;
        assembly.addNumbered("mount", rigid(boss(shape), {s, u, floor}, Vector3::UnitZ()));
    }
}

void Builder::addFloorBosses() {
    const int bosses = count(4);
    for (int i = 0; i < bosses; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const double s =
            -kCabin / 2 + (design.tunnelLength + kCabin / 2 - 40) * (i + random.between(0.2, 0.8)) / bosses;
        BossShape shape;
        shape.radius = random.between(7, 13);
        shape.height = random.between(14, 36);
        const double u = side * random.between(288, 305);
        const Vector3 at(s, u, design.floorTop() + kSlit);
        // Before the mouth the floor is flat, so that a boss there stands upright.
        const Vector3 foot = design.screw.bendAfterStart(at);
        const Piece piece = boss(shape);
        assembly.addNumbered("boss", s < 0 ? placed(piece, standingAt(foot, Vector3::UnitZ()))
                                           : rigid(piece, at, Vector3::UnitZ()));
    }
}

/// Angles between skins and floor, outside, each with a bolt head on the upright leg.
void Builder::addBrackets() {
    const int brackets = count(4);
    for (int i = 0; i < brackets; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, thickness = random.between(2, 3);
        const double s = 40 + (design.tunnelLength - 120) * (i + random.between(0.2, 0.8)) / brackets;
        const double inner = outerWall() + kSlit + thickness / 2;
        const double foot = design.floorTop() + 2 * kSlit + design.skinThickness + thickness / 2 + 1;
        Polyline line{{inner + 40, foot}, {inner, foot}, {inner, foot + random.between(50, 80)}};
        if (side < 0) {
            std::reverse(line.begin(), line.end());
            for (Vector2& p : line) p.x() = -p.x();
        }
        const Section angle = sheetSection(rounded(line, {9}), thickness);
        assembly.addNumbered("bracket", swept(angle, s, s + random.between(30, 45)));
        BossShape bolt;
        bolt.radius = 6;
        bolt.height = 9;
        bolt.foot = 2;
        const Vector3 at(s + 16, side * (inner + thickness / 2 + kSlit), foot + 34);
        assembly.addNumbered("bolt", rigid(boss(bolt), at, {0, side, 0}));
    }
}

/// Seat rails beside the way out and a tube across, over the roof.
void Builder::addCabin() {
    const double floor = design.floorTop() + kSlit + 1;
    for (const double side : {1.0, -1.0}) {
        const double at = side * (design.flangeHalfWidth + design.gap + kRailInside);
        const Polyline channel{
            {at + 20, floor + 34}, {at + 20, floor}, {at - 20, floor}, {at - 20, floor + 34}};
        Polyline line = channel;
        std::reverse(line.begin(), line.end());
        assembly.add(side > 0 ? "seat_rail_right" : "seat_rail_left",
                     swept(sheetSection(rounded(line, {4, 4}), 2.2), -kCabin + 20, -40));
    }
    const double over = design.roofHeight + 75, radius = 24;
    const Polyline outline{
        {0, -kFloorHalfWidth}, {radius, -kFloorHalfWidth}, {radius, kFloorHalfWidth}, {0, kFloorHalfWidth}};
    const Piece tube = turned(filleted(outline, {5, 5}, detail.segmentsPerQuarter), detail.segmentsPerTurn);
    assembly.add("cross_beam", rigid(tube, {random.between(250, 330), 0, over}, Vector3::UnitY()));
}

/// Closes the tunnel before the part's front end, with an opening for the duct.
void Builder::addFrontWall() {
    const double squeeze =
        1 - design.height / design.screw.radius;  // millimetres of s are shorter at the part's top
    const double s = design.startAt + design.length + 1.1 * design.gap / squeeze + design.room;
    const double low = design.height - design.innerDepth,
                 high = design.roofHeight - 2 * kSlit - design.skinThickness;
    const double half = design.wallHalfWidth - kSlit;
    const Polyline bottom{{-half, low}, {-60, low}, {60, low}, {half, low}};
    const Polyline top{{-half, high}, {-60, high}, {60, high}, {half, high}};
    assembly.add("front_wall", swept(bandSection(top, bottom), s, s + 3));
}

/// Weld studs in rows on the floor, outside the tunnel.
void Builder::addStuds(int studs) {
    const Piece dome = turned(domeOutline(4, 5, detail.segmentsPerQuarter), detail.segmentsPerTurn);
    for (int i = 0; i < studs; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const double s = 25 + (design.tunnelLength - 50) * ((i / 2 % 50) + 0.5) / 50;
        const double u = side * (320 - 8.5 * (i / 100 % 4));
        assembly.addNumbered("stud", rigid(dome, {s, u, design.floorTop() + kSlit}, Vector3::UnitZ()));
    }
}

}  // namespace

Assembly buildTunnel(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs) {
    Builder builder{design, detail, random};
    builder.addFloor();
    builder.addSkins();
    builder.addRibs();
    builder.addDuct();
    builder.addLines();
    builder.addStraps();
    builder.addGuides();
    builder.addMounts();
    builder.addFloorBosses();
    builder.addBrackets();
    builder.addCabin();
    builder.addFrontWall();
    builder.addStuds(studs);
    return builder.assembly;
}

}  // namespace clearway::scenes
