// Shrinks a part, so that obstacles may reach a little way into it.
//
// The overlap of a part and an obstacle is how deep points of the obstacle lie below the part's surface. No
// point lies deeper than X exactly when the obstacle misses the points of the part that lie deeper than X: the
// part shrunk by X.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/scene.h"
#include "clearway/types.h"

#pragma GCC visibility push(default)

namespace clearway {

/// How far shrink() shrinks a part, and how closely.
struct ShrinkOptions {
    double overlap = 0;                         ///< mesh units, > 0: how deep obstacles may reach
    double tolerance = 0;                       ///< mesh units, > 0: how much deeper they may enter unnoticed
    std::function<bool()> isStopped = nullptr;  ///< asked often, from several threads; null: never stopped
};

/// Thrown by shrink() when options.isStopped returns true.
class ShrinkStopped : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;  ///< takes the message
};

/// A part shrunk by an overlap. Certified by exact queries: its surface lies inside the part, nowhere less than
/// the overlap and nowhere more than overlap + tolerance below the part's surface; and every point of the part
/// that lies deeper than overlap + tolerance is inside it. Where components of the part touch or lie in each other,
/// their common outside counts as the part's surface, and gaps in the part of less than an eighth of the tolerance
/// count as filled.
struct ShrunkPart {
    Mesh mesh;  ///< one component, called as the part's only one or "part"; in the part's mesh coordinates
    ShrinkOptions options;                     ///< as given
    std::vector<std::uint32_t> partTriangles;  ///< for each triangle the nearest one of the part's mesh
    /// Lines about pieces that the shrunk part lacks. One for each component that vanishes, loses a connected body or
    /// is cut apart; and one for each component (for the whole part where components meet) that loses something thin:
    /// a point farther from the shrunk part than 3 (overlap + tolerance). Up to 1.1 times that distance such a point
    /// may go unnoticed.
    std::vector<std::string> leftOut;
};

/// Shrinks the part. Throws ArgumentError, naming what is wrong, if an option is not a finite number above
/// 0, if a component of the part is not closed, if a connected piece of its surface passes through itself, if nothing of
/// the part is left, or if the tolerance is too small for the part's size (before the work where its concave
/// edges alone show it). Throws ShrinkStopped when stopped. Something is left where a point of the
/// part lies deeper than overlap + tolerance.
///
/// The surface is cut through tetrahedra that are bisected where a bound on depths fails, as in isosurface
/// stuffing (Labelle and Shewchuk, ACM Trans. Graphics 26, 2007), but with bounds from exact distances. So
/// flat and large faces take few triangles, while a grid of one width takes area / tolerance^2.
ShrunkPart shrink(const Mesh& part, const ShrinkOptions& options);

/// The shrunk part for Obstacle::shrunk. model: built from its mesh.
std::shared_ptr<const ShrunkModel> shrunkModel(const ShrunkPart& shrunk, Model model);

}  // namespace clearway

#pragma GCC visibility pop
