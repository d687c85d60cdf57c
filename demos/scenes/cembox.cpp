// The scene cembox: its measures, the way out, and the control module: a housing with lid, fins and ribs
// between two guide edges, connectors on top, and the circuit board inside.
#include "demos/scenes/cembox.h"

#include <algorithm>
#include <cmath>

#include "demos/scenes/cembox_bay.h"
#include "demos/scenes/random.h"
#include "demos/scenes/solids.h"

namespace clearway::scenes {

namespace {

constexpr double kCemboxLeastClearance = 0.5,
                 kCemboxMostClearance = 8;  // mm; with more, the rails do not hold the edges

/// Extra gap beyond the clearance, as a share of it: sampling planners need some room.
constexpr double kCemboxEase = 0.15;

constexpr double kCemboxRounding = 0.01;  // mm; covers rounding to float
constexpr int kChords = 10;               // per motion that turns the part

/// Appends a motion to `to` in short chords. Later the part turns about its centred origin, which lies
/// elsewhere. With short chords this changes the motion by only hundredths of a millimetre.
void appendChords(std::vector<PartState>& path, const PartState& to) {
    const PartState from = path.back();
    for (int i = 1; i <= kChords; ++i) {
        const double share = static_cast<double>(i) / kChords;
        PartState state;
        state.position = (1 - share) * from.position + share * to.position;
        state.rotation = from.rotation.slerp(share, to.rotation);
        path.push_back(state);
    }
}

constexpr double kCemboxSlit = 0.2;  // mm between components, so that no two touch
constexpr double kBoard = 4;         // y of the circuit board's front
constexpr double kBoardThickness = 1.6;
constexpr double kBoardInside = 9;  // from the body's outside to the board's edge
constexpr int kConnectors = 3;
constexpr double kConnectorHalf = 29;  // half a connector's width
constexpr double kStudPitch = 3.4;     // mm between solder points

struct CemboxBuilder {
    const CemboxDesign& design;
    const Detail& detail;
    Random random;
    Assembly assembly{};

    /// Places a piece that was made on z = 0 on the front of a face at y.
    static Piece onFront(const Piece& piece, double x, double y, double z) {
        return placed(piece, facing({x, y, z}, Vector3::UnitX(), -Vector3::UnitY()));
    }
    Piece box(const Vector3& low, const Vector3& high, double corner, double edge) const {
        return roundedBox(low, high, corner, edge, detail.segmentsPerQuarter);
    }
    double boardHalf() const { return design.bodyHalf - kBoardInside; }
    double boardHalfHeight() const { return design.halfHeight - kBoardInside; }

