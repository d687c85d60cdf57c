#include "program/scenes/cembox_design.h"

#include <cmath>

namespace clearway::scenes {

namespace {

constexpr double kLeastClearance = 0.5,
                 kMostClearance = 8;  // mm; beyond, the rails do not hold the edges

/// The gap is this much of the clearance wider than it must be: sampling planners need a little more than
/// nothing.
constexpr double kEase = 0.15;

constexpr double kRounding = 0.01;  // mm, more than rounding to float takes
constexpr int kChords = 10;         // of a motion that turns the part

/// Between two states of the design's frame. The part is turned about its centred origin later, which lies
/// elsewhere; in short chords that makes no difference but for hundredths of a millimetre.
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

KeptFree CemboxDesign::keptFree() const {
    constexpr double kCentring = 0.1;  // mm, see appendChords
    KeptFree room(envelope());
    const std::vector<PartState> states = path();
    for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        room.addMotion(states[i], states[i + 1], (i == 0 ? 1.5 : 3) * clearance + kCentring);
    }
    return room;
}

CemboxDesign designCembox(const SceneOptions& options) {
    const double clearance = options.clearance;
    requireClearance(clearance, kLeastClearance, kMostClearance);
    Random random(options.seed);
    CemboxDesign design;
    design.clearance = clearance;
    design.gap = clearance * (1 + kEase) + kRounding;
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

}  // namespace clearway::scenes
