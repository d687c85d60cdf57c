// The sheet metal of the engine bay: bulkhead, inner wings, strut towers, members and supports.
#include <cmath>

#include "program/scenes/cembox_bay.h"
#include "program/scenes/loft.h"
#include "program/scenes/plate.h"
#include "program/scenes/sweep.h"

namespace clearway::scenes {

namespace {

/// A line up a wall with beads that stand `depth` to its left, at equal distances.
Polyline beadedWall(const Vector2& from, const Vector2& to, int beads, double depth) {
    const Vector2 along = (to - from).normalized(), left(-along.y(), along.x());
    const double spacing = (to - from).norm() / beads, flat = 0.3 * spacing, slope = 1.2 * std::abs(depth);
    Polyline line{from};
    for (int i = 0; i < beads; ++i) {
        const Vector2 middle = from + along * (spacing * (i + 0.5));
        line.push_back(middle - along * (flat / 2 + slope));
        line.push_back(middle - along * (flat / 2) + left * depth);
        line.push_back(middle + along * (flat / 2) + left * depth);
        line.push_back(middle + along * (flat / 2 + slope));
    }
    line.push_back(to);
    return line;
}

/// The y of what lies at `y` in the middle of the bulkhead.
double archedBack(double y, double x) {
    return y + 22 * (x / 700) * (x / 700);
}

/// The bulkhead and the cowl's front edge above it, slightly arched to the rear.
void addBulkhead(Bay& bay) {
    const double y = Bay::kBulkhead, half = Bay::kHalfWidth - 25;
    const Placement arched = [](const Vector3& p) { return Vector3(p.x(), archedBack(p.y(), p.x()), p.z()); };
    Polyline lower = beadedWall({y, 130}, {y, 380}, 3, -7);
    lower.insert(lower.begin(), {y + 70, 60});
    const std::vector<double> along = bay.stations(-half, half);
    bay.add("bulkhead_lower", placed(sweep(bay.sheet(lower, 6, 1.4), along), arched));
    Polyline upper = beadedWall({y, 381}, {y, 600}, 2, -6);
    upper.push_back({y, 655});
    upper.push_back({y - 14, 664});
    bay.add("bulkhead_upper", placed(sweep(bay.sheet(upper, 6, 1.2), along), arched));
    const Polyline cowl{{y + 30, 667}, {y - 22, 667}, {y - 27, 690}, {y - 12, 722}, {y + 40, 732}};
    bay.add("cowl_edge", placed(sweep(bay.sheet(cowl, 7, 1.2), along), arched));
    const Polyline gasket = circle({y - 27, 728}, 5, bay.segmentsFor(5));
    bay.add("cowl_seal", placed(sweep(fullSection(gasket), along), arched));
    bay.addBoltRow({-half + 20, y - 2, 630}, {half - 20, y - 2, 630}, -Vector3::UnitY(), 3, 5);
}

/// With the wheel arch bulging inwards.
void addInnerWing(Bay& bay, double side) {
    const double x = Bay::kHalfWidth;
    Polyline line = beadedWall({x, 180}, {x, 620}, 3, 8);
    line.insert(line.begin(), {x - 46, 176});
    line.push_back({x, 690});
    line.push_back({x + 48, 694});
    if (side < 0) {
        for (Vector2& p : line) p.x() = -p.x();
    }
    const Placement bulged = [side](const Vector3& p) {
        const double y = (p.y() - Bay::kTowerY) / 150, z = (p.z() - 250) / 220;
        return Vector3(p.x() - side * 45 * std::exp(-y * y - z * z), p.y(), p.z());
    };
    const char* const name = side > 0 ? "inner_wing_left" : "inner_wing_right";
    bay.add(name, placed(sweepAlongY(bay.sheet(line, 7, 1.2), bay.stations(20, 835)), bulged));
    bay.addBoltRow({side * (x + 28), 40, 695}, {side * (x + 28), 810, 695}, Vector3::UnitZ(), 3, 5);
}

void addStrutTower(Bay& bay, double side) {
    const double top = Bay::kTowerTop, t = 2;
    const Polyline outline = bay.rounded({{0, top - t},
                                          {52, top - t},
                                          {80, top - 26},
                                          {88, 420},
                                          {125, 380},
                                          {127, 382},
                                          {88 + t, 421},
                                          {80 + t, top - 25},
                                          {53, top},
                                          {0, top}},
                                         {6, 12, 14, 0, 0, 15, 13, 7});
    const Vector3 foot(side * Bay::kTowerX, Bay::kTowerY, 0);
    const Vector3 lean(-0.06 * side, 0.05, 1);
    bay.add(side > 0 ? "strut_tower_left" : "strut_tower_right",
            placed(bay.turnedRound(outline), standingAt(foot + Vector3(35 * side, -30, 0), lean)));
    const Vector3 head = foot + Vector3(0, 0, top + 3);
    for (int i = 0; i < 3; ++i) {
        const double angle = 0.4 + 2 * M_PI * i / 3;
        bay.addBolt(head + 34 * Vector3(std::cos(angle), std::sin(angle), 0), lean, 4);
    }
    const Polyline bearing = bay.rounded({{0, 0}, {24, 0}, {24, 5}, {9, 9}, {9, 22}, {0, 22}}, {2, 3, 2, 3});
    bay.add(side > 0 ? "strut_bearing_left" : "strut_bearing_right",
            placed(bay.turnedRound(bearing), standingAt(head, lean)));
}

/// Hollow, with rounded edges.
void addRail(Bay& bay, double side) {
    const int n = bay.quarterFor(9);
    const double x = side * 430;
    const auto outline = [&](double in) {
        return roundedRectangle({x - 34 + in, 110 + in}, {x + 34 - in, 220 - in}, 9 - in, n);
    };
    const Placement dropping = [](const Vector3& p) {
        const double behind = std::max(0.0, p.y() - 600) / 250;
        return Vector3(p.x(), p.y(), p.z() - 45 * behind * behind);
    };
    const Section section = ringSection(outline(0), outline(2));
    bay.add(side > 0 ? "side_member_left" : "side_member_right",
            placed(sweepAlongY(section, bay.stations(15, 840)), dropping));
    for (const double y : {90.0, 300.0, 520.0}) {
        bay.addBoltRow({x + side * 34.3, y, 165}, {x + side * 34.3, y + 110, 165}, {side, 0, 0}, 4, 2);
    }
}

/// A hat section across the bay with its closing plate.
void addCrossMember(Bay& bay, const std::string& name, const Vector2& middle, const Vector2& size,
                    double half) {
    const double w = size.x() / 2, low = middle.y(), high = middle.y() + size.y();
    const Polyline hat{{middle.x() - w - 22, low},   {middle.x() - w, low}, {middle.x() - 0.8 * w, high},
                       {middle.x() + 0.8 * w, high}, {middle.x() + w, low}, {middle.x() + w + 22, low}};
    const std::vector<double> along = bay.stations(-half, half);
    bay.add(name, sweep(bay.sheet(hat, 8, 2), along));
    const Section plate =
        rectangleSection({middle.x() - w - 22, low - 3.5}, {middle.x() + w + 22, low - 1.5});
    bay.add(name + "_plate", sweep(plate, {-half, half}));
    bay.addBoltRow({-half + 15, middle.x() + w + 12, low + 1.2}, {half - 15, middle.x() + w + 12, low + 1.2},
                   Vector3::UnitZ(), 3, 6);
}

void addHeadlight(Bay& bay, double side) {
    const double x = side * 500;
    const Piece shell = tray({-85, -50, 0}, {85, 50, 95}, 24, 2.5, bay.quarterFor(24));
    const Placement forward = facing({x, 118, 555}, Vector3::UnitX(), -Vector3::UnitY());
    bay.add(side > 0 ? "headlight_left" : "headlight_right", placed(shell, forward));
    const Piece reflector = bay.turnedRound(
        bay.rounded({{0, 9}, {15, 9}, {39.5, 60}, {38, 60}, {14, 12}, {0, 12}}, {4, 0, 0, 2}));
    for (const double at : {-40.0, 40.0})
        bay.addNumbered("reflector",
                        placed(reflector, facing({x + at, 114, 555}, Vector3::UnitX(), -Vector3::UnitY())));
    bay.addBoltRow({x - 90, 119, 612}, {x + 90, 119, 612}, Vector3::UnitY(), 3, 2);
}

/// A plate with lightening holes between the inner wing and the side member.
void addApron(Bay& bay, double side) {
    std::vector<double> xs, ys;
    for (int i = 0; i <= 3; ++i) xs.push_back(470 + 170 * i / 3.0);
    const int cells = std::max(5, bay.detail.count(3));
    for (int i = 0; i <= cells; ++i) ys.push_back(130 + 320.0 * i / cells);
    const double room = 0.5 * std::min(xs[1] - xs[0], ys[1] - ys[0]);
    const auto hole = [room](std::size_t column, std::size_t row) {
        return (column + row) % 2 == 0 ? 0.62 * room : 0.0;
    };
    Section plate = holedSection(xs, ys, hole, bay.segmentsFor(0.62 * room));
    Piece apron = sweepAlongZ(plate, {172, 173.6});
    if (side < 0) apron = placed(apron, [](const Vector3& p) { return Vector3(-p.x(), 580 - p.y(), p.z()); });
    bay.add(side > 0 ? "apron_left" : "apron_right", apron);
}

}  // namespace

void addBody(Bay& bay) {
    addBulkhead(bay);
    for (const double side : {1.0, -1.0}) {
        addInnerWing(bay, side);
        addStrutTower(bay, side);
        addRail(bay, side);
        addHeadlight(bay, side);
        addApron(bay, side);
    }
    addCrossMember(bay, "front_member", {60, 85}, {70, 55}, 460);
    addCrossMember(bay, "rear_member", {690, 40}, {120, 60}, 460);
    addCrossMember(bay, "radiator_support", {62, 630}, {34, 26}, 600);
    const Polyline latch{{0, 0}, {16, 0}, {16, 30}, {9, 42}, {0, 42}};
    bay.add("hood_latch", placed(bay.turnedRound(bay.rounded(latch, {2, 6, 3})),
                                 standingAt({bay.random.between(-30, 30), 62, 657.5}, Vector3::UnitZ())));
}

/// Rows of domes on the flat strip of the bulkhead above its beads, out of the module's way.
void addWeldStuds(Bay& bay, int studs) {
    constexpr double kRadius = 3, kPitch = 7.5, kRows[] = {602, 609, 616, 644};  // mm; bolts are between
    constexpr int kColumns = 158;
    const Piece dome = turned(domeOutline(kRadius, 2.5, bay.quarterFor(8) + 2), 2 * bay.segmentsFor(15));
    for (int i = 0; i < studs; ++i) {
        const double x = kPitch * (i % kColumns - 0.5 * (kColumns - 1)), z = kRows[i / kColumns % 4];
        const double y = archedBack(Bay::kBulkhead, x) - 0.6 - Bay::kSlit;
        bay.assembly.addNumbered("weld_stud", placed(dome, standingAt({x, y, z}, -Vector3::UnitY())));
    }
}

}  // namespace clearway::scenes