    void addHousing();
    void addGuideEdges();
    void addUprights(const std::string& name, int number, double from, double to, double thickness);
    void addVents();
    void addLidScrews();
    void addConnector(double x);
    void addLugs();
    void addBoard();
    void addChips();
    void addStuds(int studs);
};

/// The housing is a tray that the lid closes.
void CemboxBuilder::addHousing() {
    const double half = design.bodyHalf, height = design.halfHeight, joint = -18;
    const Piece base =
        tray({-half, -height, 0}, {half, height, design.base - joint}, 9, 2.5, detail.segmentsPerQuarter);
    assembly.add("housing_base", onFront(base, 0, design.base, 0));
    const double depth = joint - kCemboxSlit - design.lid;
    assembly.add("housing_lid",
                 onFront(box({-half, -height, 0}, {half, height, depth}, 9, 4), 0, design.lid + depth, 0));
}

void CemboxBuilder::addGuideEdges() {
    const double inner = design.bodyHalf + kCemboxSlit, outer = design.edgeHalf, t = design.edgeThickness / 2;
    const int cells = std::max(4, static_cast<int>(std::lround(6 * std::sqrt(detail.richness))));
    std::vector<double> heights;
    for (int i = 0; i <= cells; ++i) heights.push_back(design.halfHeight * (2.0 * i / cells - 1));
    const double room = 0.5 * std::min(outer - inner, 2 * design.halfHeight / cells);
    const auto hole = [&](std::size_t, std::size_t row) { return row % 2 == 1 ? 0.55 * room : 0.0; };
    for (const double side : {1.0, -1.0}) {
        const std::vector<double> xs =
            side > 0 ? std::vector<double>{inner, outer} : std::vector<double>{-outer, -inner};
        assembly.add(side > 0 ? "guide_edge_left" : "guide_edge_right",
                     sweepAlongY(holedSection(xs, heights, hole, detail.segmentsPerTurn), {-t, t}));
    }
}

/// Fins or ribs: plates that stand off the body between two y, their outer ends rounded.
void CemboxBuilder::addUprights(const std::string& name, int number, double from, double to,
                                double thickness) {
    const double reach = 0.72 * design.bodyHalf, depth = std::abs(to - from), half = thickness / 2;
    const Polyline tip = filleted({{half, 0}, {half, depth}, {-half, depth}, {-half, 0}},
                                  {0.9 * half, 0.9 * half}, detail.segmentsPerQuarter);
    for (int i = 0; i < number; ++i) {
        const double x = number > 1 ? reach * (2.0 * i / (number - 1) - 1) : 0;
        Polyline loop;
        for (const Vector2& p : tip) loop.push_back({x + p.x(), to > from ? from + p.y() : from - p.y()});
        if (to < from) std::reverse(loop.begin(), loop.end());
        const double height = design.halfHeight * random.between(0.8, 0.92);
        assembly.addNumbered(name, sweepAlongZ(fullSection(loop), {-height, height}));
    }
}

/// Grilles between the ribs.
void CemboxBuilder::addVents() {
    const int rows = std::max(3, static_cast<int>(std::lround(4 * std::sqrt(detail.richness))));
    std::vector<double> xs, zs;
    for (int i = 0; i <= 3; ++i) xs.push_back(-9 + 6 * i);
    for (int i = 0; i <= rows; ++i) zs.push_back(0.5 * design.halfHeight * (2.0 * i / rows - 1));
    const double radius = 0.32 * std::min(6.0, zs[1] - zs[0]);
    const Section grille = holedSection(
        xs, zs, [&](std::size_t, std::size_t) { return radius; }, detail.segmentsPerTurn);
    const double y = design.base + kCemboxSlit;
    for (const double x : {-0.36 * design.bodyHalf, 0.36 * design.bodyHalf}) {
        Section there = grille;
        for (Vector2& p : there.points) p.x() += x;
        assembly.addNumbered("vent_grille", sweepAlongY(there, {y, y + 1.2}));
    }
}

void CemboxBuilder::addLidScrews() {
    BoltShape shape;
    shape.shank = 2;
    shape.length = 8;
    shape.head = 3.4;
    shape.height = 3.6;
    const Piece screw = bolt(shape, detail.segmentsPerTurn);
    const double x = design.bodyHalf - 14, z = design.halfHeight - 13;
    const int rows = std::max(2, static_cast<int>(std::lround(3 * std::sqrt(detail.richness))));
    for (int i = 0; i < 2 * rows; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        assembly.addNumbered("lid_screw", onFront(screw, side * x, design.lid - kCemboxSlit,
                                                  z * (2.0 * (i / 2) / (rows - 1) - 1)));
    }
}

/// A shroud, open above, with its pins.
void CemboxBuilder::addConnector(double x) {
    const double from = design.halfHeight + kCemboxSlit, height = design.top - from - 0.5, depth = 21;
    const Piece shroud = tray({x - kConnectorHalf, -depth, from}, {x + kConnectorHalf, depth, from + height},
                              6, 2, detail.segmentsPerQuarter);
    assembly.addNumbered("connector_shroud", shroud);
    const int columns = std::clamp(detail.count(3), 3, 12);
    const int rows = std::clamp(detail.count(2), 2, 5);
    const double inner = kConnectorHalf - 7, wall = from + 2 + kCemboxSlit, tip = from + height - 6;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Vector2 at(x + inner * (2.0 * column / (columns - 1) - 1),
                             (depth - 7) * (2.0 * row / (rows - 1) - 1));
            const Vector2 half(0.8, 0.5);
            const auto square = [&](double scale) {
                return Polyline{at + scale * half, at + scale * Vector2(-half.x(), half.y()),
                                at - scale * half, at + scale * Vector2(half.x(), -half.y())};
            };
            assembly.addNumbered("pin",
                                 stacked({{square(1), wall}, {square(1), tip}, {square(0.4), tip + 1.5}}));
        }
    }
}

