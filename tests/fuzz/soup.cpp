#include "fuzz/soup.h"

#include <cmath>
#include <limits>

namespace clearway::testing {

double SoupReader::coordinate() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const auto small = [&] { return double(bytes_.take<std::int8_t>()); };
    double value = 0;
    switch (bytes_.below(9)) {
        case 0:
        case 1:
            value = small();
            break;
        case 2:
            value = small() / 2;
            break;
        case 3:
            value = earlier();
            break;
        case 4:
            value = std::nextafter(earlier(), small() < 0 ? -kInfinity : kInfinity);
            break;
        case 5:
            value = earlier() + std::ldexp(small(), -int(bytes_.below(64)));
            break;
        case 6:
            value = (earlier() + earlier()) / 2;
            break;
        case 7:
            value = std::ldexp(double(bytes_.take<std::int32_t>()), -29);
            break;
        default:
            value = isWild_ ? bytes_.take<double>() : 1e6 + small();
    }
    if (numbers_.size() < 256 && std::isfinite(value)) numbers_.push_back(value);
    return value;
}

Vector3 SoupReader::point() {
    const auto earlierPoint = [&] {
        return points_[bytes_.below(std::min<std::size_t>(points_.size(), 256))];
    };
    Vector3 point;
    switch (bytes_.below(6)) {
        case 0:
            point = earlierPoint();
            break;
        case 1:
            point = 0.5 * earlierPoint() + 0.5 * earlierPoint();
            break;
        case 2:
            point = earlierPoint();
            point[int(bytes_.below(3))] = coordinate();
            break;
        default:
            for (int axis = 0; axis < 3; ++axis) point[axis] = coordinate();
    }
    points_.push_back(point);
    return point;
}

Mesh SoupReader::soup(std::size_t most) {
    Mesh mesh;
    for (std::size_t count = 1 + bytes_.below(most); count > 0; --count) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int corner = 0; corner < 3; ++corner) mesh.vertices.push_back(point());
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Pose SoupReader::pose() {
    Pose pose;
    const std::size_t kind = bytes_.below(4);
    if (kind == 1) {  // quarter turns about two axes
        const Eigen::AngleAxisd turns[] = {
            Eigen::AngleAxisd(M_PI_2 * double(bytes_.below(4)), Vector3::UnitX()),
            Eigen::AngleAxisd(M_PI_2 * double(bytes_.below(4)), Vector3::UnitZ())};
        pose.rotation = (turns[0] * turns[1]).toRotationMatrix().array().round();
    } else if (kind >= 2) {
        Eigen::Quaterniond q;
        for (int i = 0; i < 4; ++i) q.coeffs()[i] = double(bytes_.take<std::int8_t>());
        if (q.norm() > 0) pose.rotation = q.normalized().toRotationMatrix();
    }
    if (bytes_.below(3) > 0) pose.translation = point();
    return pose;
}

BuildOptions takeOptions(Bytes& bytes) {
    BuildOptions options;
    const auto pick = [&](const auto& values) { return values[bytes.below(values.size())]; };
    options.generalSplit = pick(generalSplitNames());
    options.leafSplit = pick(leafSplitNames());
    options.fit = pick(fitNames());
    options.nodeWidth = pick(nodeWidths());
    options.leafSize = 1 + int(bytes.below(16));
    options.threads = 1;
    return options;
}

}  // namespace clearway::testing
