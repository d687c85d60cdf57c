// A mesh made ready for queries: cleaned, bounded by a tree of rectangle swept spheres, immutable.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/build_report.h"
#include "clearway/mesh.h"

namespace clearway {

struct FlatTree;

/// Copying is cheap: copies share one immutable tree, which any number of threads may query at once.
class Model {
  public:
    /// Throws std::invalid_argument when a vertex of a triangle is not finite (naming the first such triangle), an index
    /// is out of range, the components do not cover the triangles, the mesh has no triangle, or an option is unknown.
    static Model build(const Mesh& mesh, const BuildOptions& options = {});

    const BuildReport& report() const;
    const Box& box() const;                            ///< of the triangles, mesh coordinates
    const std::vector<Component>& components() const;  ///< at least one
    const MeshOrigin& origin() const;

    /// Largest distance of a vertex from the origin of mesh coordinates: how far a rotation about it can reach.
    double radiusAboutOrigin() const;

    /// Different for every built model of the process, equal for copies.
    std::uint64_t id() const;

    /// For the query layer only.
    const FlatTree& tree() const;

  private:
    struct Data;
    explicit Model(std::shared_ptr<const Data> data);
    std::shared_ptr<const Data> data_;
};

}  // namespace clearway
