// The scene large-environment: the roof between its skin and its lining, around the slot of the
// tray, and the car body below it.
#include <algorithm>
#include <cmath>

#include "demos/scenes/car_body.h"
#include "demos/scenes/instrument_carrier.h"
#include "demos/scenes/roof_slot.h"
#include "demos/scenes/scenes.h"

namespace clearway::scenes {

namespace {

constexpr double kLargeEnvironmentSheet = 0.7;  // mm; thickness of the facing sheet above
constexpr double kLining = 1.2;                 // mm; thickness of the facing sheet below
constexpr double kFinerThan = 1.2;  // factor by which the facing sheets' grids are finer than others

struct Layers {
    const RoofSlot& roof;
    SheetMetal& metal;
    Random& random;

    /// Places a piece whose x is u, y is v and z the height above the skin, without the crown.
    Placement below() const {
        return [this](const Vector3& p) -> Vector3 { return roof.smoothAt(p.x(), p.y(), 0, p.z()); };
    }
    void add(const std::string& stem, const Piece& piece) { metal.part(stem, placed(piece, below())); }
    int quarter() const { return metal.detail().segmentsPerQuarter; }
    int turn() const { return metal.detail().segmentsPerTurn; }
    std::vector<double> cut(double from, double to) const {
        return stationsBetween(from, to, std::min(metal.detail().step, 100.0));
    }
    std::vector<double> profileLines() const {
        std::vector<double> lines;
        for (const Vector2& p : roof.profile) lines.push_back(p.x());
        return lines;
    }
    double liningDepth() const { return roof.lower + roof.gap / 2 + kLining + roof.embossing; }

