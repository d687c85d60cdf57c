// What is fitted to the car body in version 2 of the scene: seats, springs and brakes, exhaust and tank,
// steering wheel, bolts along the flanges, lines.
#include <cmath>

#include "program/scenes/car_body.h"
#include "program/scenes/curve.h"
#include "program/scenes/plate.h"
#include "program/scenes/sweep.h"

namespace clearway::scenes {

namespace {

struct Fittings {
    const CarBody& body;
    SheetMetal& metal;
    Random& random;

    int quarter() const { return metal.detail().segmentsPerQuarter; }
    int turn() const { return metal.detail().segmentsPerTurn; }
    double fine() const { return std::max(5.0, 0.7 * metal.detail().step); }

    void addSeat();
    void addBench();
    void addSuspension(const Vector3& wheel);
    void addExhaust();
    void addSteering();
    void addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double number);
    void addLines();
};

void Fittings::addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double number) {
    BoltShape shape;
    shape.length = 4;
    const int bolts = std::max(2, metal.detail().count(number));
    for (int i = 0; i < bolts; ++i) {
        const Vector3 at = from + (to - from) * ((i + 0.5) / bolts);
        metal.part("bolt", placed(bolt(shape, turn()), standingAt(at, axis, random.between(0, M_PI))));
    }
}

/// A frame of bent tubes on side plates, with wires across and a padded cushion.
void Fittings::addSeat() {
    const double y = 400, low = 348;
    const Vector3 foot(1850, y, low + 90), head(2010, y, 1010);
    const auto back = [&](double share, double side) -> Vector3 {
        return foot + (head - foot) * share + Vector3(0, side * (215 - 40 * share * share), 0);
    };
    metal.part("seat_back_tube",
               pipe(bent({back(0, -1), back(0.6, -1), back(1, -1), back(1, 1), back(0.6, 1), back(0, 1)}, 60,
                         quarter()),
                    13, 2, turn()));
    for (int i = 0; i < 5; ++i) {
        const double share = 0.15 + 0.15 * i;
        Line wire;
        for (int k = 0; k <= 12; ++k) {
            Vector3 p = back(share, (k / 6.0 - 1) * 0.9);
            p.x() += k % 2 == 0 ? 3 : -3;
            wire.push_back(p);
        }
        metal.part("seat_wire", rod(smooth(wire, fine()), 2, turn() / 2));
    }
    for (const double side : {-1.0, 1.0}) {
        const Piece plate =
            sweepAlongY(holedSection(
                            stationsBetween(1430, 1880, 75), {low, low + 75},
                            [](std::size_t i, std::size_t) { return i % 2 == 0 ? 0.0 : 22.0; }, turn()),
                        {y + side * 226 - 1.2, y + side * 226 + 1.2});
        metal.part("seat_side", plate);
        addBoltRow({1440, y + side * 227.5, low + 60}, {1870, y + side * 227.5, low + 60}, {0, side, 0}, 2);
        metal.part("head_rest_post",
                   rod({{2004, y + side * 60, 1026}, {2028, y + side * 60, 1114}}, 6, turn()));
    }
    metal.part("head_rest", roundedBox({2002, y - 120, 1121}, {2066, y + 120, 1190}, 28, 18, quarter()));
    const auto cushion = [=](double u, double v) {
        const double edge = smoothStep(std::abs(v - y), 150, 205) * 22,
                     front = smoothStep(1520 - u, 0, 110) * 24;
        return Vector3(u, v,
                       low + 86 + 24 * edge / 22 - front + 3 * std::cos((u - 1640) / 14) * (1 - edge / 22));
    };
    metal.panel("seat_pan",
                {cushion,
                 {1422, y - 210},
                 {1830, y + 210},
                 1.2,
                 0,
                 {{{1560, y - 90}, {30, 40}, 3}, {{1560, y + 90}, {30, 40}, 3}, {{1720, y}, {40, 60}, 3}}});
    metal.panel("seat_foam", {cushion, {1426, y - 206}, {1826, y + 206}, 34, 22});
}

void Fittings::addBench() {
    const auto back = [](double u, double v) {
        return Vector3(2700 + 0.32 * v + 14 * beadAt(std::abs(u), 210, 120, 60), u, 520 + v);
    };
    const std::vector<double> lines{-390, -330, -90, -30, 30, 90, 330, 390};
    metal.panel("bench_back_frame", {back,
                                     {-480, 0},
                                     {480, 470},
                                     1,
                                     0,
                                     {{{-210, 240}, {80, 120}, 4}, {{210, 240}, {80, 120}, 4}},
                                     lines});
    metal.panel("bench_back_foam", {back, {-476, 6}, {476, 464}, 40, -24, {}, lines});
    const auto seat = [](double u, double v) {
        return Vector3(u, v, 490 + 0.1 * (2650 - u) - 12 * beadAt(std::abs(v), 210, 130, 60));
    };
    metal.panel("bench_seat_foam", {seat, {2180, -480}, {2640, 480}, 60, 0, {}, {}, lines});
    metal.panel("bench_seat_pan", {seat,
                                   {2190, -475},
                                   {2630, 475},
                                   1,
                                   -33,
                                   {{{2400, 210}, {70, 70}, 3}, {{2400, -210}, {70, 70}, 3}},
                                   {},
                                   lines});
}

