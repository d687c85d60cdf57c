// One query made ready for traversal: the pose is composed in double and rounded once, together with the
// slacks that cover the rounding. All lengths of a query are in query units of 2^unitExponent mesh units, the
// larger of the two trees' units.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "clearway/types.h"
#include "kernels/rounding.h"
#include "tree/flat_tree.h"

namespace clearway {

/// The map that carries volumes of one tree into the frame and unit of the other tree: x -> ratio * (R x) +
/// t.
struct alignas(16) Carry {
    float columns[3][4];   ///< the columns of R, each followed by a 0
    float translation[4];  ///< t, followed by a 0
    float ratio;           ///< exact power of two
    float slack;           ///< of bounds between the trees' volumes (kVolumeSlack); target tree's unit
    float toQueryUnit;     ///< target tree's unit -> query unit, exact power of two
};

/// The least float above x. x: below the largest float.
inline float nextFloatAbove(double x) {
    const float rounded = static_cast<float>(x);
    return rounded > x ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

/// The rounding part of an answer's default width, in u64 M.
constexpr double kWidthRoundoffs = 32;

/// The data of one query that traversal and kernels read.
struct PairQuery {
    const FlatTree* part;
    const FlatTree* environment;
    Carry partToEnvironment;
    Carry environmentToPart;

    double R[9];         ///< rotation of X_environmentPart as given, row-major
    double t[3];         ///< translation of X_environmentPart as given, mesh units
    double perMeshUnit;  ///< 2^-unitExponent: mesh units -> query units
    int unitExponent;
    float rotation[9];             ///< R rounded
    float partLeafToQuery;         ///< part tree's unit -> query unit
    float environmentLeafToQuery;  ///< environment tree's unit -> query unit
    double offsetSlack;            ///< rounding of a composed offset (kOffsetSlack), query units
    double reach;                  ///< distance between the trees' origins plus both radii, query units

    double largestCoordinate;  ///< M: largest coordinate of both meshes, the moved part and t; query units
    /// Width of an answer's interval, query units: 1e-12 of the scene size and kWidthRoundoffs u64 M.
    double defaultWidth;
};

/// Prepares the query of a part at a pose. Throws ArgumentError if the pose is no rotation, if the
/// meshes' sizes differ by a factor of more than 2^60, if the meshes are farther apart than 2^60 times the
/// smaller size, or if the largest coordinate is outside 1e-298 to 1e298 and not 0.
PairQuery preparePairQuery(const FlatTree& part, const FlatTree& environment, const Pose& X_environmentPart);

/// The number of the features on which two triangles are closest: 3 i + j stands for edge i of the part's
/// triangle and edge j of the environment's, edge k going from corner k to the next; 9 + 2 k for the part's
/// corner k over the environment's face, 10 + 2 k for the environment's corner k over the part's face.
constexpr int kFeatures = 15;
constexpr std::int32_t kNoFeature = -1;

/// Two triangles, by their places in the trees, and a guess where they are closest.
struct TrianglesAt {
    TriangleAt part;
    TriangleAt environment;
    std::int32_t feature = kNoFeature;  ///< a guess, or kNoFeature; a wrong guess only costs time
};

/// The corners of a triangle, query units, environment frame.
struct Corners {
    Vector3 p[3];
    Vector3 edge(int k) const { return p[(k + 1) % 3] - p[k]; }
    Vector3 normal() const { return edge(0).cross(p[2] - p[0]); }
};

/// A triangle of the moved part, each coordinate rounded once.
Corners movedCorners(const PairQuery& query, TriangleAt triangle);
/// A triangle of the environment.
Corners fixedCorners(const PairQuery& query, TriangleAt triangle);

/// The vertices of a pair, query units, relative to the environment triangle's first corner: the moved first
/// corner of the part's triangle, and the edges from either triangle's first corner to its second and third.
/// The part's edges are not rotated.
struct PairVertices {
    double firstCorner[3];
    double partEdge[2][3];
    double environmentEdge[2][3];
};
PairVertices pairVertices(const PairQuery& query, const TrianglesAt& triangles);

}  // namespace clearway
