#include "support/ppl_mesh.h"

#include <boost/algorithm/string/predicate.hpp>
#include <set>
#include <tuple>

#include "support/byu_mesh.h"

namespace clearway::testing {

Mesh loadPplMesh(const std::string& file) {
    const bool isByu = boost::iends_with(file, ".g");
    Mesh mesh = isByu ? readByuMesh(file) : loadMesh(file);
    Vector3 sum = Vector3::Zero();
    double count = 0;
    std::set<std::tuple<double, double, double>> distinct;
    for (const Vector3& vertex : mesh.vertices) {
        // assimp makes a vertex for each corner of an .obj's triangle.
        if (!isByu && !distinct.emplace(vertex.x(), vertex.y(), vertex.z()).second) continue;
        sum += vertex;
        ++count;
    }
    mesh.origin.shift = -sum / count;
    for (Vector3& vertex : mesh.vertices) vertex += mesh.origin.shift;
    return mesh;
}

}  // namespace clearway::testing
