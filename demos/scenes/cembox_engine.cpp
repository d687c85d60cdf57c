// The engine, its gearbox and its radiator in the engine bay.
#include "demos/scenes/cembox_bay.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kLeft = 170, kRight = -330;  // x of the block's ends; the gearbox is at the left
constexpr double kFront = 240, kRear = 500;   // y
constexpr double kJoint = 330;                // z between block and head
constexpr int kCylinders = 4;

double cylinderX(int i) {
    return kRight + 75 + 117 * i;
}

/// A plate that stands on a wall, its outer corners rounded; pulled along z.
void addRib(Bay& bay, const Vector3& foot, double outward, double height) {
    const double depth = 9, half = 2.2;
    Polyline loop = bay.rounded({{half, 0}, {half, depth}, {-half, depth}, {-half, 0}}, {2, 2});
    for (Vector2& p : loop) p = {foot.x() + p.x(), foot.y() + outward * p.y()};
    if (outward < 0) std::reverse(loop.begin(), loop.end());
    bay.addNumbered("block_rib", sweepAlongZ(fullSection(loop), {foot.z(), foot.z() + height}));
}

void addBoss(Bay& bay, const Vector3& at, const Vector3& axis) {
    BossShape shape;
    shape.radius = bay.random.between(8, 12);
    shape.height = bay.random.between(10, 18);
    shape.foot = 3;
    bay.addNumbered("block_boss", bay.turnedRound(bossOutline(shape, bay.quarterFor(shape.radius))), at,
                    axis);
    bay.addBolt(at + axis * (shape.height + Bay::kSlit), axis, 4);
}

void addBlock(Bay& bay) {
    bay.add("engine_block", bay.box({kRight, kFront, 95}, {kLeft, kRear, kJoint - Bay::kSlit}, 18, 6));
    bay.add("head_gasket",
            bay.box({kRight + 6, kFront + 6, kJoint}, {kLeft - 6, kRear - 6, kJoint + 1.5}, 16, 0.4));
    bay.add("cylinder_head", bay.box({kRight, kFront + 2, kJoint + 1.8}, {kLeft, kRear - 2, 420}, 18, 5));
    bay.add("oil_pan", bay.box({kRight + 30, kFront + 20, 28}, {kLeft - 60, kRear - 20, 94.5}, 26, 16));
    const int ribs = bay.detail.count(6);
    for (int i = 0; i < ribs; ++i) {
        const double x = kRight + 30 + (kLeft - kRight - 60) * (i + 0.5) / ribs;
        addRib(bay, {x, kFront - Bay::kSlit, 120}, -1, bay.random.between(130, 190));
        addRib(bay, {x, kRear + Bay::kSlit, 120}, 1, bay.random.between(130, 190));
    }
    const int bosses = bay.detail.count(4);
    for (int i = 0; i < bosses; ++i) {
        const double x = kRight + 40 + (kLeft - kRight - 80) * (i + bay.random.between(0.2, 0.8)) / bosses;
        addBoss(bay, {x, kFront - Bay::kSlit, bay.random.between(110, 300)}, -Vector3::UnitY());
        addBoss(bay, {x, kRear + Bay::kSlit, bay.random.between(110, 300)}, Vector3::UnitY());
    }
    for (const double y : {kFront + 28, kRear - 28}) {
        bay.addBoltRow({kRight + 40, y, 93}, {kLeft - 70, y, 93}, -Vector3::UnitZ(), 3, 5);
    }
}

