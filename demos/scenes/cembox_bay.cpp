#include "demos/scenes/cembox_bay.h"

#include <algorithm>
#include <cmath>

namespace clearway::scenes {

namespace {

/// The most that a point of the part moves between two sampled poses. The boxes grow by half the step.
constexpr double kStep = 3;  // mm

constexpr Box::CornerType corner(int i) {
    return static_cast<Box::CornerType>(i);
}

Box grown(const Box& box, double by) {
    return {box.min() - Vector3::Constant(by), box.max() + Vector3::Constant(by)};
}

/// True when the projections on the axis of the triangle and of the box of that half size about the origin
/// have a gap.
bool isSeparating(const Vector3& axis, const Vector3 (&triangle)[3], const Vector3& half) {
    const double p = axis.dot(triangle[0]), q = axis.dot(triangle[1]), r = axis.dot(triangle[2]);
    const double reach = axis.cwiseAbs().dot(half);
    return std::min({p, q, r}) > reach || std::max({p, q, r}) < -reach;
}

/// Tests the thirteen separating axes of a triangle and a box.
bool meetsBox(const Vector3 (&triangle)[3], const Vector3& half) {
    const Vector3 edges[3] = {triangle[1] - triangle[0], triangle[2] - triangle[1],
                              triangle[0] - triangle[2]};
    if (isSeparating(edges[0].cross(edges[1]), triangle, half)) return false;
    for (int k = 0; k < 3; ++k) {
        if (isSeparating(Vector3::Unit(k), triangle, half)) return false;
        for (const Vector3& edge : edges) {
            if (isSeparating(Vector3::Unit(k).cross(edge), triangle, half)) return false;
        }
    }
    return true;
}

constexpr double kWithWashers = 0.6;  // richness from which bolts have washers

/// Grows like the detail's numbers of segments, but continuously.
double cuts(const Detail& detail) {
    return std::pow(detail.richness, 0.75 / 0.7);
}

constexpr double kRailWall = 3;
constexpr double kBufferHeight = 7;

/// A channel around the guide edge at the gap, in the module's (x, y). Its inner corners are rounded by half
/// the gap: even a single chord then keeps the gap from the edge's corner.
Section railSection(const Bay& bay, double side) {
    const CemboxDesign& design = bay.design;
    const double lip = design.bodyHalf + 1.6 * design.gap, outer = design.edgeHalf + design.gap;
    const double half = design.edgeThickness / 2 + design.gap, corner = 0.5 * design.gap;
    Polyline inside =
        bay.rounded({{lip, half}, {outer, half}, {outer, -half}, {lip, -half}}, {corner, corner});
    if (side < 0) {
        std::reverse(inside.begin(), inside.end());
        for (Vector2& p : inside) p.x() = -p.x();
    }
    return bandSection(offsetLine(inside, kRailWall), inside);
}

/// Rails and buffers are the only things that reach into the room kept free for the module.
void addRailsAndBuffers(Bay& bay) {
    const CemboxDesign& design = bay.design;
    const Placement inBay = [&](const Vector3& p) -> Vector3 { return p + design.place; };
    for (const double side : {1.0, -1.0}) {
        const Piece rail =
            sweepAlongZ(railSection(bay, side), bay.stations(-design.halfHeight - 5, design.railTop));
        bay.assembly.add(side > 0 ? "guide_rail_left" : "guide_rail_right", placed(rail, inBay));
        const Vector3 below(0.7 * side * design.bodyHalf, 0, -design.halfHeight - design.gap - kBufferHeight);
        const Piece buffer = bay.turnedRound(domeOutline(9, kBufferHeight, bay.quarterFor(9)));
        bay.assembly.add(side > 0 ? "buffer_left" : "buffer_right",
                         placed(buffer, standingAt(design.place + below, Vector3::UnitZ())));
    }
}

void addCarrier(Bay& bay) {
    const CemboxDesign& design = bay.design;
    const Vector3& place = design.place;
    const double behind = place.y() + design.back + 1.5 * design.clearance + 4;
    const double floor = place.z() - design.halfHeight - design.gap - kBufferHeight - Bay::kSlit;
    const double half = design.edgeHalf + design.gap + kRailWall + Bay::kSlit;
    std::vector<double> xs, zs;
    for (int i = 0; i <= 9; ++i) xs.push_back(place.x() + half * (2.0 * i / 9 - 1));
    for (int i = 0; i <= 5; ++i) zs.push_back(floor + 0.85 * design.halfHeight * 2 * i / 5.0);
    const auto hole = [](std::size_t column, std::size_t row) { return (column + row) % 3 == 1 ? 9.0 : 0.0; };
    bay.add("carrier_plate",
            sweepAlongY(holedSection(xs, zs, hole, bay.segmentsFor(9)), {behind, behind + 2}));
    bay.add("carrier_shelf", bay.box({place.x() - half, place.y() - 34, floor - 2.5},
                                     {place.x() + half, behind - Bay::kSlit, floor}, 6, 0.8));
    for (const double side : {1.0, -1.0}) {
        const double inner = place.x() + side * (half + 1.2 + 0.6 * design.clearance),
                     z = place.z() - design.halfHeight;
        for (const double height : {20.0, 120.0}) {
            // An angle: one leg along the rail's outside, the other along the bulkhead.
            const Polyline line{{inner, place.y() - 14}, {inner, 838}, {inner + side * 30, 838}};
            const Section angle = bay.sheet(line, 5, 1.8);
            bay.addNumbered("rail_bracket", sweepAlongZ(angle, {z + height, z + height + 36}));
            bay.addBolt({inner + side * 18, 836.8, z + height + 18}, -Vector3::UnitY(), 3);
            bay.addBolt({inner + side * 1.2, place.y(), z + height + 18}, side * Vector3::UnitX(), 2.5);
        }
    }
}

/// The wiper's tube and the strut brace, which only a tilted module can pass.
void addGate(Bay& bay) {
    const CemboxDesign& design = bay.design;
    const double free = 3 * design.clearance + 3;  // slightly more than is kept free
    const Vector3& place = design.place;
    constexpr double kTube = 12, kBrace = 13;
    const double tubeZ = place.z() + design.lift + design.top + 10 + free + kTube;
    bay.add("wiper_tube", bay.tube(bent({{-420, 835, tubeZ - 60},
                                         {-300, place.y() + 22, tubeZ},
                                         {560, place.y() + 22, tubeZ},
                                         {610, 835, tubeZ - 60}},
                                        40, bay.quarterFor(40)),
                                   kTube, 2));
    // In front of the tilted module, measured from its middle after the tilt.
    const Vector3 middle = place + Vector3(0, -25, design.lift + 15);
    const double z = place.z() + 262,
                 ahead = -design.front + kBrace + free + 6 + std::sin(design.tilt) * (z - middle.z());
    const double y = middle.y() - ahead / std::cos(design.tilt);
    bay.add("strut_brace", bay.tube(bent({{-Bay::kTowerX, Bay::kTowerY, Bay::kTowerTop + 16},
                                          {-Bay::kTowerX + 120, y, z},
                                          {Bay::kTowerX - 90, y, z},
                                          {Bay::kTowerX, Bay::kTowerY, Bay::kTowerTop + 16}},
                                         50, bay.quarterFor(50)),
                                    kBrace, 2));
}

void addSlot(Bay& bay) {
    addRailsAndBuffers(bay);
    addCarrier(bay);
    addGate(bay);
}

}  // namespace

KeptFree::KeptFree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (const Box& box : boxes_) {
        for (int i = 0; i < 8; ++i) radius_ = std::max(radius_, box.corner(corner(i)).norm());
    }
}

