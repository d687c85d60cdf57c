#include "torture/mesh_families.h"

#include <array>
#include <cmath>
#include <limits>

#include "clearway/shrink.h"

namespace clearway::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;

Mesh shifted(const Mesh& mesh, const Vector3& by) {
    return translated(mesh, by);
}

/// A turn about an axis by a share of the full circle; exact for quarters.
Matrix3 turnAbout(int axis, double share) {
    const double quarters = 4 * share;
    double c = std::cos(2 * kPi * share), s = std::sin(2 * kPi * share);
    if (quarters == std::round(quarters)) {
        c = std::round(c);
        s = std::round(s);
    }
    Matrix3 turn = Matrix3::Identity();
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    turn(u, u) = turn(v, v) = c;
    turn(u, v) = -s;
    turn(v, u) = s;
    return turn;
}

double anyShare(Random& random) {
    return random.below(2) == 0 ? 0.25 * random.below(4) : random.uniform(0, 1);
}

/// A translation that rests on one face; along the other axes it is inside, flush, or over the edge by a
/// whole share of the sides.
Pose boxOnBox(Random& random, const Vector3& partHalf, const Vector3& halves) {
    Pose pose;
    const int axis = random.below(3);
    pose.rotation = turnAbout(axis, anyShare(random));
    for (int k = 0; k < 3; ++k) {
        const double sum = halves[k] + partHalf[k], difference = halves[k] - partHalf[k];
        const double steps = 0.25 * (random.below(9) - 4) * sum;
        const int kind = random.below(4);
        pose.translation[k] = kind == 0   ? steps
                              : kind == 1 ? difference
                              : kind == 2 ? sum
                                          : random.uniform(-sum, sum);
    }
    pose.translation[axis] = (random.below(2) == 0 ? 1 : -1) * (halves[axis] + partHalf[axis]);
    return pose;
}

MeshFamily boxes(const std::string& name, const Vector3& partHalf, const Vector3& halves) {
    return {name, box(partHalf, 1), box(halves, 2), 2 * partHalf.minCoeff(),
            [=](Random& random) { return boxOnBox(random, partHalf, halves); }};
}

MeshFamily combs() {
    const auto resting = [](Random& random) {
        Pose pose;
        pose.rotation = turnAbout(2, 0.5);
        // A turned part's teeth point down; shifted by an odd number it fits between the other's teeth.
        pose.translation =
            Vector3(random.below(13), 4 + random.below(17) * 0.25, 0.25 * (random.below(17) - 8));
        if (random.below(4) == 0) pose.translation.x() += random.uniform(-1, 1);
        return pose;
    };
    return {"comb", comb(4), comb(5), 1, resting};
}

/// The part is shrunk, with mitres and strips at its edges, and rests where the whole comb is as deep as its faces moved.
MeshFamily shrunkComb() {
    constexpr double kOverlap = 0.25, kFaceDepth = 0.75 * kOverlap;
    MeshFamily family = combs();
    family.name = "shrunk-comb";
    family.part = shrink(family.part, {kOverlap}).mesh;
    family.resting = [resting = family.resting](Random& random) {
        Pose pose = resting(random);
        for (int k = 0; k < 3; ++k) pose.translation[k] += kFaceDepth * (random.below(3) - 1);
        return pose;
    };
    return family;
}

/// A strip, 8 deep, over a line with whole heights; its flat back is `away` from the line.
Mesh profile(double away) {
    constexpr std::array<int, 9> kHeights = {0, 3, 3, -1, 2, 2, 5, 1, 0};
    Mesh mesh;
    for (int i = 0; i < int(kHeights.size()); ++i) {
        for (const double z : {0.0, 8.0}) {
            mesh.vertices.push_back(Vector3(2 * i, kHeights[i], z));
            mesh.vertices.push_back(Vector3(2 * i, away, z));
        }
    }
    for (std::uint32_t i = 0; 4 * i + 7 < mesh.vertices.size(); ++i) {
        for (std::uint32_t skin : {4 * i, 4 * i + 1}) {
            mesh.triangles.push_back({skin, skin + 2, skin + 6});
            mesh.triangles.push_back({skin, skin + 6, skin + 4});
        }
    }
    return mesh;
}

MeshFamily puzzle() {
    const auto resting = [](Random& random) {
        Pose pose;
        const double unit = random.below(2) == 0 ? 0.25 : 0.1;
        pose.translation = Vector3(0, unit * (random.below(9) - 1), unit * (random.below(41) - 20));
        if (random.below(2) == 0) pose.translation.y() = 0;
        if (random.below(4) == 0) pose.translation.x() = unit * (random.below(9) - 4);
        return pose;
    };
    return {"puzzle", profile(12), profile(-12), 2, resting};
}

