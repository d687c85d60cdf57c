#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "demos/scenes/random.h"
#include "demos/scenes/scenes.h"
#include "demos/scenes/solids.h"

namespace clearway::scenes {

namespace {

constexpr double kBar = 5;  // mm, radius of both bars
constexpr double kPuzzleLeastClearance = 0.1, kPuzzleMostClearance = 10;
constexpr double kLeastBend = 30, kMostBend = 36;  // mm, radii
constexpr double kLoopGap = 0.6;                   // gap of an open loop, in bar radii
constexpr double kDomeRings = 3;                   // rings of each rounded end
constexpr double kPuzzleEase = 0.1;                // extra gap beyond the clearance, as a share of it
constexpr double kPathShare = 0.05;                // share of the clearance that the path's chords may use up
constexpr double kFarthest =
    150;  // mm; bounds the distance of the part's origin from its axes of rotation, for kPathShare
constexpr double kPuzzleRoom = 100;  // mm around the path's positions that planners may use

/// How finely a bar is cut.
struct BarDetail {
    int segments = 0;         ///< of the bar's section
    std::vector<int> spans;   ///< for each piece of the bar's spine
    double largestAngle = 0;  ///< between two stations of a bend
};

std::size_t barTriangles(int segments, int spans) {
    const int rows = spans + static_cast<int>(2 * kDomeRings);
    return static_cast<std::size_t>(2 * segments * rows + 2 * (segments - 2));
}

int segmentsFor(std::size_t triangles) {
    return std::max(6, static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 10))));
}

double angleOf(const Spine::Piece& piece) {
    return piece.length * piece.curvature;
}

/// Cuts straights into one span and gives the remaining triangles to the bends, always to the coarsest one.
BarDetail detailFor(const Spine& spine, std::size_t triangles, const std::string& option) {
    constexpr double kCoarsest = M_PI / 6;
    BarDetail detail;
    int spans = 0;
    for (const Spine::Piece& piece : spine.pieces()) {
        detail.spans.push_back(std::max(1, static_cast<int>(std::ceil(angleOf(piece) / kCoarsest))));
        spans += detail.spans.back();
    }
    const std::size_t least = barTriangles(segmentsFor(0), spans);
    requireTriangles(triangles, option, least);
    detail.segments = segmentsFor(triangles);
    while (barTriangles(detail.segments, spans) > triangles) --detail.segments;
    const auto coarseness = [&](std::size_t i) { return angleOf(spine.pieces()[i]) / detail.spans[i]; };
    const auto coarsest = [&] {
        std::size_t most = 0;
        for (std::size_t i = 1; i < detail.spans.size(); ++i) {
            if (coarseness(i) > coarseness(most)) most = i;
        }
        return most;
    };
    for (; barTriangles(detail.segments, spans + 1) <= triangles; ++spans) ++detail.spans[coarsest()];
    detail.largestAngle = coarseness(coarsest());
    return detail;
}

/// A round bar along the spine with rounded ends.
Piece bar(const Spine& spine, const BarDetail& detail) {
    std::vector<double> stations, scales;
    const auto add = [&](double at, double scale) {
        stations.push_back(at);
        scales.push_back(scale);
    };
    const auto dome = [&](int ring) { return M_PI_2 * ring / (kDomeRings + 0.5); };
    for (int i = static_cast<int>(kDomeRings); i > 0; --i) add(-kBar * std::sin(dome(i)), std::cos(dome(i)));
    add(0, 1);
    for (std::size_t i = 0; i < detail.spans.size(); ++i) {
        const Spine::Piece& piece = spine.pieces()[i];
        for (int k = 1; k <= detail.spans[i]; ++k) add(piece.start + piece.length * k / detail.spans[i], 1);
    }
    for (int i = 1; i <= kDomeRings; ++i) {
        add(spine.length() + kBar * std::sin(dome(i)), std::cos(dome(i)));
    }
    return sweptAlong(spine, fullSection(circle(Vector2::Zero(), kBar, detail.segments)), stations, scales);
}