    void addFacing(bool isAbove);
    void addSkin();
    void addBows();
    void addSides();
    void addLiningLayers();
    void addLines();
    void addTrim();
};

/// The sheets nearest to the tray, embossed away from it, with lightening holes.
void Layers::addFacing(bool isAbove) {
    const double side = isAbove ? 1 : -1, thickness = isAbove ? kLargeEnvironmentSheet : kLining;
    const double depth = isAbove ? roof.upper : roof.lower;
    PanelShape shape;
    shape.surface = [this, side, depth, thickness](double u, double v) {
        return roof.at(u, v, depth, side * (roof.gap / 2 + thickness / 2 + roof.embossed(u, v)));
    };
    shape.low = {roof.slotFront, -roof.slotHalf};
    shape.high = {roof.slotRear, roof.slotHalf};
    shape.thickness = thickness;
    for (const double u : {1560.0, 1900.0, 2240.0, 2580.0, 2860.0}) {
        for (const double v : {-424.0, -300.0, -180.0, -60.0, 60.0, 180.0, 300.0, 424.0}) {
            shape.openings.push_back({{u, v}, {isAbove ? 18.0 : 12.0, 12}, 2});
        }
    }
    shape.keptULines = roof.keptULines;
    shape.keptVLines = profileLines();
    shape.finer = kFinerThan;
    metal.panel(isAbove ? "roof_inner_sheet" : "lining_carrier", shape);
}

void Layers::addSkin() {
    const auto surface = [this](double depth) {
        return [this, depth](double u, double v) { return roof.at(u, v, depth, 0); };
    };
    const std::vector<double> lines = profileLines();
    metal.panel("roof_skin",
                {surface(0), {1470, -600}, {2960, 600}, 0.8, 0, {}, {}, {}, roof.keptULines, lines});
    const double bows[] = {1690, 1950, 2210, 2470, 2730};
    for (int i = 0; i < 4; ++i) {
        metal.panel("roof_damping_" + std::to_string(i + 1), {surface(2.6),
                                                              {bows[i] + 60, -500},
                                                              {bows[i + 1] - 60, 500},
                                                              2,
                                                              0,
                                                              {},
                                                              {},
                                                              {},
                                                              roof.keptULines,
                                                              lines});
    }
    const auto smooth = [this](double depth) {
        return [this, depth](double u, double v) { return roof.smoothAt(u, v, depth, 0); };
    };
    std::vector<Opening> front, rear;
    for (const double v : {-450.0, -300.0, -150.0, 0.0, 150.0, 300.0, 450.0}) {
        front.push_back({{1525, v}, {14, 22}, 4});
        rear.push_back({{2912, v}, {12, 12}, 2});
    }
    metal.panel("front_header", {smooth(16), {1480, -560}, {1570, 560}, 1, 0, front});
    metal.panel("front_header_inner", {smooth(24), {1485, -550}, {1565, 550}, 1.2, 0, front});
    metal.panel("rear_header", {smooth(16), {2875, -560}, {2950, 560}, 1, 0, rear});
    metal.panel("rear_header_inner", {smooth(24), {2880, -550}, {2945, 550}, 1.2, 0, rear});
}

/// Hat sections across the roof, their flanges up, screwed to the sides.
void Layers::addBows() {
    for (const double u : {1690.0, 1950.0, 2210.0, 2470.0, 2730.0}) {
        Polyline hat = hatLine(44, 20, 16);
        for (Vector2& p : hat) p = {u - p.x(), -12 - p.y()};
        add("roof_bow", sweepAlongY(sheetSection(metal.rounded(hat, 5), 1), cut(-515, 515)));
        const int bolts = std::max(2, metal.detail().count(2));
        for (int i = 0; i < 2 * bolts; ++i) {
            BoltShape shape;
            shape.shank = 2.5;
            shape.length = 2;
            const double v = (i % 2 == 0 ? 1 : -1) * (420 + 90.0 * (i / 2 + 0.5) / bolts);
            add("roof_bolt", placed(bolt(shape, turn()),
                                    standingAt({u, v, -33}, -Vector3::UnitZ(), random.between(0, M_PI))));
        }
    }
}

/// Rails and ditch channels along both edges, and angles that guide the tray sideways.
void Layers::addSides() {
    for (const double side : {-1.0, 1.0}) {
        const int n = quarter();
        add("roof_rail",
            sweep(ringSection(roundedRectangle({side * 578 - 14, -52}, {side * 578 + 14, -22}, 6, n),
                              roundedRectangle({side * 578 - 12, -50}, {side * 578 + 12, -24}, 4, n)),
                  cut(1500, 2900)));
        Polyline ditch{{side * 592, -12}, {side * 604, -12}, {side * 604, -2}, {side * 616, -2}};
        if (side < 0) std::reverse(ditch.begin(), ditch.end());
        add("roof_ditch", sweep(sheetSection(metal.rounded(ditch, 3), 0.9), cut(1480, 2950)));
        const double v = side * (roof.trayHalf + 1.6 * roof.gap + 5), high = -roof.upper - roof.gap / 2 - 6,
                     low = -roof.lower + roof.gap / 2 + 6;
        Polyline angle{{v, low}, {v, high}, {v + side * 22, high}};
        if (side < 0) std::reverse(angle.begin(), angle.end());
        add("side_guide",
            sweep(sheetSection(metal.rounded(angle, 4), 1.5), cut(roof.slotFront + 20, roof.slotRear - 20)));
    }
}

/// Foam and cloth that follow the lining at a distance, with openings for lamps and handles.
void Layers::addLiningLayers() {
    const double depth = liningDepth();
    const std::vector<Opening> openings{{{1640, 0}, {45, 70}, 4},    {{1800, 400}, {30, 25}, 3},
                                        {{1800, -400}, {30, 25}, 3}, {{2500, 400}, {30, 25}, 3},
                                        {{2500, -400}, {30, 25}, 3}, {{2300, 0}, {40, 40}, 2}};
    const auto layer = [&](const std::string& name, double below, double thickness, double half) {
        const auto surface = [this, at = depth + below](double u, double v) { return roof.at(u, v, at, 0); };
        metal.panel(name, {surface,
                           {1515, -half},
                           {2915, half},
                           thickness,
                           0,
                           openings,
                           {},
                           {},
                           roof.keptULines,
                           profileLines()});
    };
    layer("lining_foam", 4, 3.5, 505);
    layer("lining_cloth", 8, 1, 500);
}

void Layers::addLines() {
    const double fine = std::max(6.0, 0.8 * metal.detail().step);
    const double under = -liningDepth() - 18;
    for (const double side : {-1.0, 1.0}) {
        Line bag;
        for (double u = 1520; u <= 2600; u += 120)
            bag.push_back({u, side * 535 + random.between(-1, 1), -70 + random.between(-3, 3)});
        add("airbag", variedRod(
                          smooth(bag, fine), [](double at) { return 10 + 1.2 * std::sin(at / 9); }, turn()));
        Line drain;
        for (double u = 1500; u <= 2900; u += 200)
            drain.push_back({u, side * 531, -36 + random.between(-2, 2)});
        add("drain_hose", pipe(smooth(drain, fine), 5, 1.3, turn()));
        Line harness;
        for (double u = 1530; u <= 2900; u += 120)
            harness.push_back({u, side * 470 + random.between(-8, 8), under + random.between(-2, 2)});
        add("roof_harness", rod(smooth(harness, fine), random.between(3, 4.5), turn()));
        for (double u = 1600; u < 2900; u += 260)
            add("harness_clip", roundedBox({u - 6, side * 490 - 4, under - 2},
                                           {u + 6, side * 490 + 4, under + 6}, 2, 1, quarter()));
    }
}

/// Lamp, sun visors and handles under the lining, and clips in it.
void Layers::addTrim() {
    const double under = -liningDepth() - 16.6;
    add("lamp", roundedBox({1600, -62, under - 22}, {1680, 62, under}, 12, 5, quarter()));
    for (int i = 0; i < 4; ++i)
        add("lamp_rib", roundedBox({1612 + 16.0 * i, -50, under - 26}, {1614 + 16.0 * i, 50, under - 22.3},
                                   0.9, 0.3, quarter()));
    for (const double side : {-1.0, 1.0}) {
        const double v = side * 290;
        add("sun_visor",
            roundedBox({1530, v - 150, under - 22}, {1690, v + 150, under - 6}, 20, 6, quarter()));
        for (const double u : {1800.0, 2500.0}) {
            const Line grip = bent({{u - 85, side * 440, under + 1},
                                    {u - 80, side * 440, under - 30},
                                    {u + 80, side * 440, under - 30},
                                    {u + 85, side * 440, under + 1}},
                                   14, quarter());
            add("grab_handle", rod(grip, 7, turn()));
        }
    }
    const int clips = metal.detail().count(4);
    for (int i = 0; i < 2 * clips; ++i) {
        const double u = 1720 + 1150.0 * (i / 2 + 0.5) / clips, v = i % 2 == 0 ? 350 : -350;
        add("lining_clip", placed(turned(domeOutline(9, 3, quarter()), turn()),
                                  standingAt({u, v, under}, -Vector3::UnitZ())));
    }
}

void addRoofLayers(const RoofSlot& roof, SheetMetal& metal, Random& random) {
    Layers layers{roof, metal, random};
    layers.addFacing(true);
    layers.addFacing(false);
    layers.addSkin();
    layers.addBows();
    layers.addSides();
    layers.addLiningLayers();
    layers.addLines();
    layers.addTrim();
}

constexpr double kThinnestSheet = 0.7;         // mm
constexpr double kLargeEnvironmentRoom = 150;  // mm around the path's positions that planners may use

constexpr FinenessRange kLargeEnvironmentFineness{120, 0.15};

/// The car body, with the instrument carrier in its place.
SheetMetal buildBody(const CarBody& body, const RoofSlot& roof, const Detail& detail, Random random,
                     int studs, bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    addRoofLayers(roof, metal, random);
    addFloor(body, metal, random);
    addUnderbody(body, metal);
    addSides(body, metal, random);
    addDash(body, metal, random);
    addMountings(body, metal);
    addFrontEnd(body, metal, random);
    addRear(body, metal, random);
    addFittings(body, metal, random);
    metal.include("carrier_", buildInstrumentCarrier(body, detail, random, 0, onlyCount));
    addFloorStuds(body, metal, studs);
    return metal;
}

}  // namespace

GeneratedScene makeLargeEnvironment2(const SceneOptions& options) {
    const CarBody body = designCarBody(options.seed, options.clearance);
    const RoofSlot roof = designRoofSlot(options);
    const Random partRandom(options.seed ^ 0x700F7Au), bodyRandom(options.seed ^ 0xB0D2u);
    GeneratedScene scene;
    scene.name = "large-environment";
    scene.part = sheetMetalTo(options.partTriangles, "part-triangles", kLargeEnvironmentFineness,
                              {"upper_sheet", "lower_sheet", "spot_weld"},
                              [&](const Detail& detail, int studs, bool onlyCount) {
                                  return buildRoofTray(roof, detail, partRandom, studs, onlyCount);
                              });
    scene.environment =
        sheetMetalTo(options.environmentTriangles, "environment-triangles", kLargeEnvironmentFineness,
                     {"roof_inner_sheet", "lining_carrier", "side_guide", "stud"},
                     [&](const Detail& detail, int studs, bool onlyCount) {
                         return buildBody(body, roof, detail, bodyRandom, studs, onlyCount);
                     });
    scene.path = roof.path();
    statePathAsProblem(scene, kLargeEnvironmentRoom);
    scene.problem.name = "large-environment v2";
    scene.problem.fineness = kThinnestSheet / 2;
    return scene;
}

}  // namespace clearway::scenes
