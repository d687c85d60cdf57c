#include "demos/scenes/roof_slot.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kRoofSlotLeastClearance = 1,
                 kRoofSlotMostClearance = 12;  // mm; with more, the slot reaches the sides

/// Extra gap beyond the clearance, as a share of it: sampling planners need some room.
constexpr double kRoofSlotEase = 0.1;

constexpr double kLongestCell = 88;  // mm along the roof
constexpr double kStretch = 1.2;     // of cells beside openings, as a factor
constexpr double kChord = 40;        // mm between two states along the roof
constexpr double kRoofSlotRounding =
    0.02;                           // mm; covers rounding to float, and normals at the profile's corners
constexpr double kHalfWidth = 620;  // of the profile

constexpr double kBeads[] = {-360, -240, -120, 0, 120, 240, 360};
constexpr double kBeadHalf = 20, kBeadFlank = 16, kBeadRounding = 11;
constexpr double kEmbossingPitch = 44;

/// The greatest distance between a circle of that radius and its chord.
double sagitta(double chord, double radius) {
    return std::pow(chord, 2) / (8 * radius);
}

/// The number of chords of each of the beads' roundings: as many as the coarser mesh has room for.
int roundingChords(const SceneOptions& options) {
    const std::size_t room = std::min(options.partTriangles, options.environmentTriangles / 4);
    return room < 12000 ? 0 : room < 50000 ? 1 : 3;
}