/// Ears with a hole, beside the connectors.
void CemboxBuilder::addLugs() {
    const double half = 9, z = design.halfHeight + kCemboxSlit + half;
    const int n = detail.segmentsPerTurn;
    for (const double side : {1.0, -1.0}) {
        const Vector2 centre(side * (design.topHalf - half), z);
        const Section ear = ringSection(squareAround(centre, half, n), circle(centre, 4.2, n, M_PI_4));
        for (const double y : {-16.0, 13.0}) assembly.addNumbered("screw_lug", sweepAlongY(ear, {y, y + 3}));
        const Polyline bush{{2.2, 0}, {3.4, 0}, {3.4, 26}, {2.2, 26}};
        assembly.addNumbered("lug_bush", placed(ring(bush, n), facing({centre.x(), -13 + kCemboxSlit, z},
                                                                      Vector3::UnitX(), Vector3::UnitY())));
    }
}

void CemboxBuilder::addBoard() {
    const double x = boardHalf(), z = boardHalfHeight();
    const std::vector<double> xs{-x, -x + 9, -0.3 * x, 0.25 * x, x - 9, x},
        zs{-z, -z + 9, -0.1 * z, z - 9, z};
    const auto hole = [&](std::size_t column, std::size_t row) {
        return (column == 0 || column + 2 == xs.size()) && (row == 0 || row + 2 == zs.size()) ? 2.2 : 0.0;
    };
    assembly.add("circuit_board", sweepAlongY(holedSection(xs, zs, hole, detail.segmentsPerTurn),
                                              {kBoard, kBoard + kBoardThickness}));
}

/// Chips in the cells of a grid on the front of the board, so that they do not meet.
void CemboxBuilder::addChips() {
    const int columns = std::clamp(static_cast<int>(std::lround(4 * std::sqrt(detail.richness))), 4, 14);
    const int rows = std::max(3, columns * 3 / 4);
    const double width = 2 * (boardHalf() - 10) / columns, height = 2 * (boardHalfHeight() - 10) / rows;
    const double room = std::min(width, height) / 2 - 1, y = kBoard - kCemboxSlit;
    for (int i = 0; i < columns * rows; ++i) {
        const double x = width * (i % columns + 0.5) - boardHalf() + 10;
        const double z = height * (i / columns + 0.5) - boardHalfHeight() + 10;
        const double size = room * random.between(0.45, 0.9),
                     tall = std::min(random.between(0.8, 2.2) * size, 17.0);
        switch (random.next() % 4) {
            case 0:
                assembly.addNumbered("capacitor",
                                     onFront(turned(filleted({{0, 0}, {size, 0}, {size, tall}, {0, tall}},
                                                             {0, 0.3 * size}, detail.segmentsPerQuarter),
                                                    detail.segmentsPerTurn),
                                             x, y, z));
                break;
            case 1:
                assembly.addNumbered(
                    "coil", onFront(ring(circle({0.7 * size, 0.3 * size}, 0.3 * size, detail.segmentsPerTurn),
                                         detail.segmentsPerTurn),
                                    x, y, z));
                break;
            default: {
                const Vector3 half(size, size * random.between(0.5, 1), 0);
                assembly.addNumbered("chip", onFront(box(-half, half + Vector3(0, 0, 0.4 * tall),
                                                         0.2 * half.y(), 0.1 * half.y()),
                                                     x, y, z));
            }
        }
    }
}

/// Solder points behind the board.
void CemboxBuilder::addStuds(int studs) {
    const Piece dome = turned(domeOutline(1.2, 0.9, detail.segmentsPerQuarter), detail.segmentsPerTurn);
    const int columns = static_cast<int>(2 * (boardHalf() - 12) / kStudPitch);
    const int rows = static_cast<int>(2 * (boardHalfHeight() - 12) / kStudPitch);
    for (int i = 0; i < studs; ++i) {
        const double x = kStudPitch * (i % columns) - boardHalf() + 12;
        const double z = kStudPitch * (i / columns % rows) - boardHalfHeight() + 12;
        assembly.addNumbered("solder_point",
                             placed(dome, facing({x, kBoard + kBoardThickness + kCemboxSlit, z},
                                                 Vector3::UnitX(), Vector3::UnitY())));
    }
}

