#include <cmath>
#include <functional>

#include "demos/scenes/section.h"
#include "demos/scenes/solids.h"
#include "support/assembled_problems.h"
#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

using scenes::Assembly;
using scenes::Piece;
using scenes::Polyline;
using scenes::Vector2;

constexpr double kDegree = M_PI / 180;
constexpr double kFacet = 2.5;  ///< degrees

Vector3 atAngle(double radius, double angle, double z) {
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

const Eigen::AngleAxisd kTilt(0.7, Vector3(1, 2, 3).normalized());

AssembledProblem tilted(const std::string& name, const Assembly& part, const Assembly& environment,
                        const Vector3& shift = Vector3::Zero(), const Eigen::AngleAxisd& turn = kTilt) {
    const Pose X{turn.toRotationMatrix(), shift};
    return {name, transformed(part.mesh(), X), transformed(environment.mesh(), X)};
}

Piece blockBetween(const Vector3& low, const Vector3& high) {
    return scenes::sweepAlongZ(scenes::rectangleSection({low.x(), low.y()}, {high.x(), high.y()}),
                               {low.z(), high.z()});
}

/// The part of a ring between two angles, in degrees.
Piece sector(const Vector2& radii, const Vector2& angles, const Vector2& heights) {
    const int parts = std::max(1, int(std::ceil((angles[1] - angles[0]) / kFacet)));
    Polyline inner, outer;
    for (int i = 0; i <= parts; ++i) {
        const double angle = kDegree * (angles[0] + (angles[1] - angles[0]) * i / parts);
        inner.push_back(radii[0] * Vector2(std::cos(angle), std::sin(angle)));
        outer.push_back(radii[1] * Vector2(std::cos(angle), std::sin(angle)));
    }
    return scenes::sweepAlongZ(scenes::bandSection(inner, outer), {heights[0], heights[1]});
}

/// Surfaces of a solid that share vertices.
class Skin {
  public:
    std::uint32_t add(const Vector3& point) {
        piece.vertices.push_back(point);
        return std::uint32_t(piece.vertices.size() - 1);
    }
    /// Counter-clockwise seen from outside.
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        piece.triangles.push_back({a, b, c});
        piece.triangles.push_back({a, c, d});
    }
    /// The band between two loops, the second one on the left of the first.
    void band(const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second) {
        for (std::size_t k = 0; k < first.size(); ++k) {
            const std::size_t next = (k + 1) % first.size();
            quad(first[k], first[next], second[next], second[k]);
        }
    }
    /// The end of a ring between two borders of helix surfaces, of which the second one closes with a step of one line.
    void end(const std::vector<std::uint32_t>& inner, const std::vector<std::uint32_t>& outer, bool isAbove) {
        const std::size_t step = outer.size() - 1;
        const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            if (isAbove) std::swap(a, b);
            piece.triangles.push_back({a, b, c});
        };
        for (std::size_t k = 0; k < step; ++k) {
            triangle(inner[k], inner[k + 1], outer[k + 1]);
            triangle(inner[k], outer[k + 1], outer[k]);
        }
        for (std::size_t k = step; k < inner.size(); ++k)
            triangle(inner[k], inner[(k + 1) % inner.size()], outer[step]);
        triangle(inner[0], outer[0], outer[step]);
    }
    /// The fan on the left of a loop.
    void fan(const std::vector<std::uint32_t>& loop, const Vector3& middle) {
        const std::uint32_t centre = add(middle);
        for (std::size_t k = 0; k < loop.size(); ++k)
            piece.triangles.push_back({loop[k], loop[(k + 1) % loop.size()], centre});
    }
    Piece piece;
};

