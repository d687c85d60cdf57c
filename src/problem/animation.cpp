#include "clearway/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <ostream>

#include "clearway/errors.h"
#include "core/replace_file.h"
#include "mesh/glb.h"
#include "problem/path_line.h"

namespace clearway {

namespace {

/// The largest distance of a vertex in use from the mesh's origin.
double radiusAboutOrigin(const Mesh& mesh) {
    double radius = 0;
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) radius = std::max(radius, mesh.vertices[vertex].norm());
    }
    return radius;
}

/// Keys of the animation. Each quaternion has the sign closest to the previous one, because not every viewer
/// turns the shorter way.
std::vector<GlbKey> keysOf(const PathLine& line, double begin, double end) {
    std::vector<GlbKey> keys;
    Eigen::Vector4d last = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < line.states().size(); ++i) {
        const PartState& state = line.states()[i];
        const auto seconds = static_cast<float>(begin + (end - begin) * line.shares()[i]);
        if (!keys.empty() && !(seconds > keys.back().seconds)) continue;  // times must rise
        Eigen::Vector4d q = state.rotation.coeffs().normalized();
        if (q.dot(last) < 0) q = -q;
        last = q;
        const Eigen::Vector3f p = state.position.cast<float>();
        const Eigen::Vector4f r = q.cast<float>();
        keys.push_back({seconds, {p.x(), p.y(), p.z()}, {r.x(), r.y(), r.z(), r.w()}});
    }
    return keys;
}

GlbMover moverOf(const MovingPart& part) {
    const std::string name = part.name.empty() ? "moving part" : part.name;
    if (!(part.begin >= 0 && part.end > part.begin && part.end < 1e9))
        throw ArgumentError(fmt::format("'{}' moves from {:g} to {:g} s, expected 0 <= begin < end", name,
                                        part.begin, part.end));
    std::vector<SavePart> parts = savePartsOf(part.mesh, "part");
    const PathLine line(part.path, radiusAboutOrigin(part.mesh));
    return {name, std::move(parts), keysOf(line, part.begin, part.end),
            part.disappearsAtEnd ? static_cast<float>(part.end) : -1};
}

}  // namespace

void saveAnimation(const Mesh& still, const std::vector<MovingPart>& moving, double metresPerUnit,
                   const std::string& file) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (!boost::iequals(ending, ".glb"))
        throw ArgumentError("the ending of '" + file + "' is '" + ending + "', expected .glb");
    if (!(metresPerUnit > 0 && metresPerUnit < 1e9))
        throw ArgumentError(fmt::format("metresPerUnit is {:g}, expected a number above 0", metresPerUnit));
    std::vector<GlbMover> movers;
    for (const MovingPart& part : moving) movers.push_back(moverOf(part));
    std::vector<SavePart> parts;
    if (!still.triangles.empty() || movers.empty()) parts = savePartsOf(still, "environment");
    replaceFile(file, [&](std::ostream& stream) { writeMovingGlb(parts, movers, metresPerUnit, stream); });
}

}  // namespace clearway