void KeptFree::addMotion(const PartState& from, const PartState& to, double margin) {
    const double motion =
        (to.position - from.position).norm() + radius_ * from.rotation.angularDistance(to.rotation);
    const int steps = std::max(1, static_cast<int>(std::ceil(motion / kStep)));
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        PartState state;
        state.position = (1 - share) * from.position + share * to.position;
        state.rotation = from.rotation.slerp(share, to.rotation);
        const Pose X_worldPart = poseOf(state);
        for (const Box& box : boxes_) {
            Obstacle obstacle{inverse(X_worldPart), grown(box, margin + kStep / 2), {}};
            for (int k = 0; k < 8; ++k) obstacle.inWorld.extend(X_worldPart * obstacle.box.corner(corner(k)));
            all_.extend(obstacle.inWorld);
            obstacles_.push_back(obstacle);
        }
    }
}

bool KeptFree::meets(const Vector3& a, const Vector3& b, const Vector3& c) const {
    Box bounds(a);
    bounds.extend(b), bounds.extend(c);
    if (!bounds.intersects(all_)) return false;
    for (const Obstacle& obstacle : obstacles_) {
        if (!bounds.intersects(obstacle.inWorld)) continue;
        const Vector3 middle = obstacle.box.center(), half = obstacle.box.sizes() / 2;
        const Vector3 triangle[3] = {obstacle.X_partWorld * a - middle, obstacle.X_partWorld * b - middle,
                                     obstacle.X_partWorld * c - middle};
        if (meetsBox(triangle, half)) return true;
    }
    return false;
}

