#include "program/report/export_motion.h"

#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <ostream>
#include <stdexcept>

#include "core/replace_file.h"
#include "mesh/glb.h"
#include "program/report/path_line.h"

namespace clearway::report {

namespace {

/// Keys of the animation. Each quaternion has the sign closest to the previous one, because not every viewer
/// turns the shorter way.
std::vector<GlbKey> keysOf(const PathLine& line) {
    std::vector<GlbKey> keys;
    Eigen::Vector4d last = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < line.states().size(); ++i) {
        const PartState& state = line.states()[i];
        const auto seconds = static_cast<float>(kMotionSeconds * line.shares()[i]);
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

void requireMotionFile(const std::string& file) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (boost::iequals(ending, ".glb")) return;
    throw std::invalid_argument("the ending of '" + file + "' is '" + ending + "', expected .glb");
}

}  // namespace

void exportMotion(const Mesh& part, const Mesh& environment, const std::vector<PartState>& path,
                  double turnRadius, double metres, const std::string& file) {
    requireMotionFile(file);
    const GlbMotion motion{savePartsOf(environment, "environment"), savePartsOf(part, "part"), "moving part",
                           keysOf(PathLine(path, turnRadius)), metres};
    replaceFile(file, [&](std::ostream& stream) { writeMovingGlb(motion, stream); });
}

void exportStill(const Mesh& mesh, double metres, const std::string& file) {
    requireMotionFile(file);
    const GlbMotion still{savePartsOf(mesh, "mesh"), {}, "", {}, metres};
    replaceFile(file, [&](std::ostream& stream) { writeMovingGlb(still, stream); });
}

}  // namespace clearway::report