void addCover(Bay& bay) {
    bay.add("valve_cover", bay.box({kRight + 12, kFront + 24, 420.5}, {kLeft - 12, kRear - 40, 478}, 28, 18));
    bay.addBoltRow({kRight + 40, kFront + 12, 420.5}, {kLeft - 40, kFront + 12, 420.5}, Vector3::UnitZ(), 3,
                   5);
    bay.addBoltRow({kRight + 40, kRear - 20, 420.5}, {kLeft - 40, kRear - 20, 420.5}, Vector3::UnitZ(), 3, 5);
    for (int i = 0; i < kCylinders; ++i) {
        const double x = cylinderX(i), y = kFront + 110;
        const Piece coil = bay.box({x - 16, y - 26, 478.5}, {x + 16, y + 26, 505}, 7, 4);
        bay.addNumbered("ignition_coil", coil);
        bay.addBolt({x + 24, y + 30, 478.5}, Vector3::UnitZ(), 2.5);
        const Piece plug = bay.box({x - 10, y - 50, 484}, {x + 10, y - 26.5, 499}, 4, 2);
        bay.addNumbered("coil_plug", plug);
    }
    const Polyline cap = bay.rounded({{0, 0}, {26, 0}, {26, 8}, {22, 8}, {22, 20}, {0, 20}}, {1, 3, 2, 5});
    bay.add("oil_cap", bay.turnedRound(cap), {kRight + 60, kRear - 90, 478.5}, Vector3::UnitZ());
    const Line dipstick{{kRight + 130, kFront - 8, 230},
                        {kRight + 125, kFront - 16, 330},
                        {kRight + 128, kFront - 4, 420},
                        {kRight + 128, kFront - 2, 500}};
    bay.add("dipstick", bay.bar(smooth(dipstick, bay.detail.step / 2), 4));
}

/// Runners from the head to a plenum behind it.
void addIntake(Bay& bay) {
    const double step = bay.detail.step / 2;
    for (int i = 0; i < kCylinders; ++i) {
        const double x = cylinderX(i);
        const Line line = smooth({{x, kRear, 385},
                                  {x - 4, kRear + 40, 392},
                                  {x - 14, kRear + 84, 425},
                                  {x - 20, kRear + 78, 468},
                                  {x - 20, kRear + 44, 492}},
                                 step);
        bay.addNumbered("intake_runner", bay.tube(line, 19, 3));
        bay.addNumbered("intake_flange",
                        bay.box({x - 34, kRear + Bay::kSlit, 352}, {x + 34, kRear + 9, 414}, 10, 2));
        bay.addBolt({x - 27, kRear + 9.3, 360}, Vector3::UnitY(), 3.5);
        bay.addBolt({x + 27, kRear + 9.3, 406}, Vector3::UnitY(), 3.5);
    }
    const Line plenum{{kRight + 20, kRear + 36, 500},
                      {kRight + 40, kRear + 36, 500},
                      {kLeft - 110, kRear + 36, 500},
                      {kLeft - 80, kRear + 36, 500}};
    bay.add("intake_plenum",
            bay.wavyBar(smooth(plenum, step), 34, [](double along) { return std::min(34.0, 22 + along); }));
    const Polyline throttle =
        bay.rounded({{26, 0}, {40, 0}, {40, 8}, {32, 12}, {32, 46}, {26, 46}}, {2, 3, 3, 1});
    bay.add("throttle_body", bay.turnedRing(throttle), {kLeft - 78, kRear + 36, 500}, Vector3::UnitX());
    bay.add("fuel_rail", bay.bar({{kRight + 40, kRear + 22, 440}, {kLeft - 60, kRear + 22, 440}}, 8));
    for (int i = 0; i < kCylinders; ++i) {
        const Polyline injector =
            bay.rounded({{0, 0}, {5, 0}, {5, 14}, {8, 18}, {8, 36}, {0, 36}}, {1, 2, 2, 2});
        bay.addNumbered("injector", bay.turnedRound(injector), {cylinderX(i) + 26, kRear + 4, 418},
                        Vector3(0, 0.5, 0.5));
    }
}