std::vector<std::uint32_t> reversed(std::vector<std::uint32_t> loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

/// A point of a thread's profile, along one pitch.
struct ProfilePoint {
    double z, radius;
};
using ThreadProfile = std::vector<ProfilePoint>;

/// A surface whose rows follow the helix: the end of a row after a turn is the beginning of the row one pitch further on.
class HelixSurface {
  public:
    HelixSurface(Skin& skin, const ThreadProfile& profile, double pitch, double from, int turns, int segments)
        : segments_(segments), perPitch_(int(profile.size())), rows_(turns * int(profile.size())) {
        for (int row = 0; row <= rows_ + perPitch_; ++row) {
            for (int j = 0; j < segments; ++j) {
                const ProfilePoint& at = profile[std::size_t(row % perPitch_)];
                const double turn = double(j) / segments;
                const double z = from + pitch * (row / perPitch_ + turn) + at.z;
                vertices_.push_back(row <= rows_ || j == 0 ? skin.add(atAngle(at.radius, 2 * M_PI * turn, z))
                                                           : 0);
            }
        }
    }

    void cover(Skin& skin, bool isOutside) const {
        for (int j = 0; j < segments_; ++j) {
            for (int row = 0; row < rows_; ++row) {
                if (isOutside) {
                    skin.quad(at(row, j), at(row, j + 1), at(row + 1, j + 1), at(row + 1, j));
                } else {
                    skin.quad(at(row, j), at(row + 1, j), at(row + 1, j + 1), at(row, j + 1));
                }
            }
        }
    }

    /// The border below or above, counter-clockwise seen from above, with the step where it closes.
    std::vector<std::uint32_t> border(bool isAbove) const {
        const int row = isAbove ? rows_ : 0;
        std::vector<std::uint32_t> loop;
        for (int j = 0; j < segments_; ++j) loop.push_back(at(row, j));
        for (int k = perPitch_; k > 0; --k) loop.push_back(at(row + k, 0));
        return loop;
    }

  private:
    std::uint32_t at(int row, int j) const {
        if (j == segments_) return at(row + perPitch_, 0);
        return vertices_[std::size_t(row * segments_ + j)];
    }
    int segments_, perPitch_, rows_;
    std::vector<std::uint32_t> vertices_;
};

constexpr double kPitch = 1.75, kCrest = 6, kRoot = 4.93, kPlay = 0.08;

/// parts: of each of the four lines of the profile.
ThreadProfile thread(double wider, int parts) {
    const ThreadProfile corners{{0, kCrest}, {0.22, kCrest}, {0.77, kRoot}, {1.2, kRoot}, {kPitch, kCrest}};
    ThreadProfile profile;
    for (std::size_t line = 0; line < 4; ++line) {
        for (int k = 0; k < parts; ++k) {
            const double share = double(k) / parts;
            const ProfilePoint &a = corners[line], &b = corners[line + 1];
            profile.push_back({a.z + share * (b.z - a.z), a.radius + share * (b.radius - a.radius) + wider});
        }
    }
    return profile;
}

Piece threadedRod(double from, int turns, const ScrewShape& shape) {
    Skin skin;
    const HelixSurface surface(skin, thread(0, shape.profileParts), kPitch, from, turns, shape.segments);
    surface.cover(skin, true);
    skin.fan(reversed(surface.border(false)), {0, 0, from + 0.5 * kPitch});
    skin.fan(surface.border(true), {0, 0, from + (turns + 0.5) * kPitch});
    return skin.piece;
}

Piece nut(double from, int turns, const ScrewShape& shape) {
    Skin skin;
    const HelixSurface inner(skin, thread(kPlay, shape.profileParts), kPitch, from, turns, shape.segments),
        outer(skin, {{0, 10}}, kPitch, from, turns, shape.segments);
    inner.cover(skin, false);
    outer.cover(skin, true);
    skin.end(inner.border(false), outer.border(false), false);
    skin.end(inner.border(true), outer.border(true), true);
    return skin.piece;
}

Piece disc(double radius, double from, double to, int segments) {
    return scenes::turned({{0, from}, {radius, from}, {radius, to}, {0, to}}, segments);
}

AssembledProblem squarePeg() {
    constexpr double kHalf = 10, kGap = 0.01, kDepth = 40;
    Assembly peg, hole;
    peg.add("peg", blockBetween({-kHalf, -kHalf, 0}, {kHalf, kHalf, kDepth + 5}));
    const double wall = kHalf + kGap;
    hole.add("left", blockBetween({-20, -20, -5}, {-wall, 20, kDepth}));
    hole.add("right", blockBetween({wall, -20, -5}, {20, 20, kDepth}));
    hole.add("front", blockBetween({-wall, -20, -5}, {wall, -wall, kDepth}));
    hole.add("back", blockBetween({-wall, wall, -5}, {wall, 20, kDepth}));
    hole.add("floor", blockBetween({-20, -20, -8}, {20, 20, -kGap}));
    return tilted("square_peg", peg, hole);
}

AssembledProblem dovetailWithPlay() {
    constexpr double kGap = 0.01;
    const std::vector<double> ends{-10, 10};
    const auto along = [&](const Polyline& loop) {
        return scenes::sweepAlongY(scenes::fullSection(loop), ends);
    };
    Assembly slider, rails;
    slider.add("slider", along({{-6, 0}, {6, 0}, {4, 5}, {-4, 5}}));
    rails.add("left", along({{-10, -kGap}, {-6 - kGap, -kGap}, {-4 - kGap, 5}, {-10, 5}}));
    rails.add("right", along({{6 + kGap, -kGap}, {10, -kGap}, {10, 5}, {4 + kGap, 5}}));
    rails.add("floor", along({{-10, -4}, {10, -4}, {10, -kGap}, {-10, -kGap}}));
    rails.add("stop", blockBetween({-10, 10.02, -4}, {10, 12, 5}));
    return tilted("dovetail", slider, rails);
}

/// A hub on a shaft with a key.
AssembledProblem keyway() {
    constexpr double kGap = 0.02;
    Assembly hub, shaft;
    hub.add("ring", sector({10 + kGap, 15}, {10, 350}, {0, 20}));
    hub.add("rim", sector({12 + kGap, 15}, {-10, 10}, {0, 20}));
    shaft.add("shaft", disc(10, -20, 30, 144));
    shaft.add("collar", disc(13, -20, -kGap, 144));
    const double half = 10 - kGap / 10 / kDegree;
    shaft.add("key", sector({9, 12}, {-half, half}, {-1, 25}));
    return tilted("keyway", hub, shaft);
}

/// A round contour with a key. half: of the key's width, degrees.
Polyline keyedLoop(double radius, double key, double half) {
    Polyline loop;
    const auto add = [&](double length, double angle) {
        loop.push_back(atAngle(length, angle * kDegree, 0).head<2>());
    };
    constexpr int kSegments = 136;
    const double end = half + kFacet / 10;
    for (int i = -4; i <= 4; ++i) add(key, half * i / 4);
    for (int i = 0; i <= kSegments; ++i) add(radius, end + (360 - 2 * end) * i / kSegments);
    return loop;
}

std::vector<std::uint32_t> loopAt(Skin& skin, const Polyline& loop, double z) {
    std::vector<std::uint32_t> vertices;
    for (const Vector2& point : loop) vertices.push_back(skin.add({point.x(), point.y(), z}));
    return vertices;
}

Piece keyedShaft(double radius, double key, double half, const Vector2& heights) {
    Skin skin;
    const Polyline loop = keyedLoop(radius, key, half);
    const auto below = loopAt(skin, loop, heights[0]), above = loopAt(skin, loop, heights[1]);
    skin.band(below, above);
    skin.fan(reversed(below), {0, 0, heights[0]});
    skin.fan(above, {0, 0, heights[1]});
    return skin.piece;
}

/// A ring on z = 0 whose hole has room for a key.
Piece keyedRing(double radius, double key, double outer, double height) {
    Skin skin;
    const Polyline inside = keyedLoop(radius, key, 10);
    Polyline outside = inside;
    for (Vector2& point : outside) point *= outer / point.norm();
    const auto innerBelow = loopAt(skin, inside, 0), innerAbove = loopAt(skin, inside, height);
    const auto outerBelow = loopAt(skin, outside, 0), outerAbove = loopAt(skin, outside, height);
    skin.band(outerBelow, outerAbove);
    skin.band(outerAbove, innerAbove);
    skin.band(innerAbove, innerBelow);
    skin.band(innerBelow, outerBelow);
    return skin.piece;
}

Piece together(const std::vector<Piece>& pieces) {
    Piece all;
    for (const Piece& piece : pieces) {
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), piece.vertices.begin(), piece.vertices.end());
        for (const TriangleIndices& triangle : piece.triangles)
            all.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
    return all;
}

