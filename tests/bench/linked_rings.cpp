#include "bench/linked_rings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace clearway::testing {
namespace {

constexpr double kRingRadius = 100;
constexpr double kPipeRadius = 25;
constexpr int kLeastAround = 3;  // quads around the pipe

double asFloat(double x) {
    return static_cast<float>(x);
}

}  // namespace

Mesh ring(std::size_t triangles) {
    const int aroundPipe = std::max(kLeastAround, int(std::lround(std::sqrt(double(triangles) / 8))));
    const int aroundAxis = 4 * aroundPipe;
    Mesh mesh;
    mesh.vertices.reserve(std::size_t(aroundAxis) * std::size_t(aroundPipe));
    mesh.triangles.reserve(2 * mesh.vertices.capacity());
    for (int i = 0; i < aroundAxis; ++i) {
        const double turn = 2 * M_PI * i / aroundAxis;
        for (int j = 0; j < aroundPipe; ++j) {
            const double around = 2 * M_PI * j / aroundPipe;
            const double radius = kRingRadius + kPipeRadius * std::cos(around);
            mesh.vertices.emplace_back(asFloat(radius * std::cos(turn)), asFloat(radius * std::sin(turn)),
                                       asFloat(kPipeRadius * std::sin(around)));
        }
    }
    const auto vertex = [&](int i, int j) {
        return std::uint32_t(i % aroundAxis * aroundPipe + j % aroundPipe);
    };
    for (int i = 0; i < aroundAxis; ++i) {
        for (int j = 0; j < aroundPipe; ++j) {
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return mesh;
}

std::vector<Pose> linkedRingPoses(int count) {
    std::vector<Pose> poses;
    for (int k = 0; k < count; ++k) {
        const double s = 2 * M_PI * k / count;
        Pose pose;
        pose.rotation = (Eigen::AngleAxisd(M_PI / 2 + 0.3 * std::sin(s), Vector3::UnitX()) *
                         Eigen::AngleAxisd(0.2 * std::cos(2 * s), Vector3::UnitY()) *
                         Eigen::AngleAxisd(s, Vector3::UnitZ()))
                            .toRotationMatrix();
        pose.translation = Vector3(100 + 40 * std::cos(s), 15 * std::sin(3 * s), 20 * std::sin(s));
        poses.push_back(pose);
    }
    return poses;
}

}  // namespace clearway::testing
