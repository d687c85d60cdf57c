#include "query/pair_query.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "clearway/errors.h"
#include "exact/ball.h"

namespace clearway {
namespace {

constexpr int kLargestRatioExponent = 60;  // squares of larger ratios overflow float
constexpr double kTooLarge = 1e298;        // splitting a double in two halves overflows from 2^996 on
constexpr double kTooSmall = 1e-298;       // below this, rounding is no longer in proportion to the number

double largestCoordinateOf(const Box& box) {
    return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// Upper bound of the coordinates of all points in the moved box.
double largestMovedCoordinate(const Pose& pose, const Box& box) {
    const Vector3 centre = pose * box.center();
    const Vector3 reach = pose.rotation.cwiseAbs() * (0.5 * box.sizes());
    return (centre.cwiseAbs() + reach).maxCoeff();
}

/// Makes the map from the carried tree to the target tree. t: origin of the carried tree in the target's
/// frame, mesh units.
Carry makeCarry(const Matrix3& rotation, const Vector3& t, const FlatTree& carried, int carriedExponent,
                const FlatTree& target, int targetExponent, double offsetError, int queryExponent) {
    Carry carry{};
    const double perUnit = std::ldexp(1.0, -targetExponent);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            carry.columns[column][row] = static_cast<float>(rotation(row, column));
        }
        carry.translation[row] = static_cast<float>(t[row] * perUnit);
    }
    carry.ratio = static_cast<float>(std::ldexp(1.0, carriedExponent - targetExponent));
    const double reach = (t * perUnit).norm() + double(carried.radius) * carry.ratio + target.radius;
    carry.slack = slackOf(kVolumeSlack, reach, offsetError * perUnit);
    carry.toQueryUnit = static_cast<float>(std::ldexp(1.0, targetExponent - queryExponent));
    return carry;
}

void requireRatio(int exponent, const char* what) {
    if (std::abs(exponent) <= kLargestRatioExponent) return;
    throw ArgumentError(fmt::format("{} are in a ratio of about 2^{}, expected 2^-{} to 2^{}", what, exponent,
                                    kLargestRatioExponent, kLargestRatioExponent));
}

}  // namespace

PairQuery preparePairQuery(const FlatTree& part, const FlatTree& environment, const Pose& X_environmentPart) {
    requirePose(X_environmentPart);
    const Matrix3& R = X_environmentPart.rotation;
    const Vector3& t = X_environmentPart.translation;
    const double largest =
        std::max({largestCoordinateOf(part.box), largestCoordinateOf(environment.box),
                  t.cwiseAbs().maxCoeff(), largestMovedCoordinate(X_environmentPart, part.box)});
    // A mesh that is a single point has no unit of its own, since its floats are all 0.
    const int ofPoints = largest > 0 ? std::clamp(std::ilogb(largest), -1000, 999) + 1 : 0;
    const int environmentExponent = environment.radius > 0 ? environment.unitExponent
                                    : part.radius > 0      ? part.unitExponent
                                                           : ofPoints;
    const int partExponent = part.radius > 0 ? part.unitExponent : environmentExponent;
    requireRatio(partExponent - environmentExponent, "the sizes of part and environment");
    if (!(largest < kTooLarge) || (largest > 0 && largest < kTooSmall)) {
        throw ArgumentError(
            fmt::format("the largest coordinate of part, environment and pose is {:g}, expected 0 or from "
                        "{:g} to less than {:g}",
                        largest, kTooSmall, kTooLarge));
    }

    PairQuery query;
    query.part = &part;
    query.environment = &environment;
    query.unitExponent = std::max(partExponent, environmentExponent);
    query.perMeshUnit = std::ldexp(1.0, -query.unitExponent);
    query.largestCoordinate = largest * query.perMeshUnit;
    // Query units keep the squares of sizes from overflowing and vanishing.
    const auto diagonal = [&](const Box& box) { return (box.sizes() * query.perMeshUnit).norm(); };
    query.defaultWidth = 1e-12 * (diagonal(part.box) + diagonal(environment.box)) +
                         kWidthRoundoffs * kUnitRoundoffDouble * query.largestCoordinate;
    const double offsetError = kOffsetSlack * kUnitRoundoffDouble * largest;
    query.offsetSlack = offsetError * query.perMeshUnit;

    const Vector3 between = X_environmentPart * part.origin - environment.origin;
    const double away = between.cwiseAbs().maxCoeff();  // not the norm, whose square may overflow or vanish
    if (away > 0) {
        const int smaller = std::min(partExponent, environmentExponent);
        requireRatio(std::max(0, std::ilogb(away) - smaller),
                     "the way between part and environment and their sizes");
    }
    query.partToEnvironment = makeCarry(R, between, part, partExponent, environment, environmentExponent,
                                        offsetError, query.unitExponent);
    query.environmentToPart =
        makeCarry(R.transpose(), -(R.transpose() * between), environment, environmentExponent, part,
                  partExponent, offsetError, query.unitExponent);
    query.partLeafToQuery = static_cast<float>(std::ldexp(1.0, partExponent - query.unitExponent));
    query.environmentLeafToQuery =
        static_cast<float>(std::ldexp(1.0, environmentExponent - query.unitExponent));
    query.reach = (between * query.perMeshUnit).norm() + double(part.radius) * query.partLeafToQuery +
                  double(environment.radius) * query.environmentLeafToQuery;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            query.R[3 * row + column] = R(row, column);
            query.rotation[3 * row + column] = static_cast<float>(R(row, column));
        }
        query.t[row] = t[row];
    }
    return query;
}

Corners movedCorners(const PairQuery& query, TriangleAt triangle) {
    const std::array<Vector3, 3> stored = query.part->corners(triangle);
    Corners corners;
    for (int k = 0; k < 3; ++k) {
        for (int row = 0; row < 3; ++row) {
            corners.p[k][row] =
                affineRow(query.R + 3 * row, stored[std::size_t(k)].data(), query.t[row]) * query.perMeshUnit;
        }
    }
    return corners;
}

Corners fixedCorners(const PairQuery& query, TriangleAt triangle) {
    const std::array<Vector3, 3> stored = query.environment->corners(triangle);
    Corners corners;
    for (int k = 0; k < 3; ++k) corners.p[k] = stored[std::size_t(k)] * query.perMeshUnit;
    return corners;
}

PairVertices pairVertices(const PairQuery& query, const TrianglesAt& triangles) {
    const std::array<Vector3, 3> p = query.part->corners(triangles.part),
                                 q = query.environment->corners(triangles.environment);
    PairVertices pair;
    for (int row = 0; row < 3; ++row) {
        pair.firstCorner[row] = affineRow(query.R + 3 * row, p[0].data(), query.t[row]) * query.perMeshUnit -
                                q[0][row] * query.perMeshUnit;
        for (std::size_t edge = 0; edge < 2; ++edge) {
            pair.partEdge[edge][row] = (p[edge + 1][row] - p[0][row]) * query.perMeshUnit;
            pair.environmentEdge[edge][row] = (q[edge + 1][row] - q[0][row]) * query.perMeshUnit;
        }
    }
    return pair;
}

}  // namespace clearway
