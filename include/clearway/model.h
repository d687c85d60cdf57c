// A mesh made ready for queries: cleaned, bounded by a tree of rectangle swept spheres, immutable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "clearway/build_options.h"
#include "clearway/mesh.h"

namespace clearway {

struct FlatTree;

/// What cleaning found. Nothing that has an extent is thrown away.
struct CleanReport {
    std::size_t weldedVertices = 0;      ///< vertices that were exactly equal to an earlier one
    std::size_t unusedVertices = 0;      ///< vertices no triangle refers to
    std::size_t degenerateTriangles = 0; ///< zero area; kept as the segment or point they are
    std::size_t duplicateTriangles = 0;  ///< same three vertices as an earlier triangle in any order; dropped
};

/// The shape of a tree.
struct TreeStatistics {
    std::size_t nodes = 0;                    ///< wide nodes
    std::size_t leaves = 0;
    std::vector<std::size_t> leavesBySize;    ///< [k] = leaves that hold k triangles; [0] unused
    int depth = 0;                            ///< wide nodes on the longest way from the root to a leaf
    double meanChildren = 0;                  ///< used lanes per node
    std::size_t bytes = 0;                    ///< everything kept, exact vertices and ids included
};

struct BuildReport {
    BuildOptions options;
    CleanReport clean;
    TreeStatistics tree;
    std::size_t triangles = 0;  ///< in the tree, duplicates left out
    double seconds = 0;         ///< cleaning, fitting, splitting and flattening
};

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