void addExhaust(Bay& bay) {
    for (int i = 0; i < kCylinders; ++i) {
        const double x = cylinderX(i), gather = -80 + 14 * (i - 1.5);
        const Line points{{x, kFront + 2, 380},
                          {x, kFront - 32, 376},
                          {0.6 * x + 0.4 * gather, kFront - 62, 330},
                          {gather, kFront - 66, 262}};
        bay.addNumbered("exhaust_runner", bay.tube(smooth(points, bay.detail.step / 2), 18, 2));
        bay.addNumbered("exhaust_flange",
                        bay.box({x - 33, kFront - 8, 352}, {x + 33, kFront + 1.5, 410}, 9, 2));
        bay.addBolt({x - 27, kFront - 8.3, 359}, -Vector3::UnitY(), 3.5);
        bay.addBolt({x + 27, kFront - 8.3, 403}, -Vector3::UnitY(), 3.5);
    }
    const Line points{
        {-80, kFront - 66, 268}, {-80, kFront - 66, 200}, {-70, kFront - 40, 120}, {-66, kFront + 40, 18}};
    bay.add("exhaust_collector", bay.wavyBar(smooth(points, bay.detail.step / 2), 46,
                                             [](double along) { return along < 60 ? 46 - along / 4 : 31; }));
    // The heat shield's waves run along x.
    Polyline wave;
    const int waves = std::clamp(bay.detail.count(4), 4, 14);
    for (int i = 0; i <= 4 * waves; ++i) {
        const double share = static_cast<double>(i) / (4 * waves);
        wave.push_back({kFront - 98 - 18 * std::sin(M_PI * share) + 2.2 * std::sin(2 * M_PI * waves * share),
                        250 + 165 * share});
    }
    bay.add("heat_shield", sweep(sheetSection(wave, 1.2), bay.stations(kRight + 40, kLeft - 40)));
}

void addGearbox(Bay& bay) {
    const Polyline bell =
        bay.rounded({{0, 0}, {150, 0}, {150, 14}, {138, 16}, {104, 92}, {0, 92}}, {0, 4, 6, 12});
    const Vector3 axis(kLeft + 2, 372, 215);
    bay.add("bell_housing", bay.turnedRound(bell), axis, Vector3::UnitX());
    bay.add("gearbox_case", bay.box({kLeft + 95, 290, 110}, {kLeft + 245, 455, 300}, 34, 14));
    const int ribs = bay.detail.count(6);
    for (int i = 0; i < ribs; ++i) {
        const double angle = 2 * M_PI * i / ribs;
        const Section plate = fullSection({{108, -2}, {146, -2}, {146, 2}, {108, 2}});
        // The rib is a wedge between the bell's flange and its cone.
        Piece rib = sweepAlongZ(plate, {17, 60});
        for (std::size_t k = 4; k < 8; ++k) rib.vertices[k].x() = std::min(rib.vertices[k].x(), 122.0);
        bay.addNumbered("bell_rib", rib, axis, Vector3::UnitX(), angle);
        bay.addBolt(standingAt(axis, Vector3::UnitX(), angle + M_PI / ribs)(Vector3(142, 0, 16.5)),
                    Vector3::UnitX(), 4.5);
    }
    bay.addBoltRow({kLeft + 125, 289.5, 280}, {kLeft + 220, 289.5, 280}, -Vector3::UnitY(), 4, 3);
    const Polyline starter =
        bay.rounded({{0, 0}, {38, 0}, {38, 110}, {26, 124}, {26, 150}, {0, 150}}, {5, 3, 5, 5});
    bay.add("starter", bay.turnedRound(starter), {kLeft - 10, kFront - 48, 150}, -Vector3::UnitX());
}

struct Pulley {
    const char* name;
    Vector2 centre;  ///< y, z
    double radius;
    double depth;  ///< depth of the device that the pulley drives
};

constexpr double kBeltX = kRight - 26;
constexpr double kBeltWidth = 20;

