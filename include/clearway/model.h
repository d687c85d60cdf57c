// A mesh made ready for queries: cleaned, bounded by a tree of rectangle swept spheres, immutable.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/build_report.h"
#include "clearway/mesh.h"
#include "clearway/reach.h"

namespace clearway {

struct FlatTree;

/// Copying is cheap: copies share one immutable tree, which any number of threads may query at once.
class Model {
  public:
    /// Throws std::invalid_argument when a vertex of a triangle is not finite (naming the first such
    /// triangle), an index is out of range, the components do not cover the triangles, the mesh has no
    /// triangle, an option is unknown or the reach is no box with two lengths.
    ///
    /// With a reach, for an environment: triangles that no pose within it can bring within its cap are left
    /// out and counted in the report; when it would be all, one stays. See reach().
    static Model build(const Mesh& mesh, const BuildOptions& options = {},
                       const std::optional<Reach>& reach = std::nullopt);

    /// Reads what save wrote. Throws std::runtime_error, naming the file and what is wrong with it, when it
    /// cannot be read, is no saved model, is damaged, or was saved by another version or on a machine of
    /// another byte order.
    static Model load(const std::string& file);

    /// Writes the model with its report and names. To a temporary name, then renamed. Throws
    /// std::runtime_error when it cannot be written.
    void save(const std::string& file) const;

    const BuildReport& report() const;
    const Box& box() const;  ///< of the triangles, left-out ones included; mesh coordinates
    const std::vector<Component>& components() const;  ///< at least one
    const MeshOrigin& origin() const;

    /// Largest distance of a vertex in the tree from the origin of mesh coordinates: how far a rotation about
    /// it can reach.
    double radiusAboutOrigin() const;

    /// Upper bound of the largest distance of a vertex in the tree from the line through the origin of mesh
    /// coordinates along a direction of any length: how far a rotation about that line can reach. At most
    /// 0.1 % too much, but for rounding, and never above radiusAboutOrigin(), which it is for a direction
    /// that is none (0, or not finite). Costs a few microseconds.
    double radiusAboutAxis(const Vector3& direction) const;

    /// Upper bound of the furthest that a vertex in the tree moves from one pose to the other. At most 1e-6
    /// of it too much, but for rounding: 1e-14 of radiusAboutOrigin() and of the way between the
    /// translations. With a cap: when a vertex moves further than it, the answer is above it, and may be that
    /// alone. Costs a few microseconds.
    double displacement(const Pose& from, const Pose& to,
                        double cap = std::numeric_limits<double>::infinity()) const;

    /// What the model is good for when triangles were left out for it, and only then: it is queried as the
    /// environment, at poses and with a part within the reach, and answers up to the cap as the whole mesh
    /// would. Queries that it cannot answer are refused.
    const std::optional<Reach>& reach() const;

    /// Different for every built model of the process, equal for copies.
    std::uint64_t id() const;

    /// modelKey of the mesh, options and reach it was built from, also when it was loaded.
    std::uint64_t key() const;

    /// For the query layer only.
    const FlatTree& tree() const;

  private:
    struct Data;
    explicit Model(std::shared_ptr<const Data> data);
    static std::uint64_t newId();
    std::shared_ptr<const Data> data_;
};

/// A hash of all that a model is made of: the mesh with its names, the options that shape the tree, the
/// reach, and the version of the build. Not cryptographic.
std::uint64_t modelKey(const Mesh& mesh, const BuildOptions& options,
                       const std::optional<Reach>& reach = std::nullopt);

struct CachedModel {
    Model model;
    bool isLoaded = false;  ///< false: built, and saved for the next time
    std::string warning;  ///< why a file that was there could not be used; empty when there is nothing to say
};

/// The model of the mesh from the folder's file of that key, else built and saved there. The folder is made
/// if need be. A damaged file is replaced. Throws what build and save throw.
CachedModel buildCached(const Mesh& mesh, const BuildOptions& options, const std::string& folder,
                        const std::optional<Reach>& reach = std::nullopt);

}  // namespace clearway
