// A program of a user without OMPL: the distance of two triangles that were made in memory, as one number with 17 digits.
// The triangles' vertices are doubles that no float holds. Errors that the library throws are caught by their types here.
#include <clearway/errors.h>
#include <clearway/model.h>
#include <clearway/query.h>
#include <clearway/version.h>

#include <cstdio>

static_assert(CLEARWAY_VERSION_VALUE >= 2000, "0.2.0 or later");

/// Whether the call throws a Type that is caught by its base, too, and as the Standard exception.
template <class Type, class Standard, class Call>
bool throws(const Call& call) {
    try {
        call();
    } catch (const clearway::Error& error) {
        return dynamic_cast<const Type*>(&error) && dynamic_cast<const Standard*>(&error);
    }
    return false;
}

int main() {
    using namespace clearway;
    if (!throws<ArgumentError, std::invalid_argument>([] { Model::build(Mesh()); })) return 2;
    if (!throws<FileError, std::runtime_error>([] { loadMesh("missing.stl"); })) return 3;
    const auto triangle = [](double z) {
        clearway::Mesh mesh;
        mesh.vertices = {{0.1, 0, z}, {1.3, 0, z}, {0.1, 1.7, z}};
        mesh.triangles = {{0, 1, 2}};
        return clearway::Model::build(mesh);
    };
    Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
    turned.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    turned.translation() = Eigen::Vector3d(0.2, 0.3, 4.1);
    const clearway::DistanceResult result =
        clearway::distance(triangle(0.3), triangle(-0.7), clearway::toPose(turned));
    if (!(result.lower <= result.distance && result.distance <= result.upper)) return 1;
    std::printf("%.17g\n", result.distance);
}