void addDriven(Bay& bay, const Pulley& pulley) {
    const double r = pulley.radius, w = kBeltWidth / 2 + 2;
    const Vector3 at(kBeltX, pulley.centre.x(), pulley.centre.y());
    const std::string name = pulley.name;
    const Polyline corners{{0.35 * r, -w}, {r + 3, -w},    {r + 3, 2 - w}, {r, 2 - w},
                           {r, w - 2},     {r + 3, w - 2}, {r + 3, w},     {0.35 * r, w}};
    const Polyline rim = bay.rounded(corners, {1, 0, 0, 0, 0, 1});
    bay.add(name + "_pulley", bay.turnedRing(rim), at, Vector3::UnitX());
    bay.addBolt(at - Vector3(w + 1, 0, 0), -Vector3::UnitX(), 6);
    if (pulley.depth <= 0) return;
    const double body = 1.5 * r, start = w + 3;
    const Polyline house = bay.rounded({{0, start},
                                        {0.8 * body, start},
                                        {body, start + 14},
                                        {body, start + pulley.depth},
                                        {0.7 * body, start + pulley.depth + 12},
                                        {0, start + pulley.depth + 12}},
                                       {4, 5, 5, 4});
    bay.add(name, bay.turnedRound(house), at, Vector3::UnitX());
    const int fins = bay.detail.count(5);
    for (int i = 0; i < fins; ++i) {
        const Piece fin =
            bay.box({body + 0.3, -2, start + 18}, {body + 9, 2, start + pulley.depth - 4}, 1.6, 0.6);
        bay.addNumbered(name + "_fin", fin, at, Vector3::UnitX(), 2 * M_PI * i / fins);
    }
}

void addBeltDrive(Bay& bay) {
    const Pulley pulleys[] = {{"crank", {360, 140}, 72, 0},
                              {"alternator", {205, 300}, 32, 105},
                              {"compressor", {200, 150}, 46, 120},
                              {"water_pump", {430, 320}, 56, 0},
                              {"idler", {300, 300}, 30, 0}};
    for (const Pulley& pulley : pulleys) addDriven(bay, pulley);
    // The belt's outline is that of the convex hull of all pulleys: in each direction it touches the
    // outermost pulley.
    const int n = 3 * bay.segmentsFor(72);
    Polyline outer, inner;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * M_PI * i / n;
        const Vector2 direction(std::cos(angle), std::sin(angle));
        const Pulley* touched = &pulleys[0];
        for (const Pulley& pulley : pulleys) {
            if (direction.dot(pulley.centre) + pulley.radius >
                direction.dot(touched->centre) + touched->radius)
                touched = &pulley;
        }
        inner.push_back(touched->centre + direction * (touched->radius + Bay::kSlit));
        outer.push_back(touched->centre + direction * (touched->radius + 4.5));
    }
    bay.add("belt",
            sweep(ringSection(outer, inner), {kBeltX - kBeltWidth / 2 + 2, kBeltX + kBeltWidth / 2 - 2}));
}

constexpr double kHalf = 360, kLow = 165, kHigh = 600;  // of the core
constexpr double kCoreFront = 84, kCoreRear = 108;      // y of the core

/// Upright flat tubes with a folded sheet between each pair.
void addCore(Bay& bay) {
    const int tubes = std::clamp(bay.detail.count(9), 9, 60);
    const double pitch = 2 * kHalf / tubes;
    const int folds = 2 * tubes;
    for (int i = 0; i <= tubes; ++i) {
        const double x = pitch * i - kHalf;
        const Polyline outline =
            roundedRectangle({x - 1.5, kCoreFront}, {x + 1.5, kCoreRear}, 1.2, bay.quarterFor(1.2));
        bay.addNumbered("radiator_tube", sweepAlongZ(fullSection(outline), {kLow, kHigh}));
        if (i == tubes) break;
        Polyline fold;
        for (int k = 0; k <= folds; ++k) {
            fold.push_back({x + (k % 2 == 0 ? 2.2 : pitch - 2.2), kLow + 3 + (kHigh - kLow - 6) * k / folds});
        }
        bay.addNumbered("radiator_fin",
                        sweepAlongY(sheetSection(fold, 0.4), {kCoreFront + 2, kCoreRear - 2}));
    }
    for (const double z : {kLow - 46, kHigh + Bay::kSlit}) {
        const bool isUpper = z > kLow;
        bay.add(isUpper ? "radiator_tank_upper" : "radiator_tank_lower",
                bay.box({-kHalf - 12, kCoreFront - 8, z},
                        {kHalf + 12, kCoreRear + 10, isUpper ? z + 26 : z + 45.5}, 14, 9));
    }
}