Polyline profileOf(double crown, double depth, int chords) {
    Polyline line;
    std::vector<double> radii;
    const auto add = [&](double v, double below, double radius) {
        line.push_back({v, -crown * std::pow(v / kHalfWidth, 2) - below});
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

constexpr double kRoofSlotSheet = 0.8;  // mm, thickness
constexpr double kRoofSlotRoom = 24;    // height of the room between the sheets
constexpr double kLowerMore = 0.5;      // mm; extra distance of the lower sheet from the facing one
constexpr double kInset = 14;           // distance of the parts between the sheets from the sheets' edges
constexpr double kRoofSlotSlit = 0.3;   // between neighbours
constexpr double kOpenFrom = 1760, kOpenTo = 2150, kOpenHalf = 210;  // the opening, along and across

struct Tray {
    const RoofSlot& roof;
    SheetMetal& metal;
    Random& random;

    /// Places a piece whose x is u, y is v and z the height above the room's floor.
    Placement inside() const {
        return [this](const Vector3& p) -> Vector3 {
            return roof.smoothAt(p.x(), p.y(), roof.lower, roof.gap / 2 + 12 + p.z());
        };
    }
    void add(const std::string& stem, const Piece& piece) { metal.part(stem, placed(piece, inside())); }
    int quarter() const { return metal.detail().segmentsPerQuarter; }
    int turn() const { return metal.detail().segmentsPerTurn; }
    double step() const { return std::min(metal.detail().step, 80.0); }
    std::vector<double> along(double from, double to) const { return stationsBetween(from, to, step()); }
    double front() const { return roof.trayFront + kInset; }
    double rear() const { return roof.trayRear - kInset; }
    double half() const { return roof.trayHalf - kInset; }

    void addSheet(bool isUpper);
    void addFrame();
    void addCrossBeams();
    void addRibs();
    void addGuides();
    void addCables();
    void addMotor();
    void addBosses();
    void addBolt(double u, double v, double height);
    void addStuds(int studs);
};

/// A sheet of the tray, embossed inwards, with the opening and, in the lower one, lightening holes.
void Tray::addSheet(bool isUpper) {
    PanelShape shape;
    const double side = isUpper ? -1 : 1, depth = isUpper ? roof.upper : roof.lower;
    const double away = roof.gap / 2 + kRoofSlotSheet / 2 + (isUpper ? 0 : kLowerMore);
    shape.surface = [this, side, depth, away](double u, double v) {
        return roof.at(u, v, depth, side * (away + roof.embossed(u, v) + roof.receding(u, v)));
    };
    shape.low = {roof.trayFront, -roof.trayHalf};
    shape.high = {roof.trayRear, roof.trayHalf};
    shape.thickness = kRoofSlotSheet;
    shape.openings = {{{(kOpenFrom + kOpenTo) / 2, 0}, {(kOpenTo - kOpenFrom) / 2, kOpenHalf}, 1e6}};
    for (const double u : {1650.0, 2240.0, 2380.0}) {
        for (const double v : {-300.0, -180.0, -60.0, 60.0, 180.0, 300.0}) {
            if (!isUpper || u > 2300) shape.openings.push_back({{u, v}, {12, 12}, 2});
        }
    }
    for (const double v : {-300.0, 300.0}) {
        for (const double u : {1780.0, 1950.0, 2120.0}) shape.openings.push_back({{u, v}, {28, 12}, 4});
    }
    shape.keptULines = roof.keptULines;
    for (const Vector2& p : roof.profile) shape.keptVLines.push_back(p.x());
    metal.panel(isUpper ? "upper_sheet" : "lower_sheet", shape);
}

/// Hollow bars around the opening.
void Tray::addFrame() {
    const auto hollow = [&](const Vector2& low, const Vector2& high) {
        return ringSection(
            roundedRectangle(low, high, 4, quarter()),
            roundedRectangle(low + Vector2(1.5, 1.5), high - Vector2(1.5, 1.5), 2.5, quarter()));
    };
    for (const double side : {-1.0, 1.0}) {
        const double v = side * (kOpenHalf + 26);
        add("frame",
            sweep(hollow({v - 14, 1}, {v + 14, kRoofSlotRoom - 2}), along(kOpenFrom - 34, kOpenTo + 34)));
    }
    for (const double u : {kOpenFrom - 20, kOpenTo + 20}) {
        add("frame", sweepAlongY(hollow({u - 12, 1}, {u + 12, kRoofSlotRoom - 9}),
                                 along(-kOpenHalf - 10, kOpenHalf + 10)));
    }
    // A seal on the front and the rear bar.
    for (const double u : {kOpenFrom - 20, kOpenTo + 20}) {
        const Polyline bulb = circle({u, kRoofSlotRoom - 9 + 3.1 + kRoofSlotSlit}, 3, turn());
        add("seal", sweepAlongY(fullSection(bulb), along(-kOpenHalf, kOpenHalf)));
    }
}

void Tray::addCrossBeams() {
    for (const double u : {1660.0, 2230.0, 2410.0}) {
        Polyline hat = hatLine(34, 17, 14);
        for (Vector2& p : hat) p += Vector2(u, 1.5);
        add("cross_beam", sweepAlongY(sheetSection(metal.rounded(hat, 4), 1.2), along(-370, 370)));
        const int bolts = std::max(2, metal.detail().count(4));
        for (int i = 0; i < bolts; ++i) {
            const double v = 340 * (2.0 * i / (bolts - 1) - 1);
            addBolt(u - 27, v, 2.4);
            addBolt(u + 27, v, 2.4);
        }
    }
}

void Tray::addBolt(double u, double v, double height) {
    BoltShape shape;
    shape.shank = 2;
    shape.length = 3;
    shape.head = 4;
    shape.height = 4;
    const Placement standing = standingAt({u, v, height}, Vector3::UnitZ(), random.between(0, M_PI));
    add("bolt", placed(bolt(shape, turn()), standing));
}

/// Upright plates along the tray with lightening holes.
void Tray::addRibs() {
    const int pairs = metal.detail().count(1);
    for (int i = 0; i < 2 * pairs; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, v = side * (270 + 90 * (i / 2 + 0.5) / pairs);
        const std::vector<double> us = stationsBetween(1700, 2180, std::max(20.0, 0.5 * step()));
        const double radius = 0.3 * std::min(us[1] - us[0], kRoofSlotRoom - 3);
        const auto hole = [radius](std::size_t column, std::size_t) {
            return column % 2 == 1 ? radius : 0.0;
        };
        add("rib", sweepAlongY(holedSection(us, {1.0, kRoofSlotRoom - 1}, hole, turn()), {v - 0.8, v + 0.8}));
    }
}

/// Channels at both sides, open to the inside, with a rail in each.
void Tray::addGuides() {
    for (const double side : {-1.0, 1.0}) {
        const double outer = side * half(), inner = side * (half() - 26);
        Polyline channel{{inner, kRoofSlotRoom - 1}, {outer, kRoofSlotRoom - 1}, {outer, 1}, {inner, 1}};
        if (side > 0) std::reverse(channel.begin(), channel.end());
        add("guide", sweep(sheetSection(metal.rounded(channel, 4), 1.4), along(front(), rear())));
        const double v = side * (half() - 14);
        add("rail", sweep(fullSection(roundedRectangle({v - 5, 6}, {v + 5, 17}, 2, quarter())),
                          along(front() + 20, rear() - 60)));
        for (const double u : {1700.0, 1930.0, 2160.0, 2390.0}) {
            const double w = side * (half() - 32);
            add("shoe", roundedBox({u - 22, w - 4, 4}, {u + 22, w + 4, kRoofSlotRoom - 4}, 3, 2, quarter()));
        }
    }
}

/// Helical drive cables that run from the motor to both sides, drain hoses and the motor's own cable.
void Tray::addCables() {
    const double fine = std::max(3.0, 0.5 * metal.detail().step);
    for (const double side : {-1.0, 1.0}) {
        const double v = side * (half() - 42);
        const Line drive = smooth({{2338, side > 0 ? 60.0 : -100.0, 12},
                                   {2345, side * 170, 12},
                                   {2335, side * 330, 12},
                                   {2290, v, 12},
                                   {2140, v, 12},
                                   {1900, v, 12},
                                   {1690, v, 12}},
                                  fine);
        const double pitch = 7 / std::sqrt(metal.detail().richness);
        add("drive_cable",
            variedRod(
                drive, [pitch](double at) { return 2.6 + 0.5 * std::sin(2 * M_PI * at / pitch); },
                turn() / 2));
        const Line drain = smooth({{front() + 12, side * 230, 12},
                                   {front() + 12, side * 330, 10},
                                   {front() + 14, side * 372, 12},
                                   {1660, side * 384, 12}},
                                  fine);
        add("drain_hose", pipe(drain, 5, 1.2, turn()));
    }
    add("motor_cable", rod(smooth({{2330, 44, 16}, {2300, 90, 13}, {2290, 180, 15}, {2275, 250, 12}}, fine),
                           2.4, turn() / 2));
    add("plug", roundedBox({2262, 254, 5}, {2284, 276, 19}, 3, 2, quarter()));
}

void Tray::addMotor() {
    const Polyline can =
        filleted({{0, 0}, {10.5, 0}, {10.5, 62}, {6, 66}, {6, 76}, {0, 76}}, {2, 3, 2, 1}, quarter());
    add("motor", placed(turned(can, turn()), standingAt({2322, -6, 12}, -Vector3::UnitY())));
    add("gear_box", roundedBox({2296, 0, 1}, {2352, 40, kRoofSlotRoom - 1}, 8, 3, quarter()));
    add("control_unit", roundedBox({2286, -330, 2}, {2316, -270, 18}, 5, 2, quarter()));
    for (int i = 0; i < 4; ++i) addBolt(2300 + 48 * (i % 2), 6 + 28 * (i / 2), kRoofSlotRoom - 6.0);
}

/// Screw bosses on the lower sheet's side, along the frame.
void Tray::addBosses() {
    const int bosses = metal.detail().count(6);
    for (int i = 0; i < bosses; ++i) {
        for (const double side : {-1.0, 1.0}) {
            BossShape shape;
            shape.radius = random.between(4, 5);
            shape.height = random.between(10, 18);
            shape.foot = 2;
            shape.rounding = 1;
            shape.pad = 1.5;
            const double u = 1780 + 350 * (i + 0.5) / bosses;
            add("boss", placed(turned(bossOutline(shape, quarter()), turn()),
                               standingAt({u, side * 258, 0.5}, Vector3::UnitZ())));
        }
    }
}

/// Spot welds in rows, in front of the opening.
void Tray::addStuds(int studs) {
    const Piece dome = turned(domeOutline(2, 1.6, quarter()), turn());
    constexpr int kColumns = 84, kRows = 4;
    for (int i = 0; i < studs; ++i) {
        const double v = 6 * (i % kColumns - 0.5 * (kColumns - 1)), u = 1702 + 6 * (i / kColumns % kRows);
        add("spot_weld", placed(dome, standingAt({u, v, 0.8}, Vector3::UnitZ())));
    }
}

}  // namespace

RoofSlot designRoofSlot(const SceneOptions& options) {
    requireClearance(options.clearance, kRoofSlotLeastClearance, kRoofSlotMostClearance);
    Random random(options.seed);
    RoofSlot roof;
    roof.clearance = options.clearance;
    roof.radius = random.between(6700, 7300);
    roof.crown = random.between(38, 50);
    roof.beadDepth = random.between(5, 7.5);
    // Sheets are cut into chords, so that one of two facing sheets comes nearer and the other recedes. The
    // path's chords come nearer, too.
    const double chords =
        sagitta(kStretch * kLongestCell, 0.97 * roof.radius) + sagitta(kChord, 0.97 * roof.radius);
    roof.gap = roof.clearance * (1 + kRoofSlotEase) + chords + kRoofSlotRounding;
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
    const double angle = (u - middle) / radius,
                 r = radius - depth + height - crown * std::pow(v / kHalfWidth, 2);
    return {middle + r * std::sin(angle), v, top - radius + r * std::cos(angle)};
}

double RoofSlot::embossed(double u, double v) const {
    const double turn = 2 * M_PI / kEmbossingPitch;
    return embossing * smoothStep(std::sin(turn * u) * std::sin(turn * v), 0.25, 0.7);
}

/// The sheets are bowed in both directions: if they were equally near everywhere, all pairs of triangles
/// would be the nearest.
double RoofSlot::receding(double u, double v) const {
    const double most = 1.8 + 0.17 * gap;
    return most * (std::pow((u - 1690) / (trayRear - trayFront), 2) + std::pow(v / trayHalf, 2));
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
    // Then the tray is lifted and levelled, so that it passes above the car's rear.
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

SheetMetal buildRoofTray(const RoofSlot& roof, const Detail& detail, Random random, int studs,
                         bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    Tray tray{roof, metal, random};
    tray.addSheet(true);
    tray.addSheet(false);
    tray.addFrame();
    tray.addCrossBeams();
    tray.addRibs();
    tray.addGuides();
    tray.addCables();
    tray.addMotor();
    tray.addBosses();
    tray.addStuds(studs);
    return metal;
}

}  // namespace clearway::scenes