/// The angle that a loop of that radius leaves open, so that its ends are kLoopGap apart.
double loopGapAngle(double radius) {
    return 2 * std::asin((2 + kLoopGap) * kBar / (2 * radius));
}

/// Makes a spine that begins with a loop, given the angle that the loop leaves open.
using LoopSpine = std::function<Spine(double gapAngle)>;

/// The distance between the middle lines of the loop's first quarter and of everything from its last quarter
/// on.
double distanceAtLoop(const Spine& spine) {
    constexpr double kApart = 0.5;  // mm between neighbouring points
    const double loop = spine.pieces()[0].length;
    std::vector<Vector3> beginning, rest;
    for (double at = 0; at < loop / 4; at += kApart) beginning.push_back(spine.frameAt(at).translation);
    for (double at = 0.75 * loop; at < spine.length(); at += kApart)
        rest.push_back(spine.frameAt(at).translation);
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3& a : beginning) {
        for (const Vector3& b : rest) least = std::min(least, (a - b).squaredNorm());
    }
    return std::sqrt(least);
}

/// The spine whose loop keeps its beginning kLoopGap away from everything that follows.
Spine withOpenLoop(const LoopSpine& spineWith) {
    double low = 0.1, high = 2.6;
    for (int i = 0; i < 20; ++i) {
        const double middle = (low + high) / 2;
        (distanceAtLoop(spineWith(middle)) < (2 + kLoopGap) * kBar ? low : high) = middle;
    }
    return spineWith(high);
}

struct Measures {
    double partBend[3], partTurn[3], partTowards[3], partStraight[3];
    double lead, handleRadius;
    double stem, foot, footTowards;

    explicit Measures(Random random) {
        const double side = random.next() % 2 == 0 ? 1 : -1;
        for (int i = 0; i < 3; ++i) {
            partBend[i] = random.between(kLeastBend, kMostBend);
            partStraight[i] = random.between(38, 48);
        }
        partTurn[0] = random.between(1.4, 1.6);
        partTurn[1] = random.between(1.5, 1.8);
        partTurn[2] = random.between(1.1, 1.4);
        partTowards[0] = M_PI_2 + side * random.between(0.1, 0.4);
        partTowards[1] = M_PI_2 - side * random.between(0.8, 1.1);
        partTowards[2] = M_PI_2 + side * random.between(0.5, 0.9);
        lead = random.between(44, 52);
        handleRadius = random.between(24, 27);
        stem = random.between(50, 70);
        foot = random.between(60, 90);
        footTowards = random.next() % 2 == 0 ? M_PI_2 : -M_PI_2;
    }
};

/// The part's spine: a loop as handle, then three bends to the free end.
Spine partSpine(const Measures& m, int version) {
    const auto spineWith = [&](double gapAngle) {
        Spine spine;
        spine.bend(m.handleRadius, 2 * M_PI - gapAngle, M_PI).straight(m.lead);
        for (int i = 0; i < 3; ++i) {
            spine.bend(m.partBend[i], m.partTurn[i], m.partTowards[i]).straight(m.partStraight[i]);
        }
        return spine;
    };
    return version == 1 ? spineWith(loopGapAngle(m.handleRadius)) : withOpenLoop(spineWith);
}

