// Shrinks a part, so that obstacles may reach a little way into it.
//
// The overlap of a part and an obstacle is how deep points of the obstacle lie below the part's surface: how far from the nearest
// triangle, of whichever component. Where components touch, the faces between them are surface, too.
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

/// How far shrink() shrinks a part.
struct ShrinkOptions {
    double overlap = 0;                         ///< mesh units, > 0: no point of an obstacle lies deeper
    std::function<bool()> isStopped = nullptr;  ///< asked now and then; null: never stopped
};

/// Thrown by shrink() when options.isStopped returns true.
class ShrinkStopped : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;  ///< takes the message
};

/// Places where a shrunk part allows less than 0.6 of the overlap: at walls of the part that are thinner than about twice the overlap,
/// along sharp edges, and in few corners that no mitre fits.
struct ThinPlaces {
    std::size_t count = 0;  ///< vertices of the part, or of faces whose corners were cut off
    double leastOverlap =
        0;  ///< the least that is allowed at a vertex; mesh units; the whole overlap without such places
    Vector3 at = Vector3::Zero();  ///< where that is; the part's mesh coordinates
};

/// A part shrunk by an overlap. Certified: where the surface moves from the part's to the shrunk part's, it sweeps no point deeper than
/// the overlap, so an obstacle that misses the shrunk part, and is not wholly inside one of its components, has no point deeper than that. A flat contact of
/// three quarters of the overlap is free. The surface may pass through itself.
struct ShrunkPart {
    Mesh mesh;              ///< with the part's components; in the part's mesh coordinates
    ShrinkOptions options;  ///< as given, but for isStopped
    std::vector<std::uint32_t>
        partTriangles;  ///< for each triangle the one of the part's mesh that it comes from
    ThinPlaces thin;    ///< where less than the overlap is allowed
};

/// Shrinks the part: its faces move inwards by three quarters of the overlap, and mitres join them. Throws ArgumentError, naming what is
/// wrong, if the overlap is not a finite number above 0, too small for the part's coordinates or more than half of the part's diagonal, or if a component of the part is
/// not closed (see makeSolids); and ShrinkStopped when stopped.
ShrunkPart shrink(const Mesh& part, const ShrinkOptions& options);

/// The result of shrinkCached.
struct CachedShrunkPart {
    ShrunkPart part;        ///< as shrink() makes it
    bool isLoaded = false;  ///< false: shrunk
    std::string warning;    ///< why a file could not be used or written; empty otherwise
    bool isKept = true;     ///< whether the folder holds the shrunk part for the next time
};

/// Loads the shrunk part from the folder's file for this part and overlap, or else shrinks the part and saves it there, as buildCached
/// does with models. Throws what shrink() throws; a folder that cannot be read or written is a warning.
CachedShrunkPart shrinkCached(const Mesh& part, const ShrinkOptions& options, const std::string& folder);

/// The shrunk part for Obstacle::shrunk. model: built from its mesh.
std::shared_ptr<const ShrunkModel> shrunkModel(const ShrunkPart& shrunk, Model model);

}  // namespace clearway

#pragma GCC visibility pop
