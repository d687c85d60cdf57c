#include "program/cli/csv_cells.h"

#include <boost/algorithm/string/replace.hpp>

#include "core/number.h"

namespace clearway::cli {

std::string textCell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    return '"' + boost::replace_all_copy(text, "\"", "\"\"") + '"';
}

std::string numberCells(const Vector3& point) {
    return formatNumber(point.x()) + "," + formatNumber(point.y()) + "," + formatNumber(point.z());
}

std::string numberCells(const PartState& state) {
    const auto& q = state.rotation;
    return numberCells(state.position) + "," + numberCells(Vector3(q.vec())) + "," + formatNumber(q.w());
}

std::string numberCells(const Pose& pose) {
    const Eigen::Quaterniond q(pose.rotation);
    return numberCells(pose.translation) + "," + numberCells(Vector3(q.vec())) + "," + formatNumber(q.w());
}

}  // namespace clearway::cli