MeshFamily roundPeg(double clearance) {
    constexpr int kSides = 24;
    const double radius = 5 - clearance;
    const auto resting = [clearance](Random& random) {
        Pose pose;
        pose.rotation = turnAbout(2, random.below(2) == 0 ? double(random.below(kSides)) / kSides : 0);
        const double way = 2 * kPi * (random.below(4 * kSides) / (4.0 * kSides));
        // Moves to the hole's wall, where the peg's corners or faces meet it.
        const double apart = clearance * (random.below(2) == 0 ? 1 : std::cos(kPi / kSides));
        pose.translation = apart * Vector3(std::cos(way), std::sin(way), 0);
        pose.translation.z() = random.below(2) == 0 ? 0.5 * (random.below(25) - 12) : random.uniform(-6, 6);
        return pose;
    };
    return {clearance > 0 ? "peg-loose" : "peg-filling", tube(3, radius, 12, kSides),
            plateWithHole(20, 2, 5, kSides), 10, resting};
}

MeshFamily squarePeg() {
    const auto resting = [](Random& random) {
        Pose pose;
        pose.rotation = turnAbout(random.below(4) == 0 ? random.below(3) : 2, 0.25 * random.below(4));
        pose.translation.z() = random.below(2) == 0 ? 0.5 * (random.below(21) - 10) : random.uniform(-5, 5);
        return pose;
    };
    return {"peg-square", box(Vector3(3, 3, 3), 2), squareHole(1), 6, resting};
}

MeshFamily spheres() {
    const auto resting = [](Random& random) {
        Pose pose;
        const int axis = random.below(3);
        pose.rotation = turnAbout(axis, anyShare(random));
        pose.translation[axis] = 3.5;
        return pose;
    };
    return {"sphere", sphere(1.5, 6), sphere(2, 8), 3, resting};
}

/// Needles from a common tip to a small circle; each needle's height is 1e-4 of its length.
Mesh needleFan(int needles) {
    Mesh mesh;
    mesh.vertices.push_back(Vector3::Zero());
    for (int i = 0; i < needles; ++i) {
        const double way = 2 * kPi * i / needles;
        mesh.vertices.push_back(Vector3(0.05 * std::cos(way), 0.05 * std::sin(way), 100));
    }
    for (int i = 0; i < needles; ++i) {
        mesh.triangles.push_back({0, std::uint32_t(1 + i), std::uint32_t(1 + (i + 1) % needles)});
    }
    return mesh;
}

MeshFamily needleFans() {
    const auto resting = [](Random& random) {
        Pose pose;
        const int kind = random.below(3);
        if (kind == 0) pose.rotation = turnAbout(0, 0.5);  // tip to tip
        if (kind == 1) pose.rotation = turnAbout(random.below(2), 0.25);
        if (kind == 2) pose.rotation = turnAbout(2, random.below(32) / 32.0);  // face on face, turned
        if (random.below(2) == 0) pose.translation.z() = random.uniform(0, 100);
        return pose;
    };
    return {"needle-fan", needleFan(32), needleFan(32), 0.1, resting};
}

void stepSomeUnits(Random& random, Vector3& point) {
    for (double& x : point) {
        const double towards = random.below(2) == 0 ? -1e300 : 1e300;
        for (int i = random.below(4); i > 0; --i) x = std::nextafter(x, towards);
    }
}

}  // namespace

Mesh comb(int teeth) {
    Mesh mesh = shifted(box(Vector3(teeth, 0.5, 1)), Vector3(teeth, -0.5, 0));
    for (int i = 0; i < teeth; ++i) {
        mesh = joined(mesh, shifted(box(Vector3(0.5, 2, 1)), Vector3(2 * i + 0.5, 2, 0)));
    }
    return mesh;
}

Mesh squareHole(int cells) {
    Mesh hole;
    for (int side = 0; side < 4; ++side) {
        const Pose turned{turnAbout(2, 0.25 * side), Vector3::Zero()};
        hole = joined(hole, transformed(shifted(box(Vector3(4, 1, 2), cells), Vector3(1, 4, 0)), turned));
    }
    return hole;
}

std::vector<MeshFamily> meshFamilies() {
    return {boxes("box", Vector3(1, 2, 1), Vector3(4, 4, 2)),
            boxes("box-decimal", Vector3(0.1, 0.7, 0.3), Vector3(1.1, 0.9, 0.3)),
            combs(),
            shrunkComb(),
            puzzle(),
            roundPeg(0),
            roundPeg(1e-6),
            squarePeg(),
            spheres(),
            needleFans()};
}

Pose adversarialPose(Random& random, const MeshFamily& family, const WayToContact& wayToContact) {
    Pose pose = family.resting(random);
    const int kind = random.below(4);
    if (kind == 1) {  // a resting pose that is turned a little
        pose.rotation = turnAbout(random.below(3), 1e-3 * random.uniform(-1, 1)) * pose.rotation;
    }
    if (kind == 2) pose.rotation = random.rotation();
    if (kind >= 1) {
        pose.translation += family.size * random.uniform(0, 0.3) * random.direction();
        const Vector3 way = wayToContact(pose);
        pose.translation += way;
    }
    const int move = random.below(4);
    if (move == 1) stepSomeUnits(random, pose.translation);
    if (move == 2) {
        pose.translation +=
            family.size * std::ldexp(random.uniform(0, 1), -random.below(50)) * random.direction();
    }
    return pose;
}

}  // namespace clearway::testing
