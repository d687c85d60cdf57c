#include "support/crowded_scene.h"

#include <cmath>

#include "clearway/shrink.h"
#include "planning/space/ompl_states.h"
#include "support/random_meshes.h"
#include "support/winding.h"

namespace clearway::testing {
namespace {

/// Reaches tell clearances up to this share of the part's diagonal.
constexpr double kReachedClearance = 0.3;

Box roomAround(const Vector3& centre, const Vector3& halfSides) {
    return Box((centre - halfSides).eval(), (centre + halfSides).eval());
}

/// The positions of the part's origin, wherever the body is in its room and however it is turned.
Box positionsOf(const CrowdedLayout& layout) {
    Vector3 more = Vector3::Constant(layout.bodyInPart.norm());
    if (layout.kind == Space::kSe2) more.z() = 0;
    return Box((layout.room.min() + layout.at - more).eval(), (layout.room.max() + layout.at + more).eval());
}

/// A range for the bounds, which may be exceeded by rounding. Its cap is the margin and some clearance more.
QueryRange rangeOf(const CrowdedLayout& layout, const Model& part, double margin) {
    const Box positions = positionsOf(layout);
    const Vector3 slack = Vector3::Constant(1e-9 * (positions.diagonal().norm() + layout.at.norm()));
    const double radius = part.radiusAboutOrigin();
    return {Box((positions.min() - slack).eval(), (positions.max() + slack).eval()), radius,
            margin + kReachedClearance * part.box().diagonal().norm()};
}

Obstacle obstacleOf(const CrowdedLayout& layout, const CrowdedLayout::Piece& piece, const Model& part) {
    Mesh mesh = translated(piece.mesh, layout.at);
    std::optional<QueryRange> range;
    if (layout.hasRange) {
        range = rangeOf(layout, part, piece.margin);
        const double away = 4 * (range->positions.diagonal().norm() + range->partRadius + range->cap);
        mesh = joined(mesh, translated(box({1, 1, 1}), layout.at + Vector3(away, 0, 0)));
    }
    const bool mayEnter = piece.overlap > 0;
    if (piece.isItselfShrunk) mesh = shrink(mesh, {piece.overlap}).mesh;
    Obstacle obstacle{Model::build(mesh, {}, range), piece.margin};
    if (piece.isSolid || mayEnter) obstacle.solids = makeSolids(mesh).solids;
    if (piece.isItselfShrunk) {
        obstacle.shrunkBy = piece.overlap;
    } else if (mayEnter) {
        const ShrunkPart shrunk = shrink(translated(layout.body, layout.bodyInPart), {piece.overlap});
        obstacle.shrunk = shrunkModel(shrunk, Model::build(shrunk.mesh));
    }
    obstacle.isIgnoredAtStart = piece.isIgnoredAtStart;
    obstacle.isIgnoredAtGoal = piece.isIgnoredAtGoal;
    return obstacle;
}

Scene sceneOf(const CrowdedLayout& layout) {
    const Mesh partMesh = translated(layout.body, layout.bodyInPart);
    Scene scene(Model::build(partMesh));
    scene.partSolids = makeSolids(partMesh).solids;
    for (const auto& piece : layout.pieces) scene.obstacles.push_back(obstacleOf(layout, piece, scene.part));
    return scene;
}

CrowdedLayout::Place placeAt(const Vector3& position, double angle = 0,
                             const Vector3& axis = Vector3::UnitZ()) {
    CrowdedLayout::Place place;
    place.body.position = position;
    place.body.rotation = Eigen::AngleAxisd(angle, axis.normalized());
    return place;
}

CrowdedLayout::Place assembledAt(const Vector3& position, double angle, const Vector3& wayOut) {
    CrowdedLayout::Place place = placeAt(position, angle);
    place.wayOut = wayOut;
    return place;
}

double largestOf(const Box& box) {
    return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

double roundingOf(const Scene& scene, const Box& positions) {
    const Box environment = scene.environmentBox();
    const double size = environment.diagonal().norm() + scene.part.box().diagonal().norm();
    const double largest = largestOf(environment) + largestOf(positions) + scene.part.radiusAboutOrigin() +
                           scene.largestMargin();
    return 2 * (1e-12 * size + 32 * 0x1p-53 * largest);
}

}  // namespace

CrowdedScene::CrowdedScene(const CrowdedLayout& layout)
    : name(layout.name),
      kind(layout.kind),
      places(layout.places),
      spread(layout.spread),
      turn(layout.turn),
      bodyInPart(layout.bodyInPart),
      scene(sceneOf(layout)),
      space(planning::makeSpace(kind, positionsOf(layout), 1)),
      si(std::make_shared<ob::SpaceInformation>(space)),
      mostClearance(layout.hasRange ? 0.99 * kReachedClearance * scene.part.box().diagonal().norm()
                                    : std::numeric_limits<double>::infinity()),
      diagonal(scene.part.box().diagonal().norm()),
      rounding(roundingOf(scene, positionsOf(layout))) {
    for (CrowdedLayout::Place& place : places) place.body.position += layout.at;
    const auto zone = [&](std::size_t place, double length) {
        return ContactZone{poseOf(partState(places[place].body)), length};
    };
    if (layout.startZone > 0) scene.startContact = zone(0, layout.startZone);
    if (layout.goalZone > 0) scene.goalContact = zone(1, layout.goalZone);
    checker = std::make_shared<planning::ValidityChecker>(si, scene);
    validator = std::make_shared<planning::MotionValidator>(si, scene, limit.options());
    planning::MotionOptions options;
    options.leastInterval = 0.01 * validator->leastInterval();
    close = std::make_shared<planning::MotionValidator>(si, scene, options);
    si->setStateValidityChecker(checker);
    si->setMotionValidator(validator);
    si->setup();
}

PartState CrowdedScene::partState(const PartState& body) const {
    PartState state = body;
    state.position -= body.rotation.normalized() * bodyInPart;
    return state;
}

PartState CrowdedScene::bodyState(const ob::State* state) const {
    PartState body = planning::fromOmpl(kind, state);
    body.position += body.rotation.normalized() * bodyInPart;
    return body;
}

namespace {

Mesh movedTo(const Vector3& place, const Mesh& mesh) {
    return translated(mesh, place);
}

/// Triangles 1000 times longer than wide.
Mesh needleCloud(Random& random, int count, double halfSide, double length) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vector3 centre = random.inBox(halfSide), along = 0.5 * length * random.direction();
        const Vector3 aside = 1e-3 * length * along.cross(random.direction()).normalized();
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {centre - along, centre + along, centre - along + aside});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Four obstacles, each with its margin, around a bracket.
CrowdedLayout yard() {
    CrowdedLayout layout;
    layout.name = "yard";
    layout.body = bracket(10, 1, 2, 3);
    layout.pieces = {{movedTo({-20, 0, 0}, sphere(8, 6)), 0},
                     {movedTo({20, 0, 0}, box({4, 20, 20}, 2)), 2},
                     {movedTo({0, 0, -20}, torus(12, 3, 10)), 0.5},
                     {movedTo({0, 25, 0}, tube(10, 12, 30, 12)), 6}};
    layout.room = roomAround({0, 0, 0}, {40, 45, 45});
    layout.places = {placeAt({0, 0, 5}, 1), placeAt({0, -15, 5}, 2, {1, 2, 3}),
                     placeAt({0, 0, -20}, 1, {1, 0, 0}), placeAt({-30, 15, 10})};
    layout.spread = 15;
    return layout;
}

/// A plate rests on a solid tray between two rails, and a solid post sticks in it. Its goal is a shelf beyond
/// a wall.
CrowdedLayout assembly() {
    CrowdedLayout layout;
    layout.name = "assembly";
    layout.body = box({3, 2, 0.5}, 2);
    const Mesh rail = box({3, 0.2, 0.8});
    layout.pieces = {{movedTo({7.5, 0, -1.5}, box({0.5, 8, 2})), 0.05, true},
                     {movedTo({0, 0, -0.5}, box({4, 3, 0.5}, 2)), 0.1, true, true},
                     {joined(movedTo({0, 2.3, 0}, rail), movedTo({0, -2.3, 0}, rail)), 0, false, true, true},
                     {movedTo({-3, 0, 0.5}, box({0.7, 0.5, 4})), 0.02, true, true},
                     {movedTo({15, 0, -0.5}, box({4, 4, 0.5}, 2)), 0.2, true, false, true}};
    layout.room = roomAround({7, 0, 2}, {18, 12, 8});
    layout.places = {assembledAt({0, 0, 0.5}, 0, {0.6, 0, 0.8}), assembledAt({15, 0, 0.5}, 0.5, {0, 0, 1}),
                     placeAt({0, 0, 2.5}), placeAt({7, 0, 2.5}, 0.3), placeAt({15, 0, 1.5}, 0.5)};
    layout.spread = 1.5;
    layout.turn = 0.4;
    layout.startZone = 2;
    layout.goalZone = 0.6;
    return layout;
}

/// A part of two pieces at and in solids with cavities. It starts half inside a block, and the zone that allows
/// it reaches into the block, where the part is all inside.
CrowdedLayout shells() {
    CrowdedLayout layout;
    layout.name = "shells";
    layout.body = joined(box({0.5, 1, 1.5}), movedTo({4, 0, 0}, sphere(1, 5)));
    layout.pieces = {{joined(box({9, 9, 9}), reversed(box({6, 6, 6}))), 0.1, true},
                     {movedTo({0, 0, 22}, torus(8, 3, 10)), 0, true},
                     {movedTo({28, 0, 0}, box({8, 9, 10}, 2)), 0.03, true, true},
                     {movedTo({28, 0, 24}, box({9, 9, 9})), 0, true, false, true},
                     {movedTo({-24, 0, 22}, box({7, 7, 7})), 0.2, true}};
    layout.room = roomAround({2, 0, 8}, {42, 22, 30});
    layout.places = {assembledAt({17, 0, 1}, 0, {-0.6, 0.8, 0}),
                     assembledAt({27, 3, 14.5}, 0.5, {0, 0, -1}),
                     placeAt({-2, 0, 0}),
                     placeAt({-3, 1, 22}, 1),
                     placeAt({28, 0, 0}),
                     placeAt({8, 12, 12}, 2),
                     placeAt({-24, 0, 22}, 1)};
    layout.spread = 4;
    layout.startZone = 7;
    layout.goalZone = 2;
    return layout;
}

/// A plate in the plane among solids; it starts and ends in contact.
CrowdedLayout plane() {
    CrowdedLayout layout;
    layout.name = "plane";
    layout.kind = Space::kSe2;
    layout.body = box({3, 2, 0.5});
    const Mesh post = box({1, 3, 1});
    layout.pieces = {{movedTo({-5, 0, 0}, box({2, 3, 1})), 0.1, true, true},
                     {movedTo({22, 0, 0}, box({4, 6, 2}, 2)), 0.2, true, false, true},
                     {movedTo({8, 0, 0}, tube(1.5, 2, 4, 10)), 0, true},
                     {joined(movedTo({8, 7, 0}, post), movedTo({8, -7, 0}, post)), 0.5}};
    layout.room = roomAround({8, 0, 0}, {18, 14, 0});
    layout.places = {assembledAt({0, 0, 0}, 0, {1, 0, 0}), assembledAt({14.9, 0, 0}, 0.1, {-1, 0, 0}),
                     placeAt({2, 3, 0}, 1), placeAt({13, -6, 0}, 2)};
    layout.spread = 4;
    layout.turn = 2;
    layout.startZone = 0.5;
    layout.goalZone = 1;
    return layout;
}

/// A cross-shaped plate is pressed into a tray and between two rails, and ends pressed into a block.
CrowdedLayout pressFit() {
    CrowdedLayout layout;
    layout.name = "press fit";
    layout.body = joined(box({3, 2, 0.5}, 2), movedTo({0, 0, 1}, box({1, 0.4, 0.8})));
    const Mesh rail = box({3, 0.2, 0.8});
    layout.pieces = {{movedTo({0, 0, -0.45}, box({4, 3, 0.5}, 2)), 0, false, false, false, 0.2},
                     {joined(movedTo({0, 2.15, 0.5}, rail), movedTo({0, -2.15, 0.5}, rail)), 0, false, false,
                      false, 0.15, true},
                     {movedTo({11, 0, 0.5}, box({2, 4, 2}, 2)), 0, true, false, false, 0.3, true},
                     {movedTo({5, 0, 4}, sphere(1, 5)), 0.1}};
    layout.room = roomAround({4, 0, 2}, {14, 10, 8});
    layout.places = {assembledAt({0, 0, 0.5}, 0, {0, 0, 1}), assembledAt({6.1, 0, 0.5}, 0, {-1, 0, 0}),
                     placeAt({0, 0, 2.5}), placeAt({6, 0, 0.5}, 0.3)};
    layout.spread = 1;
    layout.turn = 0.4;
    return layout;
}

CrowdedLayout needleWork() {
    Random random(5);
    CrowdedLayout layout;
    layout.name = "needles";
    layout.body = needleCloud(random, 6, 1, 8);
    layout.pieces = {{needleCloud(random, 40, 12, 10), 0}, {needleCloud(random, 30, 12, 10), 0.02}};
    layout.room = roomAround({0, 0, 0}, {20, 20, 20});
    layout.places = {placeAt({0, 0, 0}), placeAt({6, 6, 6}, 1), placeAt({-6, 5, -8}, 2, {1, 0, 0}),
                     placeAt({-8, -8, 8})};
    layout.spread = 8;
    return layout;
}

/// far: how far from the origin the environment is. offCentre: how far from the part's origin the body is.
CrowdedLayout changed(CrowdedLayout layout, const std::string& name, double far, double offCentre,
                      bool hasRange) {
    const bool isPlanar = layout.kind == Space::kSe2;
    layout.name = name;
    layout.at = far * Vector3(0.6, -0.7, isPlanar ? 0 : 0.5);
    layout.bodyInPart = offCentre * Vector3(0.5, 0.8, isPlanar ? 0 : -0.3);
    layout.hasRange = hasRange;
    if (offCentre > 100) layout.turn = 30 / offCentre;  // larger turns would swing the body far away
    return layout;
}

}  // namespace

std::vector<CrowdedLayout> crowdedLayouts() {
    return {yard(),
            assembly(),
            shells(),
            plane(),
            pressFit(),
            needleWork(),
            changed(yard(), "yard, range", 0, 0, true),
            changed(plane(), "plane, range", 0, 0, true),
            changed(assembly(), "assembly, far", 7e5, 0, false),
            changed(plane(), "plane, far, off centre, range", 7e5, 40, true),
            changed(needleWork(), "needles, far", 1e6, 0, false),
            changed(pressFit(), "press fit, far, off centre, range", 1e4, 40, true),
            changed(shells(), "shells, off centre", 0, 200, false),
            changed(assembly(), "assembly, far off centre", 0, 7e5, false),
            changed(shells(), "shells, far off centre", 0, 1e5, false),
            changed(shells(), "shells, far, off centre, range", 1e6, 100, true)};
}

}  // namespace clearway::testing
