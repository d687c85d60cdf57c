// The table of fits, which choose the volume of a node, and the fitting of a whole tree. A new fit is one
// function in fits.cpp and one row here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "build/frame_search.h"
#include "build/leaf_order.h"

namespace clearway {

/// Mean and spread of a surface. Each part weighs as much as its area, so that the moments do not depend on
/// how finely the surface is triangulated, as those of the vertices do.
struct AreaMoments {
    double area = 0;
    Vector3 mean = Vector3::Zero();
    Matrix3 scatter = Matrix3::Zero();  ///< integral of (x - mean) (x - mean)^T

    static AreaMoments ofTriangle(const Vector3& a, const Vector3& b, const Vector3& c);

    /// Adds the moments of another set of triangles; the sum is that of the union.
    AreaMoments& operator+=(const AreaMoments& other);

    /// Orthonormal axes of the spread. The area must be above 0.
    Matrix3 axes() const;
};

/// A node to be fitted.
struct FitInput {
    const LeafOrder& mesh;
    std::uint32_t firstTriangle;  ///< of the node, in the order of the mesh
    std::uint32_t triangleCount;
    const std::vector<Vector3>& points;  ///< the node's distinct vertices
    const AreaMoments& moments;          ///< of the node's triangles, in some unit
    const Matrix3* parentAxes;           ///< of the parent's volume; null for the root
};

/// Reused from node to node for its storage. Not to be shared by threads.
struct FitScratch {
    FrameSearch frames;
    std::vector<Vector3> corners;
};

/// A fit returns an RSS that holds all of the node's points. The result must depend on the input alone, not
/// on earlier uses of the scratch.
using Fit = Rss (*)(const FitInput& node, FitScratch& scratch);

/// The fit of least area over several frames: of the vertices' covariance, of the area's covariance, of the
/// parent, of the model's own axes and, for nodes of up to 4 or of 17 to 64 triangles, along edges of the
/// largest triangles.
Rss fitLeastOfFrames(const FitInput& node, FitScratch& scratch);

/// PQP's fit, in the frame of the corners' covariance: a vertex weighs as much as the number of the node's
/// triangles around it.
Rss fitByCovariance(const FitInput& node, FitScratch& scratch);

struct NamedFit {
    const char* name;
    Fit fit;
};

constexpr NamedFit kFits[] = {
    {"frames", fitLeastOfFrames},
    {"covariance", fitByCovariance},
};

/// Throws ArgumentError that lists the known names.
const NamedFit& fitNamed(const std::string& name);

/// Fits every node of the tree to the vertices of the triangles below it, parents before their children,
/// subtrees in parallel. The result does not depend on the number of threads.
void fitVolumes(BinaryTree& tree, const LeafOrder& mesh, Fit fit);

}  // namespace clearway
