// The console: a shell in three lengths with flanges, two cup holders in trays, webs, screw bosses and clips.
#include <algorithm>
#include <cmath>

#include "program/scenes/random.h"
#include "program/scenes/solids.h"
#include "program/scenes/tunnel_console.h"

namespace clearway::scenes {

namespace {

constexpr double kSlit = 0.2;  // mm between components, so that no two touch
constexpr int kCups = 2;
constexpr double kTrayHalf = 46;
constexpr double kTrayDrop = 3;  // the trays lie this much below the top
constexpr double kCupRadius = 38;

struct Builder {
    const TunnelConsoleDesign& design;
    const Detail& detail;
    Random random;
    Assembly assembly{};

    double topInside() const { return design.height - design.shellThickness; }

    Piece bent(const Piece& piece) const {
        return placed(piece, [this](const Vector3& p) { return design.screw.bend(p); });
    }
    Piece rigid(const Piece& piece, const Vector3& at, const Vector3& axis) const {
        return placed(placed(piece, standingAt(Vector3::Zero(), axis)), rigidAt(design.screw, at));
    }
    Piece swept(const Section& section, double from, double to) const {
        return bent(sweep(section, stationsBetween(from, to, detail.step)));
    }

    double trayLength() const;
    void addShell();
    void addCup(double s);
    void addWeb(double s);
    void addScrewBosses();
    void addClips();
    void addStuds(int studs);
};

/// A tray lies where the sweep is shorter than at v = 0.
double Builder::trayLength() const {
    return (2 * kTrayHalf + kSlit) / (1 - design.height / design.screw.radius) + 1;
}

void Builder::addShell() {
    const double half = design.shellThickness / 2, top = design.height - half;
    // The middle line leans: beside it the sheet must not reach beyond halfWidthAt().
    const double foot = design.footHalfWidth - half, head = design.topHalfWidth - half;
    const Polyline hat{{design.flangeHalfWidth, half}, {foot, half}, {head, top}, {-head, top}, {-foot, half},
                       {-design.flangeHalfWidth, half}};
    const Section shell =
        sheetSection(filleted(hat, {design.footRadius, design.topRadius, design.topRadius, design.footRadius},
                              detail.segmentsPerQuarter),
                     design.shellThickness);
    const double ends = design.length / 2, trays = kCups * trayLength() / 2;
    assembly.add("shell_rear", swept(shell, -ends, -trays - kSlit));
    assembly.add("shell_front", swept(shell, trays + kSlit, ends));

    const Polyline right{hat[0], hat[1], hat[2], {kTrayHalf + kSlit, top}};
    const Polyline left{{-kTrayHalf - kSlit, top}, hat[3], hat[4], hat[5]};
    const auto rail = [&](const Polyline& line, double first, double second) {
        return swept(
            sheetSection(filleted(line, {first, second}, detail.segmentsPerQuarter), design.shellThickness),
            -trays, trays);
    };
    assembly.add("rail_right", rail(right, design.footRadius, design.topRadius));
    assembly.add("rail_left", rail(left, design.topRadius, design.footRadius));
}

void Builder::addCup(double s) {
    const Vector3 at(s, 0, topInside() - kTrayDrop);
    const int n = detail.segmentsPerTurn;
    const Section tray = ringSection(squareAround(Vector2::Zero(), kTrayHalf, n),
                                     circle(Vector2::Zero(), kCupRadius + kSlit, n, M_PI_4));
    // sweep() pulls along x; the tray lies flat, so its x becomes up.
    const Piece plate = placed(sweep(tray, {0, design.thinPlate}),
                               [](const Vector3& p) { return Vector3(p.y(), p.z(), p.x()); });
    assembly.addNumbered("cup_tray", rigid(plate, at, Vector3::UnitZ()));
    CupShape cup;
    cup.radius = kCupRadius;
    cup.depth = design.innerDepth - kTrayDrop - design.shellThickness;
    const Piece holder = turned(cupOutline(cup, detail.segmentsPerQuarter), n);
    assembly.addNumbered("cup_holder", rigid(holder, at + Vector3(0, 0, design.thinPlate), Vector3::UnitZ()));
}

void Builder::addWeb(double s) {
    const double low = design.height - design.innerDepth, high = topInside() - kSlit;
    const double inside = design.shellThickness + 1;
    const double corner = design.topRadius;
    const double lowHalf = design.halfWidthAt(low) - inside;
    const double shoulderHalf = design.halfWidthAt(high - corner) - inside,
                 highHalf = design.topHalfWidth - inside - corner;
    const Polyline right{
        {0, low}, {lowHalf, low}, {shoulderHalf, high - corner}, {highHalf, high}, {0, high}};
    Polyline outline = filleted(right, {8, 0, 0}, detail.segmentsPerQuarter);
    for (std::size_t i = outline.size() - 1; i-- > 1;) outline.push_back({-outline[i].x(), outline[i].y()});
    assembly.addNumbered("web", bent(sweep(fullSection(outline), {s, s + design.thinPlate})));
}

void Builder::addScrewBosses() {
    const int rows = std::max(2, static_cast<int>(std::lround(2 * detail.richness)));
    const double from = kCups * trayLength() / 2 + 40, to = design.length / 2 - 40;
    for (int row = 0; row < rows; ++row) {
        const int end = row % 2 == 0 ? -1 : 1;
        const double along = rows > 2 ? static_cast<double>(row / 2) / ((rows + 1) / 2) : 0.5;
        const double s = end * (from + (to - from) * along + random.between(-8, 8));
        BossShape shape;
        shape.radius = random.between(6, 8);
        shape.height = random.between(30, design.innerDepth - design.shellThickness);
        const Piece boss = turned(bossOutline(shape, detail.segmentsPerQuarter), detail.segmentsPerTurn);
        const double u = (row / 2 % 2 == 0 ? 1 : -1) * random.between(36, 42);
        assembly.addNumbered("screw_boss", rigid(boss, {s, u, topInside() - 2 * kSlit}, -Vector3::UnitZ()));
    }
}

void Builder::addClips() {
    const int pairs = std::max(1, static_cast<int>(std::lround(2 * detail.richness)));
    for (int i = 0; i < 2 * pairs; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, width = 14;
        const double s =
            -design.length / 2 + design.length * (i / 2 + 0.5) / pairs + random.between(-15, 15) - width / 2;
        // An angle inside the wall: it lies on the wall's foot and points to the middle.
        const double wall = design.footHalfWidth - design.shellThickness - 6;
        Polyline line{{wall, 12}, {wall, 40}, {wall - 18, 40}};
        if (side < 0) {
            std::reverse(line.begin(), line.end());
            for (Vector2& p : line) p.x() = -p.x();
        }
        const Section angle = sheetSection(filleted(line, {5}, detail.segmentsPerQuarter), 1.8);
        assembly.addNumbered("clip", bent(sweep(angle, {s, s + width})));
    }
}

void Builder::addStuds(int studs) {
    const Piece dome = turned(domeOutline(3, 2.5, detail.segmentsPerQuarter), detail.segmentsPerTurn);
    const double from = kCups * trayLength() / 2 + 12, to = design.length / 2 - 12;
    for (int i = 0; i < studs; ++i) {
        const int end = i % 2 == 0 ? -1 : 1;
        const double s = end * (from + (to - from) * ((i / 2 % 40) + 0.5) / 40);
        const double u = 9.0 * ((i / 80) % 7 - 3);
        assembly.addNumbered("stud", rigid(dome, {s, u, topInside() - 2 * kSlit}, -Vector3::UnitZ()));
    }
}

}  // namespace

Assembly buildConsole(const TunnelConsoleDesign& design, const Detail& detail, Random random, int studs) {
    Builder builder{design, detail, random};
    builder.addShell();
    for (int i = 0; i < kCups; ++i) builder.addCup((i - (kCups - 1) / 2.0) * builder.trayLength());
    const double trays = kCups * builder.trayLength() / 2, ends = design.length / 2;
    for (const double s : {-ends + 18, -trays - 14, trays + 12, ends - 20}) builder.addWeb(s);
    builder.addScrewBosses();
    builder.addClips();
    builder.addStuds(studs);
    return builder.assembly;
}

}  // namespace clearway::scenes
