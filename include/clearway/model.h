// Models: meshes prepared for queries, with a tree of rectangle swept spheres.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/mesh.h"
#include "clearway/types.h"

/// @namespace clearway
/// The library without OMPL: meshes, models, queries, motions, scenes and problem files.

#pragma GCC visibility push(default)

namespace clearway {

struct ModelAccess;

/// The poses X_environmentPart of future queries, with any rotation, and the largest distance from the part
/// that matters. Lengths in environment units. An environment built for a range leaves out its triangles
/// beyond it.
struct QueryRange {
    /// The poses' translations, that is, the places of the origin of the part's mesh coordinates, in the
    /// environment's frame. The border belongs to the box.
    Box positions;
    double partRadius = 0;  ///< at least Model::radiusAboutOrigin() of the part
    double cap = 0;         ///< larger distances do not matter
};

/// A mesh prepared for queries. Copies share one immutable tree, so copying is cheap and any number of
/// threads may query the model at once.
class Model {
  public:
    /// Cleans the mesh and builds its tree. Throws ArgumentError when a vertex of a triangle is not
    /// finite (naming the first such triangle), an index is out of range, the components do not cover the
    /// triangles, the mesh has no triangle, an option is unknown, or the range is not a finite box with two
    /// lengths of at least 0.
    ///
    /// A range is for environments: triangles that no pose within the range can bring within its cap are left
    /// out and counted in the report. If all would be left out, one stays. See range().
    static Model build(const Mesh& mesh, const BuildOptions& options = {},
                       const std::optional<QueryRange>& range = std::nullopt);

    /// Reads a file written by save. Throws FileError, naming the file and its fault, when the file
    /// cannot be read, is not a saved model, is damaged, or was saved by another version or with another byte
    /// order.
    static Model load(const std::string& file);

    /// Writes the model with its report and names, under a temporary name that is then renamed. Throws
    /// FileError when the file cannot be written.
    void save(const std::string& file) const;

    /// How the model was built; for a loaded model, how the saved one was.
    const BuildReport& report() const;
    const Box& box() const;  ///< of all triangles, including those left out; mesh coordinates
    const std::vector<Component>& components() const;  ///< at least one
    const MeshOrigin& origin() const;                  ///< that of the mesh which the model was built from

    /// Largest distance of a vertex in the tree from the origin of mesh coordinates: no rotation about the
    /// origin reaches further.
    double radiusAboutOrigin() const;

    /// Upper bound of the largest distance of a vertex in the tree from the line through the origin of mesh
    /// coordinates along a direction of any length: no rotation about that line reaches further. Except for
    /// rounding, the bound is at most 0.1 % too large, and it never exceeds radiusAboutOrigin(). For a
    /// direction that is 0 or not finite it is radiusAboutOrigin(). Takes a few microseconds.
    double radiusAboutAxis(const Vector3& direction) const;

    /// Upper bound of the largest distance that a vertex in the tree moves from one pose to the other. Its
    /// relative excess is at most 1e-6, apart from rounding (1e-14 of radiusAboutOrigin() and of the distance
    /// between the translations). With a cap: if a vertex moves further than the cap, the answer is only
    /// known to be above the cap. Takes a few microseconds.
    double displacement(const Pose& from, const Pose& to, std::optional<double> cap = std::nullopt) const;

    /// The range of the model, present only if triangles were left out. Such a model can only be queried as
    /// the environment, with a part and at poses within the range. Up to the cap its answers are those of the
    /// whole mesh. Other queries are refused.
    const std::optional<QueryRange>& range() const;

    /// A number unique to each model of the process that was built or loaded; equal for copies.
    std::uint64_t id() const;

    /// modelKey of the mesh, options and range that the model was built from, also for a loaded model.
    std::uint64_t key() const;

  private:
    friend struct ModelAccess;
    struct Data;
    explicit Model(std::shared_ptr<const Data> data);
    static std::uint64_t newId();
    std::shared_ptr<const Data> data_;
};

/// A hash of everything that determines a model: the mesh with its names, the options that shape the tree,
/// the range, and the version of the build. Not cryptographic.
std::uint64_t modelKey(const Mesh& mesh, const BuildOptions& options,
                       const std::optional<QueryRange>& range = std::nullopt);

/// The result of buildCached.
struct CachedModel {
    Model model;            ///< answers as a model built from the mesh, options and range
    bool isLoaded = false;  ///< false: built
    std::string warning;    ///< why a file could not be used or written; empty otherwise
    bool isKept = true;     ///< whether the folder holds the model for the next time
};

/// Loads the model from the folder's file for its key, or else builds the model and saves it there. Makes the
/// folder if it does not exist, and replaces a damaged file. Throws what build throws; a folder that cannot be
/// read or written is a warning.
CachedModel buildCached(const Mesh& mesh, const BuildOptions& options, const std::string& folder,
                        const std::optional<QueryRange>& range = std::nullopt);

}  // namespace clearway

#pragma GCC visibility pop
