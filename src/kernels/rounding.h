// The rounding budget of the kernels: how far float may raise a lower bound above the truth, and how far
// every bound is lowered in return. rounding.md derives each figure. A kernel whose operations change needs
// new figures only here and in rounding.md.
#pragma once

namespace clearway {

constexpr double kUnitRoundoffFloat = 0x1p-24;   ///< u32
constexpr double kUnitRoundoffDouble = 0x1p-53;  ///< u64

/// Rounding of one lower bound between two volumes (rss_lower_bound-inl.h, with the carrying of volumes in
/// query/traverse-inl.h), in u32 (|t| + radius + radius). Worst case 138.
constexpr double kVolumeSlack = 160;

/// Rounding of one gap or distance between two triangles (certificate-inl.h and tri_tri_distance-inl.h, with
/// the moving of leaves in query/leaf_pairs-inl.h), in u32 (leaf radius + leaf radius + |offset|). Worst case
/// 19.
constexpr double kTriangleSlack = 24;

/// Rounding of R c + t - c', composed in double from coordinates of at most M, in u64 M: 3 products, 3 sums
/// and 3 coordinates. Worst case 11.4.
constexpr double kOffsetSlack = 20;

/// Query units. Float proves no lower bound up to this; such pairs are left to double, because the squares
/// that float compares would vanish far below.
constexpr float kLeastProved = 0x1p-22f;

/// Squared lengths of the directions that a gap may be measured across: the squares are normal numbers.
constexpr double kLeastDirectionSquared = 1e-30;
constexpr double kLargestDirectionSquared = 1e30;

/// Sweeps need longer directions: a turn's squared product with the direction must be a normal number.
constexpr float kLeastMovingSquared = 1e-20f;

/// ProvesApart compares squares without a division, and needs longer directions than a gap does.
constexpr float kLeastProvingSquared = 1e-22f;

/// u32 by which NeedSquared raises its square: 3 roundings in |v|^2, 2 in the square of what is needed, 1 in
/// each of the two products that ProvesApart compares, and one to spare.
constexpr float kNeedRoundoffs = 8;

/// u32 by which the sum of a distance and a slack is raised before NeedSquared takes it: 1 for the sum and
/// one to spare.
constexpr float kNeedSumRoundoffs = 2;

/// Rounding of a lower bound that the triangle kernel computes in double (query/bound_pairs-inl.h), first
/// order, errors of vectors. Place, in u64 M: moving the first corner 1.8. Size, in u64 times the pair's
/// largest coordinate: difference from the base 1.8; edges of the part, up to 3.5 long, 3.5, their rotation
/// 17.4 and place 1.8; edges of the environment 1.8; products of a slab gap 5.2 + 5.2 and their difference
/// 1.8. Gap, in u64 of the gap: length of the direction 2.5, division 1, subtracting the slack 2.
constexpr double kPairPlaceRoundoffs = 2;
constexpr double kPairSizeRoundoffs = 40;
constexpr double kPairGapRoundoffs = 6;

/// The slack of a float bound: `roundoffs` u32 of `reach`, plus an error that double left. The factor covers
/// the rounding of the slack itself.
inline float slackOf(double roundoffs, double reach, double errorInDouble) {
    return static_cast<float>((roundoffs * kUnitRoundoffFloat * reach + errorInDouble) * (1 + 1e-6));
}

}  // namespace clearway
