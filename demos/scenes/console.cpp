#include "demos/scenes/console.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace clearway::scenes {

namespace {

constexpr double kConsoleSlit = 0.2;  // mm between components, so that no two touch
constexpr double kTrayHalf = 46;      // half the width of a cup's tray
constexpr double kCupRadius = 38;     // radius of the holes in the trays
constexpr double kDrop = 3;           // depth of trays, bin and gate below the top

struct ConsoleBody {
    const TunnelConsoleDesign& design;
    SheetMetal& metal;
    Random& random;

    double topInside() const { return design.height - design.shellThickness; }
    double lowest() const { return design.height - design.innerDepth; }
    double binAt() const { return -0.28 * design.length; }
    double leverAt() const { return 0.25 * design.length; }
    int quarter() const { return metal.detail().segmentsPerQuarter; }
    int turn() const { return metal.detail().segmentsPerTurn; }

    Piece bent(const Piece& piece) const {
        return placed(piece, [this](const Vector3& p) { return design.screw.bend(p); });
    }
    Piece rigid(const Piece& piece, const Vector3& at, const Vector3& axis) const {
        return placed(placed(piece, standingAt(Vector3::Zero(), axis)), rigidAt(design.screw, at));
    }
    /// Places a piece with x and y along s and u, z up.
    Piece level(const Piece& piece, const Vector3& at) const {
        return placed(piece, rigidAt(design.screw, at));
    }