/// A blade: a strip that twists along its length.
Piece blade(const Bay& bay, double from, double to) {
    const double width = 0.34 * to;
    const Section strip = sheetSection(
        {{-width / 2, 0}, {-width / 6, 0.05 * width}, {width / 6, 0.05 * width}, {width / 2, 0}}, 2);
    return placed(sweep(strip, stationsBetween(from, to, std::max(4.0, bay.detail.step / 3))),
                  [&](const Vector3& p) {
                      const double twist = 0.9 - 0.4 * (p.x() - from) / (to - from);
                      const Vector2 q = Eigen::Rotation2Dd(twist) * Vector2(p.y(), p.z());
                      return Vector3(p.x(), q.x(), q.y());
                  });
}

void addFan(Bay& bay, double side) {
    const Vector3 at(side * 170, 148, 385);
    const Polyline hub = bay.rounded({{0, -22}, {42, -22}, {46, -18}, {46, 14}, {0, 20}}, {2, 3, 8});
    const std::string name = side > 0 ? "fan_left" : "fan_right";
    bay.add(name + "_hub", bay.turnedRound(hub), at, Vector3::UnitY());
    constexpr int kBlades = 7;
    for (int i = 0; i < kBlades; ++i) {
        bay.addNumbered(name + "_blade", blade(bay, 47, 136), at, Vector3::UnitY(),
                        2 * M_PI * i / kBlades + 0.3);
    }
    const Polyline band{{137, -12}, {140, -12}, {140, 12}, {137, 12}};
    bay.add(name + "_band", bay.turnedRing(band), at, Vector3::UnitY());
    const Polyline motor = bay.rounded({{0, 0}, {34, 0}, {34, 30}, {0, 30}}, {3, 8});
    bay.add(name + "_motor", bay.turnedRound(motor), at + Vector3(0, 21, 0), Vector3::UnitY());
    for (int i = 0; i < 3; ++i) {
        const double angle = 0.5 + 2 * M_PI * i / 3;
        const Vector3 out(std::cos(angle), 0, std::sin(angle));
        bay.addNumbered(name + "_strut",
                        bay.bar({at + 36 * out + Vector3(0, 34, 0), at + 152 * out + Vector3(0, 30, 0)}, 5));
        bay.addBolt(at + 28 * out + Vector3(0, 51.5, 0), Vector3::UnitY(), 2.5);
    }
}

}  // namespace

void addEngine(Bay& bay) {
    addBlock(bay);
    addCover(bay);
    addIntake(bay);
    addExhaust(bay);
    addGearbox(bay);
    addBeltDrive(bay);
    const Polyline filter = bay.rounded({{0, 0}, {30, 0}, {38, 6}, {38, 84}, {0, 84}}, {2, 3, 8});
    bay.add("oil_filter", bay.turnedRound(filter), {kRight + 180, kFront - 2, 165}, Vector3(0, -1, -0.3));
    for (const double x : {kRight - 95, kLeft + 260}) {
        const Polyline rubber = bay.rounded({{12, 0}, {34, 0}, {34, 46}, {12, 46}}, {4, 4});
        bay.addNumbered("engine_mount", bay.turnedRing(rubber), {x, 395, 232}, Vector3::UnitZ());
        bay.addBolt({x, 395, 279}, Vector3::UnitZ(), 7);
    }
}

void addCooling(Bay& bay) {
    addCore(bay);
    const auto hole = [](std::size_t, std::size_t) { return 146.0; };
    bay.add("fan_shroud",
            sweepAlongY(holedSection({-338, 0, 338}, {225, 545}, hole, bay.segmentsFor(146)), {126, 129}));
    for (const double side : {1.0, -1.0}) {
        addFan(bay, side);
        bay.addBoltRow({side * 330, 129.3, 240}, {side * 330, 129.3, 530}, Vector3::UnitY(), 3, 3);
    }
}

}  // namespace clearway::scenes