/// A ring on a shaft and in a housing.
AssembledProblem bearingWithPlay() {
    constexpr double kGap = 0.02;
    Assembly ring, housing;
    ring.add("ring", scenes::ring({{10 + kGap, 0}, {18, 0}, {18, 8}, {10 + kGap, 8}}, 144));
    housing.add("shaft", disc(10, -5, 20, 144));
    housing.add("housing", scenes::ring({{18 + kGap, -5}, {22, -5}, {22, 10}, {18 + kGap, 10}}, 144));
    housing.add("floor", disc(20, -5, -kGap, 144));
    return tilted("bearing", ring, housing);
}

/// A shaft with two lugs: up, a turn along the groove, and up again. end: of the groove; out: where the slots lead out; degrees. tilt: of
/// the axis, radians.
AssembledProblem bayonet(const std::string& name, double end, double out, double tilt = 0.7) {
    constexpr double kGap = 0.02, kLug = 10, kGapAngle = kGap / 9 / kDegree, kSlot = kLug + kGapAngle;
    Assembly shaft, socket;
    shaft.add("shaft", disc(8, -2, 14, 144));
    socket.add("wall", scenes::ring({{10, -3}, {12, -3}, {12, 12}, {10, 12}}, 144));
    const Vector2 radii(8 + kGap, 10);
    for (const double side : {0.0, 180.0}) {
        shaft.addNumbered("lug", sector({7.5, 10 - kGap}, {side - kLug, side + kLug}, {0, 3}));
        socket.addNumbered("under", sector(radii, {side, side + 180}, {-3, -kGap}));
        socket.addNumbered("beside", sector(radii, {side + kSlot, side + 180 - kSlot}, {-kGap, 4}));
        socket.addNumbered("stop",
                           sector(radii, {side + end + kSlot, side + 180 - kSlot}, {4, 7 + 2 * kGap}));
        socket.addNumbered("over",
                           sector(radii, {side + out + kSlot, side + out + 180 - kSlot}, {7 + 2 * kGap, 12}));
    }
    return tilted(name, shaft, socket, Vector3::Zero(), Eigen::AngleAxisd(tilt, kTilt.axis()));
}

