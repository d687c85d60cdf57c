// Meshes and poses for tests: random soups, shapes like those in CAD files, and poses at a wanted gap. The
// same seed gives the same mesh on every machine; tests print the seed with BOOST_TEST_CONTEXT.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/types.h"

namespace clearway::testing {

/// Random numbers by splitmix64 (Steele, Lea, Flood 2014). Unlike the standard distributions, they do not
/// depend on the standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits();
    double uniform(double low, double high);
    int below(int end);  ///< 0 .. end - 1
    double normal();     ///< standard deviation 1
    Vector3 inBox(double halfSide);
    Vector3 direction();
    Matrix3 rotation();  ///< uniform; defect a few 2^-53
    Pose pose(double halfSide);

  private:
    std::uint64_t state_;
};

/// `triangles` triangles of about the given size, with centres in a cube of half side `halfSide`.
Mesh randomSoup(Random& random, int triangles, double halfSide, double size);

/// A height field of 2 n^2 triangles over [-size/2, size/2]^2; the heights are noise of the given amplitude.
Mesh randomTerrain(Random& random, int n, double size, double amplitude);

/// An axis-aligned box, each face of n x n quads.
Mesh box(const Vector3& halfSides, int n = 1);

/// A plate of the given thickness with a round hole of n sides: long slivers run from the hole to the border.
Mesh plateWithHole(double side, double thickness, double holeRadius, int n);

/// A pipe along z with n sides: both skins and the rims, undivided along its length, hence slivers.
Mesh tube(double innerRadius, double outerRadius, double length, int n);

/// A sphere of n stacks and 2 n slices.
Mesh sphere(double radius, int n);
Mesh torus(double ringRadius, double pipeRadius, int n);

/// Two plates at a right angle with a finely tessellated rounding between them.
Mesh bracket(double side, double thickness, double roundingRadius, int n);

/// All of the above shapes in one mesh, apart from each other, with sizes of about `size`.
Mesh cadAssembly(Random& random, double size);

Mesh joined(const Mesh& a, const Mesh& b);
Mesh transformed(const Mesh& mesh, const Pose& X_ab);
Mesh translated(const Mesh& mesh, const Vector3& by);
Mesh named(Mesh mesh, const std::string& name);  ///< with one component
Mesh assembled(const std::vector<Mesh>& parts);  ///< joined; each part is one component, and keeps its name
Mesh scaledBy(const Mesh& mesh, double factor);  ///< exact for powers of two
Mesh shuffled(Random& random,
              const Mesh& mesh);  ///< triangles, their corners and the vertices, each in another order

/// A named pair of meshes to run queries between, from the fixed list meshPairs().
struct MeshPair {
    std::string name;
    Mesh part;
    Mesh environment;
};

/// Random and CAD-like pairs of some hundred triangles each.
std::vector<MeshPair> meshPairs(std::uint64_t seed);

/// Moves the pose along -direction until distanceAt(pose) is about `gap` (bisection, 60 steps). The search
/// starts from a place `reach` away, where the distance must be larger than the gap. The distance should grow
/// along the direction.
Pose poseAtGap(const Pose& X_environmentPart, const Vector3& direction, double reach, double gap,
               const std::function<double(const Pose&)>& distanceAt);

}  // namespace clearway::testing
