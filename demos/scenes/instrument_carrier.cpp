#include "demos/scenes/instrument_carrier.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kSkinHalf = 531;
constexpr double kVents[] = {-455, -90, 90, 455};   // y
constexpr double kVentAt = 425, kGloveBoxAt = 545;  // along the skin's profile
constexpr double kGloveBoxY = 330;
constexpr double kBeamX = 1190, kBeamZ = 800, kBeamRadius = 26;

/// The skin's profile: from the lip at the windscreen over the top and the face to the edge under the knees.
Spine skinProfile() {
    return Spine::through(
        {{968, 0, 948}, {1000, 0, 961}, {1215, 0, 942}, {1312, 0, 850}, {1300, 0, 640}, {1228, 0, 572}}, 55,
        Vector3::UnitY());
}

/// The carrier's skin: u goes along the profile, v is y; the upper side is the visible one.
struct Skin {
    Spine profile = skinProfile();

    Vector3 at(double u, double v) const {
        Vector3 point = profile.frameAt(u).translation;
        const double rear = smoothStep(point.x(), 980, 1290);
        point.x() -= 22 * rear * (v / kSkinHalf) * (v / kSkinHalf);        // bowed
        point.x() -= 9 * beadAt(v, 0, 120, 50) * smoothStep(u, 330, 400);  // the middle console's field
        const double hood = beadAt(v, -320, 110, 60) * beadAt(u, 190, 55, 60);
        point.z() += 26 * hood;  // over the instruments
        return {point.x(), v, point.z()};
    }
};

struct Carrier {
    const CarBody& body;
    SheetMetal& metal;
    Random& random;
    Skin skin{};

    std::function<Vector3(double, double)> surface() const {
        return [this](double u, double v) { return skin.at(u, v); };
    }
    double skinLength() const { return skin.profile.length(); }

    void addSkin();
    void addRibs();
    void addBeam();
    void addEnds();
    void addMountingPlates();
    void addLegs();
    void addDucts();
    void addGloveBox();
    void addBosses();
    void addStuds(int studs);
};

void Carrier::addSkin() {
    const double length = skinLength();
    std::vector<Opening> openings;
    for (const double y : kVents) openings.push_back({{kVentAt, y}, {24, 48}, 4});
    openings.push_back({{kGloveBoxAt, kGloveBoxY}, {45, 108}, 8});
    openings.push_back({{540, 60}, {20, 60}, 4});
    for (const double v : {-470.0, 470.0}) openings.push_back({{150, v}, {34, 34}, 2});
    for (const double v : {-60.0, 100.0, 260.0})
        openings.push_back({{60, v}, {9, 62}, 6});  // for the windscreen
    metal.panel("skin", {surface(),
                         {0, -kSkinHalf},
                         {length, kSkinHalf},
                         2.6,
                         0,
                         openings,
                         {75, 135, 245, 305, 330, 365, 400},
                         {-170, -145, -120, 120, 145, 170, -150, -210, -430, -490}});
    const auto layer = [&](const std::string& name, const Vector2& low, const Vector2& high, double offset,
                           double thickness) {
        metal.panel(name, {surface(), low, high, thickness, offset, {}, {}, {}});
    };
    layer("skin_reinforcement_top", {90, -140}, {235, 440}, -4.5, 1.8);
    layer("skin_foam_top", {95, -130}, {230, 430}, -9, 4);
    layer("skin_reinforcement_knee_left", {500, -500}, {length - 40, -150}, -4.5, 1.8);
    layer("skin_reinforcement_knee_right", {600, 150}, {length - 40, 500}, -4.5, 1.8);
}

/// Plates that follow the skin's back, under the top on both sides and at the driver's knees.
void Carrier::addRibs() {
    const Vector2 middle(-1150, 760);
    // In these places neither the skin's bow nor its field is deep enough to reach the ribs.
    const auto rib = [&](const std::string& name, double y, double from, double to) {
        const int n = std::max(6, static_cast<int>((to - from) / metal.detail().step));
        Polyline outer, inner;
        for (int k = 0; k <= n; ++k) {
            const Vector3 point = skin.profile.frameAt(from + (to - from) * k / n).translation;
            const Vector2 at(-point.x(), point.z()), in = (middle - at).normalized();
            outer.push_back(at + 30 * in);
            inner.push_back(at + (54 + 4 * std::cos(k * 0.9)) * in);
        }
        metal.beam(name, across(y - 1.1, y + 1.1), bandSection(inner, outer));
    };
    const int pairs = metal.detail().count(1);
    for (int i = 0; i < pairs; ++i) {
        const double y = 225 + 200 * (i + 0.5) / pairs;
        const std::string number = std::to_string(i + 1);
        metal.onBothSides([&] { rib("rib_top_" + number, y, 40, 265); });
        rib("rib_knee_" + number, -225 - 160 * (i + 0.5) / pairs, 500, skinLength() - 10);
    }
}