/// An arc in a curved channel.
AssembledProblem hook() {
    constexpr double kGap = 0.05;
    Assembly arc, channel;
    arc.add("arc", sector({20, 24}, {0, 100}, {-2, 2}));
    channel.add("inner", sector({14, 20 - kGap}, {-5, 100}, {-2 - kGap, 2 + kGap}));
    channel.add("outer", sector({24 + kGap, 28}, {-5, 100}, {-2 - kGap, 2 + kGap}));
    channel.add("below", sector({14, 28}, {-5, 100}, {-6, -2 - kGap}));
    channel.add("above", sector({14, 28}, {-5, 100}, {2 + kGap, 6}));
    channel.add("end", sector({14, 28}, {-10, -0.2}, {-6, 6}));
    return tilted("hook", arc, channel, {12, -7, 3});
}

/// Points of a six-sided section around a helix, at an angle along it.
std::vector<std::uint32_t> sectionOfHelix(Skin& skin, double thickness, double angle) {
    constexpr double kRadius = 6, kRise = 4 / (2 * M_PI);
    const Vector3 out = atAngle(1, angle, 0),
                  along = (kRadius * atAngle(1, angle + M_PI / 2, 0) + kRise * Vector3::UnitZ()).normalized(),
                  up = out.cross(along);
    std::vector<std::uint32_t> loop;
    for (int k = 0; k < 6; ++k) {
        const double around = k * M_PI / 3;
        loop.push_back(skin.add(atAngle(kRadius, angle, kRise * angle) +
                                thickness * (std::cos(around) * out + std::sin(around) * up)));
    }
    return loop;
}

/// A helix of 2.5 turns in a tube around it.
AssembledProblem corkscrew() {
    constexpr int kSegments = 40, kSections = 100;
    Skin rod, tube;
    std::vector<std::vector<std::uint32_t>> inside, inner, outer;
    for (int i = 0; i <= kSections; ++i) {
        const double angle = 2 * M_PI * i / kSegments;
        inside.push_back(sectionOfHelix(rod, 1, angle));
        inner.push_back(sectionOfHelix(tube, 1.06, angle));
        outer.push_back(sectionOfHelix(tube, 1.7, angle));
    }
    for (std::size_t i = 0; i < kSections; ++i) {
        rod.band(inside[i + 1], inside[i]);
        tube.band(outer[i + 1], outer[i]);
        tube.band(inner[i], inner[i + 1]);
    }
    rod.fan(inside.front(), atAngle(6, 0, 0));
    rod.fan(reversed(inside.back()), atAngle(6, 2.5 * 2 * M_PI, 10));
    tube.band(outer.front(), inner.front());
    tube.band(inner.back(), outer.back());
    Assembly part, environment;
    part.add("rod", rod.piece);
    environment.add("tube", tube.piece);
    return tilted("corkscrew", part, environment);
}

}  // namespace

