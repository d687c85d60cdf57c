// Random volumes as nodes store them, each against eight others, with their distance by long double: nearly
// parallel, crossing, coplanar, on each other, without width, far away.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "support/random_meshes.h"
#include "support/triangle_distance.h"

namespace clearway::testing {

using LongMatrix = Eigen::Matrix<long double, 3, 3>;

/// A volume as a node stores it, tree units.
struct StoredRss {
    Eigen::Vector3f centre, axis0, axis1;
    float halfLength0, halfLength1, radius;

    LongVector corner(int sign0, int sign1) const {
        return centre.cast<long double>() + sign0 * (halfLength0 * axis0.cast<long double>()) +
               sign1 * (halfLength1 * axis1.cast<long double>());
    }
    /// The rectangle as two triangles.
    std::array<LongTriangle, 2> triangles() const {
        const LongVector a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
        return {LongTriangle{a, b, c}, LongTriangle{a, c, d}};
    }
    float longest() const { return 2 * std::hypot(halfLength0, halfLength1) + 2 * radius; }
};

/// A tree's frame: the ball of radius 1 in tree units about its origin is where its volumes lie.
struct Frame {
    Vector3 origin;
    int unitExponent;
};

/// One volume of the part and the volumes of a node of the environment, and how far apart they are.
struct VolumeCase {
    std::string kind;
    Frame partFrame, environmentFrame;
    Pose pose;
    StoredRss part;
    std::vector<StoredRss> children;
    std::vector<long double> distances;  ///< between the rectangles less the radii, mesh units
};

/// Tree coordinates to environment coordinates in long double.
inline std::array<LongTriangle, 2> placed(const StoredRss& rss, const Frame& frame, const Pose& pose) {
    const long double unit = std::ldexp(1.0L, frame.unitExponent);
    const LongMatrix R = pose.rotation.cast<long double>();
    std::array<LongTriangle, 2> triangles = rss.triangles();
    for (LongTriangle& triangle : triangles) {
        for (LongVector& p : triangle) {
            const LongVector inMesh = p * unit + frame.origin.cast<long double>();
            p = R * inMesh + pose.translation.cast<long double>();
        }
    }
    return triangles;
}

inline long double rectangleDistance(const std::array<LongTriangle, 2>& a,
                                     const std::array<LongTriangle, 2>& b) {
    long double distance = std::numeric_limits<long double>::infinity();
    for (const LongTriangle& s : a) {
        for (const LongTriangle& t : b) distance = std::min(distance, triangleDistance(s, t).distance);
    }
    return distance;
}

inline void measure(VolumeCase& volumes) {
    const auto part = placed(volumes.part, volumes.partFrame, volumes.pose);
    for (const StoredRss& child : volumes.children) {
        const long double radii =
            std::ldexp(static_cast<long double>(volumes.part.radius), volumes.partFrame.unitExponent) +
            std::ldexp(static_cast<long double>(child.radius), volumes.environmentFrame.unitExponent);
        volumes.distances.push_back(rectangleDistance(part, placed(child, volumes.environmentFrame, Pose{})) -
                                    radii);
    }
}

/// Sizes about `size`; every fourth side and radius is 0. The middles of its sides lie within the ball of
/// radius 1.
inline StoredRss randomRss(Random& random, const Matrix3& axes, const Vector3& direction, double size) {
    const auto sizeOrNone = [&] { return random.below(4) == 0 ? 0 : size * random.uniform(0, 1); };
    StoredRss rss;
    rss.halfLength0 = static_cast<float>(sizeOrNone());
    rss.halfLength1 = static_cast<float>(sizeOrNone());
    rss.radius = static_cast<float>(0.1 * sizeOrNone());
    const double away = 1 - std::max(rss.halfLength0, rss.halfLength1);
    rss.centre = (direction * away * random.uniform(0, 1)).cast<float>();
    rss.axis0 = axes.col(0).cast<float>();
    rss.axis1 = axes.col(1).cast<float>();
    return rss;
}

inline Matrix3 turned(Random& random, const Matrix3& axes, double angle) {
    return Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix() * axes;
}

/// One volume against eight whose axes, in the environment's frame, are its own but for a rotation by
/// `angle`.
inline VolumeCase makeCase(Random& random, const std::string& kind, double angle, double size, double away) {
    VolumeCase volumes;
    volumes.kind = kind;
    volumes.partFrame = {random.inBox(100), random.below(12) - 6};
    volumes.environmentFrame = {random.inBox(100), random.below(12) - 6};
    const double unit = std::ldexp(1.0, volumes.environmentFrame.unitExponent);
    const Matrix3 R = random.rotation(), axes = random.rotation();
    volumes.part = randomRss(random, axes, random.direction(), size);
    for (int lane = 0; lane < 8; ++lane) {
        const Matrix3 near = angle < 0 ? random.rotation() : turned(random, R * axes, angle);
        volumes.children.push_back(randomRss(random, near, random.direction(), size));
    }
    // The trees' origins are `away` environment units apart.
    volumes.pose = {
        R, volumes.environmentFrame.origin - R * volumes.partFrame.origin + random.direction() * away * unit};
    return volumes;
}

/// Both trees so far from the origin that composing the way between them rounds by more than all that float
/// does.
inline VolumeCase makeFarFromOrigin(Random& random) {
    VolumeCase volumes = makeCase(random, "far from the origin", -1, 1, 1);
    const double away = std::ldexp(1.0, 36 + random.below(8));
    volumes.partFrame.origin = away * random.direction();
    volumes.environmentFrame.origin = away * random.direction();
    volumes.pose.translation =
        volumes.environmentFrame.origin - volumes.pose.rotation * volumes.partFrame.origin;
    return volumes;
}

/// As large as a frame allows, and turned so that rows and columns of the rotation are as far as can be from
/// the axes: where rounding adds up most.
inline VolumeCase makeUnfavourable(Random& random) {
    VolumeCase volumes = makeCase(random, "unfavourable", -1, 1, random.uniform(0, 3));
    volumes.partFrame.unitExponent = volumes.environmentFrame.unitExponent;
    const Matrix3 mirror = Matrix3::Constant(2.0 / 3) - Matrix3::Identity();  // a half turn about (1, 1, 1)
    const Pose before = volumes.pose;
    volumes.pose.rotation = turned(random, mirror, random.uniform(0, 0.02));
    volumes.pose.translation =
        before * volumes.partFrame.origin - volumes.pose.rotation * volumes.partFrame.origin;
    const double h = random.uniform(0, 1);
    const auto enlarge = [&](StoredRss& rss) {
        rss.halfLength0 = static_cast<float>(h);
        rss.halfLength1 = static_cast<float>(random.below(2) == 0 ? 0 : h);
        const double away = (1 + std::sqrt(1 - h * h)) / 2;  // along the normal; see src/kernels/rounding.md
        const Eigen::Vector3f normal = rss.axis0.cross(rss.axis1);
        rss.centre = static_cast<float>(away) * normal + static_cast<float>(1 - h) * rss.axis0;
    };
    enlarge(volumes.part);
    for (StoredRss& child : volumes.children) enlarge(child);
    return volumes;
}

/// The part's rectangle as its own neighbour: in its plane, on it, over it at a gap, or standing on it.
inline VolumeCase makeNeighbours(Random& random, double angle, double gap) {
    VolumeCase volumes = makeCase(random, "neighbours", angle, 0.5, 0);
    volumes.partFrame.unitExponent = volumes.environmentFrame.unitExponent;
    volumes.pose.translation =
        volumes.environmentFrame.origin - volumes.pose.rotation * volumes.partFrame.origin;
    const Matrix3& R = volumes.pose.rotation;
    const Vector3 centre = R * volumes.part.centre.cast<double>();
    const Vector3 axis0 = R * volumes.part.axis0.cast<double>(),
                  axis1 = R * volumes.part.axis1.cast<double>();
    const Vector3 normal = axis0.cross(axis1);
    const double h0 = volumes.part.halfLength0, h1 = volumes.part.halfLength1;
    const Vector3 places[8] = {centre,
                               centre + gap * normal,
                               centre + (2 * h0 + gap) * axis0,
                               centre + (2 * h1 + gap) * axis1,
                               centre + 0.5 * h0 * axis0 - 0.3 * h1 * axis1 + gap * normal,
                               centre + (h0 + gap) * axis0 + h1 * normal,
                               centre + h1 * axis1,
                               centre - h0 * axis0 - h1 * axis1};
    for (int lane = 0; lane < 8; ++lane) {
        StoredRss& child = volumes.children[static_cast<std::size_t>(lane)];
        child.centre = places[lane].cast<float>();
        child.halfLength0 = volumes.part.halfLength0;
        child.halfLength1 = volumes.part.halfLength1;
        if (lane == 5) child.axis0 = child.axis0.cross(child.axis1).eval();  // standing
    }
    return volumes;
}

inline long double sizeOf(const VolumeCase& volumes, std::size_t lane) {
    return std::ldexp(static_cast<long double>(volumes.part.longest()), volumes.partFrame.unitExponent) +
           std::ldexp(static_cast<long double>(volumes.children[lane].longest()),
                      volumes.environmentFrame.unitExponent);
}

inline std::vector<VolumeCase> makeVolumeCases(std::uint64_t seed) {
    std::vector<VolumeCase> result;
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        result.push_back(makeCase(random, "near", -1, 1, 1));
        result.push_back(makeUnfavourable(random));
        result.push_back(makeFarFromOrigin(random));
        result.push_back(makeCase(random, "small", -1, std::pow(10.0, -random.below(6)), 1));
        result.push_back(makeCase(random, "far", -1, 1, 1e4 * random.uniform(0, 1)));
        result.push_back(makeCase(random, "farther", -1, 1, std::ldexp(1, 30 + random.below(20))));
        for (int power = 1; power <= 9; ++power) {
            const double angle = std::pow(10.0, -power);
            result.push_back(makeCase(random, "nearly parallel", angle, 1, 1));
            result.push_back(makeNeighbours(random, angle, std::pow(10.0, -random.below(8))));
        }
        result.push_back(makeNeighbours(random, 0, std::pow(10.0, -random.below(8))));
    }
    for (VolumeCase& volumes : result) measure(volumes);
    return result;
}

}  // namespace clearway::testing