bool KeptFree::isClearOf(const Piece& piece) const {
    Box bounds;
    for (const Vector3& vertex : piece.vertices) bounds.extend(vertex);
    if (!bounds.intersects(all_)) return true;
    for (const TriangleIndices& t : piece.triangles) {
        if (meets(piece.vertices[t[0]], piece.vertices[t[1]], piece.vertices[t[2]])) return false;
    }
    return true;
}

KeptFree keptFreeFor(const CemboxDesign& design) {
    constexpr double kCentring = 0.1;  // mm, see appendChords
    KeptFree room(design.envelope());
    const std::vector<PartState> states = design.path();
    for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        room.addMotion(states[i], states[i + 1], (i == 0 ? 1.5 : 3) * design.clearance + kCentring);
    }
    return room;
}

int Bay::segmentsFor(double radius) const {
    const double relative = std::clamp(std::sqrt(radius / 15), 0.5, 3.0);
    return 4 * std::max(2, static_cast<int>(std::lround(relative * (1.5 * cuts(detail) + 1))));
}

int Bay::quarterFor(double radius) const {
    const double relative = std::clamp(std::sqrt(radius / 8), 0.5, 2.0);
    return std::max(1, static_cast<int>(std::lround(1.6 * relative * cuts(detail))));
}

Piece Bay::turnedRound(const Polyline& outline) const {
    double radius = 0;
    for (const Vector2& p : outline) radius = std::max(radius, p.x());
    return turned(outline, segmentsFor(radius));
}

Piece Bay::turnedRing(const Polyline& loop) const {
    double radius = 0;
    for (const Vector2& p : loop) radius = std::max(radius, p.x());
    return ring(loop, segmentsFor(radius));
}

void Bay::addBolt(const Vector3& at, const Vector3& axis, double shank) {
    const double washer = 0.5 * shank;
    BoltShape shape;
    shape.shank = shank;
    shape.length = 4 * shank;
    shape.head = 1.7 * shank;
    shape.height = 1.4 * shank;
    const Vector3 up = axis.normalized();
    addNumbered("bolt", bolt(shape, segmentsFor(2 * shank)), at + up * (washer + kSlit), axis,
                random.between(0, M_PI));
    if (detail.richness < kWithWashers) return;
    const Polyline section{
        {1.15 * shank, 0}, {2.6 * shank, 0}, {2.6 * shank, washer}, {1.15 * shank, washer}};
    addNumbered("washer", turnedRing(section), at, axis);
}

void Bay::addBoltRow(const Vector3& from, const Vector3& to, const Vector3& axis, double shank,
                     double number) {
    const int bolts = std::max(2, detail.count(number));
    for (int i = 0; i < bolts; ++i) {
        addBolt(from + (to - from) * (static_cast<double>(i) / (bolts - 1)), axis, shank);
    }
}

Assembly buildEngineBay(const CemboxDesign& design, const KeptFree& keptFree, const Detail& detail,
                        Random random, int studs) {
    Bay bay{design, keptFree, detail, random};
    addSlot(bay);
    addBody(bay);
    addEngine(bay);
    addCooling(bay);
    addAggregates(bay);
    addLines(bay);
    addBayFittings(bay);
    addWeldStuds(bay, studs);
    return bay.assembly;
}

}  // namespace clearway::scenes
