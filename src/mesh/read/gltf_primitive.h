// The primitives of a glTF mesh as one node shows them: deformed by morph targets and a skin, then placed.
// Source: Khronos Group, glTF 2.0 Specification, 3.7 "Concepts", Geometry.
#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include "mesh/read/collector.h"
#include "mesh/read/gltf_accessor.h"

namespace clearway {

/// How a node shows its mesh.
struct GltfShowing {
    Placement X_fileMesh;           ///< unless there is a skin
    std::vector<Placement> joints;  ///< of the skin: from coordinates of the mesh to those of the file
    std::string skin;               ///< name for messages; empty without a skin
    std::vector<double> weights;    ///< of morph targets; empty: all are 0
    bool isMirrored = false;        ///< the triangles are turned over, so that fronts stay outside
};

/// Adds the primitives of one component. Primitives that have equal vertices share them.
class GltfComponent {
  public:
    GltfComponent(GltfFile& file, const GltfShowing& showing, MeshCollector& mesh)
        : file_(file), showing_(showing), mesh_(mesh) {}

    void add(const GltfItem& primitive);

  private:
    struct Target {
        std::size_t position;  ///< among the primitive's targets
        GltfAccessor moves;
        double weight;
    };
    /// The vertices of a primitive.
    struct Vertices {
        GltfAccessor positions;
        std::vector<Target> targets;
        std::vector<GltfAccessor> joints, weights;  ///< sets of four
        std::string name;                           ///< of the primitive
    };
    /// The places of vertices in the collector.
    struct Added {
        bool isWhole = false;
        std::uint32_t first = 0;                                  ///< if all vertices are there
        std::unordered_map<std::uint32_t, std::uint32_t> places;  ///< otherwise
    };
    struct Corners {
        std::size_t mode, count;
        std::optional<GltfAccessor> indices;

        std::size_t triangles() const { return mode == 4 ? count / 3 : count; }  ///< at most
    };

    Vertices verticesOf(const GltfItem& primitive, const GltfItem& attributes);
    void findTargets(Vertices& vertices, const GltfItem& primitive);
    void findJoints(Vertices& vertices, const GltfItem& attributes);
    Corners cornersOf(const GltfItem& primitive, const Vertices& vertices);
    void read(const Vertices& vertices, std::size_t first, std::size_t rows, Vector3* points) const;
    void bend(const Vertices& vertices, std::size_t first, std::size_t rows, Vector3* points) const;
    void addVertices(const Vertices& vertices, Added& added);
    void readCorners(const Vertices& vertices, const Corners& corners, std::size_t first, std::size_t rows,
                     Added& added, std::uint32_t* places);
    void addTriangles(const Vertices& vertices, const Corners& corners, Added& added);
    std::uint32_t placeOf(const Vertices& vertices, std::uint32_t vertex, Added& added);

    GltfFile& file_;
    const GltfShowing& showing_;
    MeshCollector& mesh_;
    /// By the numbers of all accessors that the vertices depend on.
    std::map<std::vector<std::size_t>, Added> added_;
};

}  // namespace clearway
