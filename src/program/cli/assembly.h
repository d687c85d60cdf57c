// Finds which parts of an assembly touch, overlap or are near. Its parts are the components of a mesh file, or of the files of a folder.
#pragma once

#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/overlap.h"
#include "clearway/scene_clearance.h"

namespace clearway::cli {

/// Two parts that are near each other, touch, or reach into each other. Lengths in the mesh's unit.
struct PartPair {
    enum class Kind { kOverlap, kContact, kGap };
    Kind kind = Kind::kGap;
    std::string a, b;             ///< names of the components
    double lower = 0, upper = 0;  ///< bounds of the gap; 0 unless kGap
    Vector3 at = Vector3::
        Zero();  ///< the deepest or crossing point, the middle of the contact, or the middle of the gap
    std::size_t touchingTriangles =
        0;  ///< pairs of triangles in contact; kContact, and kOverlap where surfaces cross without lying deep
    bool doCoincide =
        false;  ///< kOverlap alone: they share a volume around `at`, although no surface of one lies deep in the other
    std::optional<DeepestPoint> depth;  ///< unknown without a closed part
    std::optional<EscapeDistance>
        escape;                   ///< kOverlap alone: the shortest way along an axis on which b leaves a
    std::string escapeDirection;  ///< "+z"
};

/// The pairs with gaps of at most `near`: overlaps, the deepest first; then contacts; then gaps, the narrowest first. Parts that reach no
/// deeper into each other than half a thousandth of the smaller one's diagonal are in contact, unless their surfaces coincide around a shared
/// volume, as those of two copies do, or two triangles cross by more than that, as those of crossing sheets do. A closed part that holds a
/// piece of another one counts as an overlap; an open part holds nothing.
std::vector<PartPair> pairsOf(const Mesh& assembly, double near);

/// Draws the assembly with a ring around the place of each overlap and each contact, into a .png file. The smaller part of each
/// such pair is drawn in the colour of contact. Throws std::invalid_argument when there is one part alone.
void drawPairs(const Mesh& assembly, const std::vector<PartPair>& pairs, const std::string& file);

/// Prints a row for each pair, keeps them among the facts as "pairs", and writes a table where a file is given.
void tellPairs(const std::vector<PartPair>& pairs, double near, const std::string& csvFile);

}  // namespace clearway::cli