AssembledProblem screwAndNut(const ScrewShape& shape, double shift) {
    Assembly screw, around;
    const int turns = int(std::lround(shape.length / kPitch)), held = int(std::lround(shape.nut / kPitch));
    const double top = 2 * kPitch, length = kPitch * (turns + 1);
    screw.add("thread", threadedRod(top - length, turns, shape));
    if (shape.isShutIn) {
        const double from = top - length - kPitch, to = top + kPitch;
        screw.add("core", disc(kRoot - 0.5, from - 10, to + 10, shape.segments));
        around.add("nut", nut(from, turns + 2, shape));
        around.add("face_below",
                   scenes::ring({{kRoot, from - 2}, {10, from - 2}, {10, from + 0.2}, {kRoot, from + 0.2}},
                                shape.segments));
        around.add("face_above",
                   scenes::ring({{kRoot, to}, {10, to}, {10, to + 2}, {kRoot, to + 2}}, shape.segments));
    } else {
        screw.add("head", disc(9, top, top + 6, 6));
        around.add("nut", nut(top - kPitch * (held + 3), held, shape));
    }
    return tilted(shape.isShutIn ? "captive" : "screw", screw, around, {shift, 0.3 * shift, -0.2 * shift});
}

std::vector<PartState> alongThread(std::size_t count) {
    const Vector3 axis = kTilt * Vector3::UnitZ();
    std::vector<PartState> path(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double turns = double(k) / 3;
        path[k].position = turns * kPitch * axis;
        path[k].rotation = Eigen::AngleAxisd(2 * M_PI * turns, axis);
    }
    return path;
}

Mesh pumpAssembly() {
    constexpr double kGap = 0.02;
    const ScrewShape screw{24, 7 + kPitch, 7};
    Assembly pump;
    const auto add = [&](const std::string& name, double x, double z, const std::vector<Piece>& pieces) {
        pump.add(name, scenes::placed(together(pieces),
                                      [&](const Vector3& p) -> Vector3 { return p + Vector3(x, 0, z); }));
    };
    add("base", 0, 0, {blockBetween({-15, -20, -6}, {140, 20, 0})});
    add("post", 0, 0,
        {scenes::turned({{0, 0}, {7, 0}, {7, 3}, {4, 3}, {4, 15}, {7, 15}, {7, 18}, {0, 18}}, 48)});
    add("clip", 0, 0, {sector({4 + kGap, 6.5}, {-150, 150}, {3 + kGap, 15 - kGap})});
    const Piece hexagon = disc(9, 9 + 3 * kGap, 15, 6), thread = threadedRod(kGap, 5, screw);
    for (const double x : {30.0, 60.0}) {
        const std::string number = x < 50 ? "_1" : "_2";
        add("nut" + number, x, 0, {nut(kGap, 3, screw)});
        add("screw" + number, x, 0, {thread, hexagon});
    }
    add("washer", 30, 7 + 2 * kGap, {scenes::ring({{6.2, 0}, {9.5, 0}, {9.5, 2}, {6.2, 2}}, 48)});
    add("hub", 90, 0, {keyedRing(10 + kGap, 12 + kGap, 15, 20)});
    add("shaft", 90, 0,
        {keyedShaft(10, 12, 10 - kGap / 10 / kDegree, {kGap, 20 + kGap}), disc(13, 20 + 2 * kGap, 26, 144)});
    const AssembledProblem lock = bayonet("", 90, 90, 0);
    for (const auto& [name, mesh] : {std::pair("pot", &lock.environment), std::pair("lid", &lock.part)})
        add(name, 122, 3, {{mesh->vertices, mesh->triangles}});
    Mesh mesh = pump.mesh();
    mesh.origin.unitMetres = 1e-3;
    return mesh;
}

std::vector<AssembledProblem> tightProblems() {
    return {squarePeg(),
            dovetailWithPlay(),
            keyway(),
            bearingWithPlay(),
            bayonet("bayonet", 90, 90),
            bayonet("bayonet_mid", 120, 60),
            hook(),
            corkscrew()};
}

}  // namespace clearway::testing
