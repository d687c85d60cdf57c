// How well OpenCASCADE keeps the deflection that it is asked for: by exact distances from many points on the surfaces to the triangles.
// Prints the table of docs/accuracy.md.
#include <BRepTools.hxx>
#include <boost/test/unit_test.hpp>
#include <cstdio>

#include "cad/cad_file.h"
#include "cad/solids.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "mesh/clean.h"
#include "mesh/topology.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(deflection_test)

constexpr int kPoints = 40000;  ///< on each solid

/// The largest distance from points on the surface to the mesh.
double farthest(const TopoDS_Shape& shape, const Mesh& mesh) {
    Mesh point;
    point.vertices = {Vector3::Zero()};
    point.triangles = {{0, 0, 0}};
    const Model part = Model::build(point), environment = Model::build(mesh);
    Workspace workspace;
    double most = 0;
    for (const Vector3& at : surfacePoints(shape, kPoints)) {
        Pose X_environmentPart;
        X_environmentPart.translation = at;
        most = std::max(most, distance(part, environment, X_environmentPart, {}, workspace).upper);
    }
    return most;
}

BOOST_AUTO_TEST_CASE(points_on_the_surface_are_near_the_triangles) {
    std::printf(
        "| solid | triangles | at 1/1000 of the diagonal | triangles | at 1/100 |\n|---|---|---|---|---|\n");
    for (const NamedSolid& solid : curvedSolids()) {
        std::printf("| %s ", solid.name.c_str());
        for (const double share : {1e-3, 1e-2}) {
            cad::CadFile file;
            file.parts.push_back({solid.name, solid.shape, gp_Trsf()});
            const double fine = cad::tessellate(file, std::nullopt, "").components[0].deflection;
            const double deflection = fine * share / cad::kUsualDeflection;
            BRepTools::Clean(solid.shape);
            const Mesh mesh = cad::tessellate(file, deflection, "");
            const double ratio = farthest(solid.shape, mesh) / deflection;
            std::printf("| %zu | %.2f ", mesh.triangles.size(), ratio);
            BOOST_TEST(ratio < 2, solid.name << " at " << share);
            BOOST_TEST(checkEdges(clean(mesh).triangles).isClosed(), solid.name);
            BRepTools::Clean(solid.shape);
        }
        std::printf("|\n");
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