/// The environment's spine: the eye about the origin with its axis along x, then the stem down and the foot
/// to one side.
Spine environmentSpine(const Measures& m, double eyeRadius, int version) {
    constexpr double kOutward = 1.2;  // radians, from the eye's circle to the stem
    const auto spineWith = [&](double gapAngle) {
        const double loop = 2 * M_PI - gapAngle;
        const double first = kOutward - M_PI - loop;  // the eye's first angle, so that the stem points down
        Pose start;
        start.rotation.col(0) = Vector3(0, -std::sin(first), std::cos(first));
        start.rotation.col(1) = Vector3(0, -std::cos(first), -std::sin(first));
        start.rotation.col(2) = Vector3::UnitX();
        start.translation = -eyeRadius * start.rotation.col(1);
        Spine spine(start);
        spine.bend(eyeRadius, loop).bend(kLeastBend, kOutward, M_PI).straight(m.stem);
        spine.bend(kLeastBend, M_PI_2, m.footTowards).straight(m.foot);
        return spine;
    };
    return version == 1 ? spineWith(loopGapAngle(eyeRadius)) : withOpenLoop(spineWith);
}

/// The distance between a bend and its chord.
double sagittaOfArc(double radius, double angle) {
    return radius * (1 - std::cos(angle / 2));
}

/// Places the part so that the point of its middle line at that length is the middle of the eye.
PartState threaded(const Spine& part, double length) {
    const Pose X_eyePart = inverse(part.frameAt(length));
    PartState state;
    state.position = X_eyePart.translation;
    state.rotation = Eigen::Quaterniond(X_eyePart.rotation).normalized();
    return state;
}

std::vector<PartState> constructedPuzzlePath(const Spine& part, double from, double clearance) {
    const double turn = std::min(0.15, std::sqrt(8 * kPathShare * clearance / kFarthest));
    std::vector<PartState> path;
    for (const double at : part.stations(1e9, turn)) {
        if (at >= from) path.push_back(threaded(part, at));
    }
    path.push_back(threaded(part, part.length() + 4 * kBar));
    PartState goal = path.back();
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.7, Vector3(1, 2, 1).normalized()));
    goal.rotation = turned * goal.rotation;
    goal.position = turned * goal.position + Vector3(-120, 0, 60);
    path.push_back(goal);
    return path;
}

GeneratedScene makeVersion(int version, const SceneOptions& options) {
    const double clearance = options.clearance;
    requireClearance(clearance, kPuzzleLeastClearance, kPuzzleMostClearance);
    const Measures measures{Random(options.seed)};
    const Spine part = partSpine(measures, version);
    const BarDetail partDetail = detailFor(part, options.partTriangles, "part-triangles");

    // As long as no bend is narrower than the eye, the distance between the middle lines of eye and part is
    // the eye's radius (a curve's tube of a radius below that of its bends does not meet itself). Both bars,
    // their chords, the path's chords and rounding reduce that distance.
    double eyeRadius = 2 * kBar + clearance * (1 + kPuzzleEase + kPathShare) + 0.01;
    eyeRadius += sagittaOfArc(kMostBend, partDetail.largestAngle);
    const BarDetail roughly = detailFor(environmentSpine(measures, eyeRadius, version),
                                        options.environmentTriangles, "environment-triangles");
    eyeRadius +=
        1.2 *
        sagittaOfArc(eyeRadius,
                     roughly.largestAngle);  // the correction enlarges the eye and with it the correction
    const Spine environment = environmentSpine(measures, eyeRadius, version);

    GeneratedScene scene;
    scene.name = "puzzle";
    Assembly partBar, environmentBar;
    partBar.add("hook", bar(part, partDetail));
    environmentBar.add("eye", bar(environment, detailFor(environment, options.environmentTriangles,
                                                         "environment-triangles")));
    scene.part = partBar.mesh();
    scene.environment = environmentBar.mesh();
    const double lead = part.pieces()[1].start + measures.lead / 2;
    scene.path = constructedPuzzlePath(part, lead, clearance);
    statePathAsProblem(scene, kPuzzleRoom);
    scene.problem.name = "puzzle v" + std::to_string(version);
    scene.problem.fineness = kBar / 2;
    return scene;
}

}  // namespace

GeneratedScene makePuzzle(const SceneOptions& options) {
    return makeVersion(1, options);
}

GeneratedScene makePuzzle2(const SceneOptions& options) {
    return makeVersion(2, options);
}

}  // namespace clearway::scenes