void Carrier::addBeam() {
    const int n = metal.detail().segmentsPerTurn;
    const auto tube = [&](double outer, double inner) {
        return ringSection(circle({-kBeamX, kBeamZ}, outer, n), circle({-kBeamX, kBeamZ}, inner, n));
    };
    metal.beam("beam", across(-body.carrierHalf + 4, body.carrierHalf - 4),
               tube(kBeamRadius, kBeamRadius - 2));
    for (const double y : {-470.0, -215.0, 215.0, 470.0}) {
        metal.beam("beam_clamp_" + std::to_string(static_cast<int>(y + 500)), across(y - 9, y + 9),
                   tube(kBeamRadius + 3.5, kBeamRadius + 0.5));
    }
    const Line cable{{1140, -500, 805}, {1143, -350, 815}, {1138, -160, 802},
                     {1144, 40, 812},   {1139, 260, 805},  {1141, 500, 812}};
    const double step = std::max(4.0, 0.6 * metal.detail().step);
    metal.part("cable", rod(smooth(cable, step), 6, 2 * metal.detail().segmentsPerQuarter + 4));
}

/// The end plates, whose outer faces are plane.
void Carrier::addEnds() {
    metal.onBothSides([&] {
        PanelShape plate;
        plate.surface = [](double u, double v) { return Vector3(u, 0, v); };  // the upper side faces -y
        plate.thickness = 3;
        plate.offset = -(body.carrierHalf - plate.thickness / 2);
        plate.low = {985, 605};
        plate.high = {1262, 900};
        plate.openings = {{{1120, 690}, {28, 28}, 2}, {{1120, 850}, {20, 20}, 2}, {{1230, 680}, {14, 30}, 4}};
        metal.panel("end_plate", plate);
    });
}

void Carrier::addMountingPlates() {
    for (const double y : {-420.0, -180.0, 180.0, 420.0}) {
        const std::string side = std::to_string(static_cast<int>(y + 500));
        const double front = body.carrierFront;
        PanelShape plate;
        plate.surface = [](double u, double v) { return Vector3(0, u, v); };  // the upper side faces x
        plate.thickness = 3;
        plate.offset = front + 1.5;
        plate.low = {y - 24, 862};
        plate.high = {y + 24, 898};
        metal.panel("mounting_plate_" + side, plate);
        Pose start;
        start.translation = {front + 3.4, y, 880};
        Spine arm(start);
        arm.straight(90);
        const int n = metal.detail().segmentsPerQuarter;
        metal.beam("mounting_arm_" + side, arm,
                   ringSection(roundedRectangle({-14, -9}, {14, 9}, 4, n),
                               roundedRectangle({-12, -7}, {12, 7}, 2, n)));
    }
}

/// The legs, from the beam to the tunnel.
void Carrier::addLegs() {
    for (const double y : {-80.0, 80.0}) {
        const std::string side = y < 0 ? "_left" : "_right";
        const Spine down = Spine::through(
            {{1190, y, kBeamZ - 32}, {1190, y, 640}, {1185, y, body.carrierFoot + 5}}, 80, Vector3::UnitX());
        Polyline channel{{16, 20}, {-16, 20}, {-16, -20}, {16, -20}};
        metal.beam("leg" + side, down, sheetSection(metal.rounded(channel, 5), 2));
        PanelShape foot;
        foot.surface = [](double u, double v) { return Vector3(u, v, 0); };
        foot.thickness = 3;
        foot.offset = body.carrierFoot + 1.5;
        foot.low = {1145, y - 30};
        foot.high = {1225, y + 30};
        foot.openings = {{{1160, y}, {6, 6}, 2}, {{1210, y}, {6, 6}, 2}};
        metal.panel("foot" + side, foot);
        for (const double z : {520.0, 600.0}) {
            if (y > 0) continue;
            metal.beam(
                "leg_brace_" + std::to_string(static_cast<int>(z)), across(-52, 52),
                sheetSection(metal.rounded({{-1176, z + 12}, {-1196, z + 12}, {-1196, z - 12}}, 4), 1.6));
        }
    }
}