    void addShell();
    void addCups();
    void addBin();
    void addLever();
    void addWebs();
    void addStiffeners();
    void addBosses();
    void addHarness();
    void addVents();
    void addStuds(int studs);
};

/// The shell's outer side stays within the hat that the tunnel was made for: beads go inwards.
void ConsoleBody::addShell() {
    const double half = design.shellThickness / 2, top = design.height - half;
    const double foot = design.footHalfWidth - half, head = design.topHalfWidth - half;
    const auto profile = std::make_shared<Profile>(
        Polyline{{design.flangeHalfWidth, half},
                 {foot, half},
                 {head, top},
                 {-head, top},
                 {-foot, half},
                 {-design.flangeHalfWidth, half}},
        std::vector<double>{design.footRadius, design.topRadius, design.topRadius, design.footRadius});
    const double length = design.length, middle = profile->length() / 2;
    const double flank = (profile->corner(0) + profile->corner(1)) / 2;
    PanelShape shell;
    shell.surface = [this, profile, flank, middle, length](double s, double w) {
        const Vector2 p = profile->at(w);
        // A pressed-in field on each side.
        const double field =
            beadAt(middle - std::abs(w - middle), flank, 26, 9) * beadAt(s, -0.12 * length, 0.3 * length, 16);
        return design.screw.bend({s, p.x() - std::copysign(2.2 * field, p.x()), p.y()});
    };
    shell.low = {-length / 2, 0};
    shell.high = {length / 2, profile->length()};
    shell.thickness = design.shellThickness;
    shell.vLines = profile->arcLines(quarter());
    for (const double line : {flank - 35, flank - 26, flank + 26, flank + 35}) {
        shell.vLines.push_back(line);
        shell.vLines.push_back(profile->length() - line);
    }
    shell.uLines = {-0.42 * length - 16, -0.42 * length, 0.18 * length, 0.18 * length + 16};
    shell.openings = {{{0, middle}, {89, 42}, 8},
                      {{binAt(), middle}, {82, 46}, 8},
                      {{leverAt(), middle}, {62, 40}, 4},
                      {{0.42 * length, middle}, {22, 34}, 6}};
    for (const double side : {-1.0, 1.0}) {
        const double w = middle + side * (middle - flank), edge = middle + side * (middle - 11);
        for (int i = 0; i < 4; ++i)
            shell.openings.push_back({{0.36 * length, w + 15.0 * (i - 1.5)}, {30, 4}, 6});
        for (int i = 0; i < 8; ++i)
            shell.openings.push_back({{length * ((i + 0.5) / 8 - 0.5), edge}, {4.5, 4.5}, 2});
    }
    metal.panel("shell", shell);
}

void ConsoleBody::addCups() {
    const double apart = (kTrayHalf + kConsoleSlit) / (1 - design.height / design.screw.radius) + 0.5;
    for (const double s : {-apart, apart}) {
        const Vector3 at(s, 0, topInside() - kDrop);
        const Section tray = ringSection(squareAround(Vector2::Zero(), kTrayHalf, turn()),
                                         circle(Vector2::Zero(), kCupRadius + kConsoleSlit, turn(), M_PI_4));
        // sweep() pulls along x; the tray lies flat, so x becomes up.
        const Piece plate = placed(sweep(tray, {0, design.thinPlate}),
                                   [](const Vector3& p) { return Vector3(p.y(), p.z(), p.x()); });
        metal.part("cup_tray", rigid(plate, at, Vector3::UnitZ()));
        CupShape cup;
        cup.radius = kCupRadius;
        cup.depth = design.innerDepth - kDrop - design.shellThickness;
        metal.part("cup_holder", rigid(turned(cupOutline(cup, 2 * quarter()), turn()),
                                       at + Vector3(0, 0, design.thinPlate), Vector3::UnitZ()));
        // Spring tongues that hold a cup.
        for (int i = 0; i < 3; ++i) {
            const double angle = 2 * M_PI * i / 3 + 0.4;
            const Vector3 beside(s + (kCupRadius + 5) * std::cos(angle), (kCupRadius + 5) * std::sin(angle),
                                 topInside() - kDrop - 24);
            metal.part("cup_spring", level(roundedBox({-4, -4, 0}, {4, 4, 20}, 1.5, 0.8, quarter()), beside));
        }
    }
}

void ConsoleBody::addBin() {
    const double depth = design.innerDepth - design.shellThickness - kDrop - 2;
    metal.part("bin", level(tray({-86, -50, -depth}, {86, 50, 0}, 14, 2.2, quarter()),
                            {binAt(), 0, topInside() - kDrop}));
    PanelShape lid;
    lid.surface = [this](double s, double u) { return design.screw.bend({s, u, design.height - 1.7}); };
    lid.low = {binAt() - 79, -43};
    lid.high = {binAt() + 79, 43};
    lid.thickness = 2.6;
    lid.openings = {{{binAt() + 66, 0}, {4, 16}, 6}};
    metal.panel("bin_lid", lid);
    for (const double u : {-28.0, 28.0}) {
        const Line pin{design.screw.bend({binAt() - 76, u - 9, topInside() - 9}),
                       design.screw.bend({binAt() - 76, u + 9, topInside() - 9})};
        metal.part("lid_hinge", rod(pin, 3.2, turn()));
    }
}

void ConsoleBody::addLever() {
    PanelShape gate;
    gate.surface = [](double x, double y) { return Vector3(x, y, 0); };
    gate.low = {-70, -48};
    gate.high = {70, 48};
    gate.thickness = 2.2;
    gate.openings = {{{-20, 0}, {26, 7}, 6}, {{34, 0}, {18, 7}, 6}, {{0, 30}, {40, 4}, 6}};
    for (const double x : {-60.0, 60.0})
        for (const double y : {-38.0, 38.0}) gate.openings.push_back({{x, y}, {3, 3}, 2});
    metal.part("lever_gate", level(Panel(gate, {metal.detail().step, 3}).piece(),
                                   {leverAt(), 0, topInside() - kDrop - 1.2}));
    const double top = topInside() - kDrop - 6, bottom = lowest() + 4;
    Line down;
    const int rings = 5, each = 2 * quarter();
    for (int i = 0; i <= rings * each; ++i) down.push_back({0, 0, top + (bottom - top) * i / (rings * each)});
    const double pitch = (top - bottom) / rings;
    const auto bellows = [=](double at) { return 24 + 0.2 * at - 4 * std::cos(2 * M_PI * at / pitch); };
    metal.part("lever_boot", level(variedRod(down, bellows, turn()), {leverAt(), 0, 0}));
    for (const double x : {-52.0, 52.0}) {
        const Piece block = roundedBox({-8, -40, -16}, {8, 40, 0}, 3, 1.5, quarter());
        metal.part("gate_bracket", level(block, {leverAt() + x, 0, topInside() - kDrop - 3}));
    }
}

/// Plates across the console, between the parts that hang from the top.
void ConsoleBody::addWebs() {
    const double ends = design.length / 2;
    for (const double s : {-ends + 18, -118.0, 112.0, leverAt() + 84, ends - 20}) {
        const double low = lowest(), high = topInside() - kConsoleSlit;
        const double inside = design.shellThickness + 3.2, corner = design.topRadius;
        const double lowHalf = design.halfWidthAt(low) - inside;
        const double shoulderHalf = design.halfWidthAt(high - corner) - inside,
                     highHalf = design.topHalfWidth - inside - corner;
        const Polyline right{
            {0, low}, {lowHalf, low}, {shoulderHalf, high - corner}, {highHalf, high}, {0, high}};
        Polyline outline = filleted(right, {8, 0, 0}, quarter());
        for (std::size_t i = outline.size() - 1; i-- > 1;)
            outline.push_back({-outline[i].x(), outline[i].y()});
        metal.part("web", bent(sweep(fullSection(outline), {s, s + design.thinPlate})));
    }
}

/// Ribs up the inside of the flanks, and along under the top beside the hanging parts.
void ConsoleBody::addStiffeners() {
    const int ribs = metal.detail().count(9);
    for (int i = 0; i < ribs; ++i) {
        const double s = design.length * ((i + 0.5) / ribs - 0.5), low = 14, high = topInside() - 44;
        const double off = design.shellThickness + 2.6;
        for (const double side : {-1.0, 1.0}) {
            const double foot = design.halfWidthAt(low) - off, head = design.halfWidthAt(high) - off;
            Polyline outline{{foot - 9, low}, {foot, low}, {head, high}, {head - 13, high}};
            if (side < 0) {
                for (Vector2& p : outline) p.x() = -p.x();
                std::reverse(outline.begin(), outline.end());
            }
            metal.part("flank_rib", bent(sweep(fullSection(outline), {s, s + 1.8})));
        }
    }
    const double ends = design.length / 2;
    for (const double u : {-58.0, 58.0}) {
        const Section bar = rectangleSection({u - 0.9, topInside() - 12}, {u + 0.9, topInside() - 0.4});
        metal.part("top_rib", bent(sweep(bar, stationsBetween(-ends + 24, ends - 26, metal.detail().step))));
    }
}

void ConsoleBody::addBosses() {
    const int rows = std::max(3, metal.detail().count(3));
    for (int i = 0; i < rows; ++i) {
        // Between the lever and the front end.
        const double s = leverAt() + 100 + (design.length / 2 - 45 - leverAt() - 100) * (i + 0.5) / rows;
        BossShape shape;
        shape.radius = random.between(5, 6.5);
        shape.height = random.between(22, design.innerDepth - design.shellThickness - 4);
        shape.foot = 2.5;
        const double u = (i % 2 == 0 ? 1 : -1) * random.between(32, 42);
        metal.part("screw_boss", rigid(turned(bossOutline(shape, quarter()), turn()),
                                       {s, u, topInside() - 2 * kConsoleSlit}, -Vector3::UnitZ()));
    }
    const int pairs = metal.detail().count(3);
    for (int i = 0; i < 2 * pairs; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, width = 12;
        const double s = design.length * ((i / 2 + 0.5) / pairs - 0.5) + 14 + random.between(-6, 6);
        if (std::abs(s) > design.length / 2 - 20) continue;
        // An angle inside the wall: one leg on the wall's foot, the other towards the middle.
        const double wall = design.footHalfWidth - design.shellThickness - 8;
        Polyline line{{wall, 12}, {wall, 40}, {wall - 16, 40}};
        if (side < 0) {
            std::reverse(line.begin(), line.end());
            for (Vector2& p : line) p.x() = -p.x();
        }
        metal.part("clip", bent(sweep(sheetSection(metal.rounded(line, 5), 1.8), {s, s + width})));
        BoltShape screw;
        screw.shank = 2;
        screw.head = 3.6;
        screw.height = 3;
        screw.length = 5;
        metal.part("clip_screw",
                   rigid(bolt(screw, turn()), {s + width / 2, side * (wall - 8), 38.9}, -Vector3::UnitZ()));
    }
}

/// Cables under the top along both sides, with their connectors, and a control unit at the front end.
void ConsoleBody::addHarness() {
    const double ends = design.length / 2;
    for (const double side : {-1.0, 1.0}) {
        for (int i = 0; i < 2; ++i) {
            const double phase = random.between(0, 6);
            Line line;
            for (const double s :
                 stationsBetween(-ends + 30, ends - 30, std::min(2 * metal.detail().step, 24.0))) {
                line.push_back(design.screw.bend({s, side * (66 + 1.5 * std::sin(s / 37 + phase)),
                                                  topInside() - 22 - 8 * i + 2 * std::sin(s / 53 + phase)}));
            }
            metal.part("cable",
                       rod(smooth(line, 0.7 * metal.detail().step), 2.2 + 0.5 * i, std::max(6, turn() / 3)));
        }
        metal.part("connector", level(roundedBox({-13, -8, -7}, {13, 8, 7}, 2, 1, quarter()),
                                      {ends - 70, side * 50, topInside() - 30}));
    }
    metal.part("control_unit", level(roundedBox({-22, -24, -20}, {22, 24, 0}, 5, 2, quarter()),
                                     {ends - 62, 0, topInside() - 16}));
}

/// Blades behind the openings in the flanks.
void ConsoleBody::addVents() {
    for (const double side : {-1.0, 1.0}) {
        for (int i = 0; i < 4; ++i) {
            const double v = 75 + 15 * (i - 1.5), u = design.halfWidthAt(v) - design.shellThickness - 3;
            const Section blade = side > 0
                                      ? sheetSection({{u, v + 4}, {u - 5, v + 2}, {u - 13, v - 1}}, 1.6)
                                      : sheetSection({{-u + 13, v - 1}, {-u + 5, v + 2}, {-u, v + 4}}, 1.6);
            const double s = 0.36 * design.length;
            metal.part("vent_blade",
                       bent(sweep(blade, stationsBetween(s - 34, s + 34, metal.detail().step))));
        }
    }
}

/// Studs in rows under the top, along both sides.
void ConsoleBody::addStuds(int studs) {
    const Piece dome = turned(domeOutline(2, 2.2, 2), 12);
    for (int i = 0; i < studs; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const double s = (design.length - 70) * (((i / 2 % 130) + 0.5) / 130 - 0.5);
        const double u = side * (52.5 - 4.6 * (i / 260 % 3));
        metal.part("stud", rigid(dome, {s, u, topInside() - 2 * kConsoleSlit}, -Vector3::UnitZ()));
    }
}

}  // namespace

SheetMetal buildConsoleBody(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs,
                            bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    ConsoleBody body{design, metal, random};
    body.addShell();
    body.addCups();
    body.addBin();
    body.addLever();
    body.addWebs();
    body.addStiffeners();
    body.addBosses();
    body.addHarness();
    body.addVents();
    body.addStuds(studs);
    return metal;
}

}  // namespace clearway::scenes