/// Spring, damper, brake disc and arm of a wheel.
void Fittings::addSuspension(const Vector3& wheel) {
    const Vector3 foot = wheel + Vector3(0, -105, 20);
    Line coil;
    const int around = std::max(8, turn()), turns = 6;
    for (int i = 0; i <= turns * around; ++i) {
        const double angle = 2 * M_PI * i / around;
        coil.push_back(foot +
                       Vector3(52 * std::cos(angle), 52 * std::sin(angle), 60 + 26 * angle / (2 * M_PI)));
    }
    metal.part("spring", rod(coil, 6, turn() / 2));
    metal.part("damper", rod({foot - Vector3(0, 0, 50), foot + Vector3(0, 0, 50)}, 22, turn()));
    metal.part("damper_rod", rod({foot + Vector3(0, 0, 50.5), foot + Vector3(0, 0, 290)}, 9, turn()));
    const Polyline disc =
        filleted({{40, 0}, {130, 0}, {130, 9}, {70, 9}, {62, 34}, {40, 34}}, {1, 1, 3, 3}, quarter());
    Polyline closed{{40, 0}};
    closed.insert(closed.end(), disc.begin() + 1, disc.end());
    metal.part("brake_disc",
               placed(ring(closed, 2 * turn()), standingAt(wheel + Vector3(0, -36, 0), -Vector3::UnitY())));
    metal.part("hub",
               placed(turned(filleted({{0, 0}, {34, 0}, {34, 30}, {0, 30}}, {3, 5}, quarter()), turn()),
                      standingAt(wheel + Vector3(0, -50, 0), Vector3::UnitY())));
    metal.part("caliper",
               roundedBox(wheel + Vector3(80, -60, -50), wheel + Vector3(150, -47, 50), 12, 4, quarter()));
    metal.part("lower_arm", rod(smooth({wheel + Vector3(0, -100, -60), wheel + Vector3(10, -130, -74),
                                        wheel + Vector3(40, -270, -70)},
                                       fine()),
                                14, turn()));
}

void Fittings::addExhaust() {
    const double z = 268;
    metal.part("exhaust_pipe",
               pipe(bent({{1000, 30, 250}, {1150, 20, z}, {1500, 0, z}}, 120, quarter()), 27, 2, turn()));
    metal.part("silencer_front",
               placed(turned(filleted({{0, 0}, {30, 0}, {62, 18}, {62, 330}, {30, 350}, {0, 350}},
                                      {4, 14, 14, 4}, quarter()),
                             2 * turn()),
                      standingAt({1510, 0, z}, Vector3::UnitX())));
    metal.part(
        "exhaust_pipe",
        pipe(bent({{1868, 0, z}, {2200, 0, z - 8}, {2420, 20, z - 20}, {2700, 60, 290}, {2990, 100, 180}},
                  120, quarter()),
             25, 2, turn()));
    metal.part("fuel_tank", roundedBox({2490, -430, 196}, {2880, -30, 310}, 50, 28, quarter()));
    metal.part("fuel_tank_strap", sweep(sheetSection({{-434, 318}, {-434, 192}, {-26, 192}, {-26, 318}}, 1.5),
                                        {2700.0, 2740.0}));
    metal.part("rear_silencer", roundedBox({3600, -330, 200}, {3760, 330, 296}, 54, 26, quarter()));
    for (int i = 0; i < 6; ++i)
        metal.part("silencer_rib", roundedBox({3620, -270.0 + 108 * i, 296.4}, {3740, -266.0 + 108 * i, 301},
                                              1.5, 1, quarter()));
}

void Fittings::addSteering() {
    const Vector3 hub(1395, -340, 770), axis = Vector3(0.92, 0, 0.38).normalized();
    metal.part("steering_wheel",
               placed(ring(circle({178, 0}, 14, turn()), 3 * turn()), standingAt(hub, axis)));
    for (int i = 0; i < 3; ++i) {
        const Placement there = standingAt(hub, axis, 2 * M_PI * i / 3);
        metal.part("steering_spoke", rod({there({40, 0, -6}), there({163, 0, 0})}, 8, turn()));
    }
    metal.part("steering_boss",
               placed(turned(filleted({{0, -30}, {36, -30}, {40, 8}, {0, 16}}, {6, 10}, quarter()), turn()),
                      standingAt(hub, axis)));
}

/// A harness along each sill and pipes on the dash panel.
void Fittings::addLines() {
    const int cables = std::min(metal.detail().count(2), 6);
    for (int i = 0; i < cables; ++i) {
        Line line;
        for (double x = 1180; x <= 2340; x += 145)
            line.push_back({x, 606 + 3.0 * random.between(-1, 1), body.floorZ(x, 606) + 20 + 9.0 * i});
        const double wave = 8 / std::sqrt(metal.detail().richness), radius = 3.4;
        metal.part("sill_cable",
                   variedRod(
                       smooth(line, std::max(3.0, 0.4 * metal.detail().step)),
                       [=](double at) { return radius + 0.5 * std::sin(2 * M_PI * at / wave); }, turn() / 2));
    }
}

}  // namespace

void addFittings(const CarBody& body, SheetMetal& metal, Random& random) {
    Fittings fittings{body, metal, random};
    metal.onBothSides([&] {
        fittings.addSeat();
        fittings.addSuspension({kFrontWheel, 690, kWheelHeight});
        fittings.addSuspension({kRearWheel, 700, kWheelHeight});
        fittings.addLines();
        for (const double x : {1450.0, 1850.0}) {
            const double z = body.floorZ(x, 230) + 4.2;
            fittings.addBoltRow({x - 53, 245, z}, {x - 53, 560, z}, Vector3::UnitZ(), 3);
            fittings.addBoltRow({x + 53, 245, z}, {x + 53, 560, z}, Vector3::UnitZ(), 3);
        }
        fittings.addBoltRow({300, 640, 880}, {860, 640, 880}, Vector3::UnitZ(), 3);
    });
    fittings.addBench();
    fittings.addExhaust();
    fittings.addSteering();
}

}  // namespace clearway::scenes