void Carrier::addDucts() {
    const int n = metal.detail().segmentsPerQuarter;
    const auto tube = [&](double wide, double high) {
        return ringSection(roundedRectangle({-wide, -high}, {wide, high}, 10, n),
                           roundedRectangle({-wide + 1.8, -high + 1.8}, {wide - 1.8, high - 1.8}, 8.2, n));
    };
    const Line points{{1236, -455, 842}, {1215, -455, 861}, {1115, -430, 864}, {1090, -200, 866},
                      {1090, 200, 866},  {1115, 430, 864},  {1215, 455, 861},  {1236, 455, 842}};
    metal.beam("duct", Spine::through(points, 30), tube(26, 17));
    for (const double y : kVents) {
        const Vector3 at = skin.at(kVentAt, y) - Vector3(46, 0, 0);
        Pose start;
        start.translation = at;
        Spine straight(start);
        straight.straight(16);
        const std::string vent = "vent_" + std::to_string(static_cast<int>(y + 500));
        metal.beam(vent, straight, tube(46, 22));
        for (int i = 0; i < 4; ++i) {
            const double x = at.x(), z = at.z() - 14 + 9 * i;
            metal.beam(vent + "_blade_" + std::to_string(i + 1), across(y - 40, y + 40),
                       sheetSection({{-x - 2, z}, {-x - 8, z + 2}, {-x - 15, z + 2}}, 1.2));
        }
    }
}

void Carrier::addGloveBox() {
    const int n = metal.detail().segmentsPerQuarter;
    const Piece box = tray({-100, -48, -90}, {100, 48, 0}, 14, 2.2, n);
    // The glove box opens to the rear; its floor is in front.
    Matrix3 turn;
    turn.col(0) = Vector3::UnitY();
    turn.col(1) = Vector3::UnitZ();
    turn.col(2) = Vector3::UnitX();
    const Vector3 at = skin.at(kGloveBoxAt, kGloveBoxY) - Vector3(26, 0, 0);
    metal.part("glove_box", placed(box, [turn, at](const Vector3& p) -> Vector3 { return turn * p + at; }));
}

/// Screw bosses on the skin's back, pointing into the carrier.
void Carrier::addBosses() {
    const int bosses = metal.detail().count(8);
    for (int i = 0; i < bosses; ++i) {
        const double v = -500 + 1000 * (i + random.between(0.3, 0.7)) / bosses;
        const double u = i % 3 == 0 ? 11 : i % 3 == 1 ? 312 : skinLength() - 16;
        const Vector3 at = skin.at(u, v);
        const Vector3 across = skin.at(u, v + 0.1) - at, along = skin.at(u + 0.1, v) - at;
        const Vector3 inward = -along.cross(across).normalized();
        BossShape shape;
        shape.radius = random.between(4, 5);
        shape.height = random.between(9, 16);
        shape.foot = 2;
        shape.rounding = 1;
        metal.turnedPart("boss", bossOutline(shape, metal.detail().segmentsPerQuarter), at + 2.7 * inward,
                         inward);
    }
}

void Carrier::addStuds(int studs) {
    const Polyline dome = domeOutline(2.5, 3, metal.detail().segmentsPerQuarter);
    for (int i = 0; i < studs; ++i) {
        // Rows on the inner sides of the end plates, in front of their holes.
        const double side = i % 2 == 0 ? 1 : -1, x = 1020 + 6.5 * (i / 2 % 11), z = 612 + 7 * (i / 22 % 40);
        metal.turnedPart("stud", dome, {x, side * (body.carrierHalf - 3.3), z}, -side * Vector3::UnitY());
    }
}

}  // namespace

SheetMetal buildInstrumentCarrier(const CarBody& body, const Detail& detail, Random random, int studs,
                                  bool onlyCount) {
    SheetMetal metal(detail, onlyCount);
    Carrier carrier{body, metal, random};
    carrier.addSkin();
    carrier.addRibs();
    carrier.addBeam();
    carrier.addEnds();
    carrier.addMountingPlates();
    carrier.addLegs();
    carrier.addDucts();
    carrier.addGloveBox();
    carrier.addBosses();
    carrier.addStuds(studs);
    return metal;
}

}  // namespace clearway::scenes