constexpr double kCemboxRoom = 120;  // mm around the path's positions that planners may use
constexpr FinenessRange kCemboxFineness{60, 0.1};

}  // namespace

std::vector<Box> CemboxDesign::envelope() const {
    const double edge = edgeThickness / 2;
    return {{Vector3(-bodyHalf, front, -halfHeight), Vector3(bodyHalf, back, halfHeight)},
            {Vector3(-edgeHalf, -edge, -halfHeight), Vector3(edgeHalf, edge, halfHeight)},
            {Vector3(-topHalf, -topDepth, halfHeight), Vector3(topHalf, topDepth, top)}};
}

std::vector<PartState> CemboxDesign::path() const {
    PartState state;
    state.position = place;
    std::vector<PartState> path{state};
    state.position += Vector3(0, 0, lift);
    path.push_back(state);
    state.position += Vector3(0, -25, 15);
    state.rotation = Eigen::AngleAxisd(tilt, Vector3::UnitX());
    appendChords(path, state);
    state.position += state.rotation * Vector3(0, 0, slide);
    path.push_back(state);
    state.position += Vector3(30, 0, 40);
    state.rotation = Eigen::AngleAxisd(0.12, Vector3::UnitZ()) * state.rotation;
    appendChords(path, state);
    return path;
}

CemboxDesign designCembox(const SceneOptions& options) {
    const double clearance = options.clearance;
    requireClearance(clearance, kCemboxLeastClearance, kCemboxMostClearance);
    Random random(options.seed);
    CemboxDesign design;
    design.clearance = clearance;
    design.gap = clearance * (1 + kCemboxEase) + kCemboxRounding;
    design.bodyHalf = random.between(125, 129);
    design.edgeHalf = random.between(148, 152);
    design.topHalf = design.bodyHalf - 6;
    design.halfHeight = random.between(98, 102);
    design.railTop = design.halfHeight - 2;
    design.top = design.halfHeight + random.between(32, 36);
    design.lift = 2 * design.halfHeight + 2 + 2 * design.gap;
    design.place.x() += random.between(-20, 20);
    design.place.z() += random.between(-6, 6);
    return design;
}

Assembly buildModule(const CemboxDesign& design, const Detail& detail, Random random, int studs) {
    CemboxBuilder builder{design, detail, random};
    builder.addHousing();
    builder.addGuideEdges();
    const int fins = std::clamp(detail.count(7), 7, 30);
    builder.addUprights("fin", fins, design.lid - kCemboxSlit, design.front, 2.2);
    builder.addUprights("rib", 4, design.base + kCemboxSlit, design.back, 2.5);
    builder.addVents();
    builder.addLidScrews();
    for (int i = 0; i < kConnectors; ++i)
        builder.addConnector((i - 0.5 * (kConnectors - 1)) * 2.3 * kConnectorHalf);
    builder.addLugs();
    builder.addBoard();
    builder.addChips();
    builder.addStuds(studs);
    return builder.assembly;
}

GeneratedScene makeCembox2(const SceneOptions& options) {
    const CemboxDesign design = designCembox(options);
    const KeptFree keptFree = keptFreeFor(design);
    const Random partRandom(options.seed ^ 0xCE3B0Cu), bayRandom(options.seed ^ 0xE36B4Eu);
    GeneratedScene scene;
    scene.name = "cembox";
    scene.part = buildTo(
        options.partTriangles, "part-triangles", kCemboxFineness,
        {"housing", "guide_edge", "connector_shroud", "solder_point"},
        [&](const Detail& detail, int studs) { return buildModule(design, detail, partRandom, studs); });
    // Components that hold the module or limit its way stay.
    scene.environment =
        buildTo(options.environmentTriangles, "environment-triangles", kCemboxFineness,
                {"guide_rail", "buffer", "wiper_tube", "strut_brace", "bulkhead", "weld_stud"},
                [&](const Detail& detail, int studs) {
                    return buildEngineBay(design, keptFree, detail, bayRandom, studs);
                });
    scene.path = design.path();
    statePathAsProblem(scene, kCemboxRoom);
    scene.problem.name = "cembox v2";
    scene.problem.fineness = design.thinnestSheet / 2;
    return scene;
}

}  // namespace clearway::scenes
