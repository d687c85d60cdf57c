// The .path files OMPL prints: x y z qx qy qz qw a line, or x y yaw in SE(2).
#include <ostream>
#include <stdexcept>

#include "clearway/problem.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "problem/state_lines.h"

namespace clearway {

namespace {

PartState stateOf(const NumberLine& line, Space space, const std::string& file) {
    const std::vector<double>& n = line.numbers;
    const std::size_t expected = space == Space::kSe3 ? 7 : 3;
    if (n.size() != expected) {
        throw std::invalid_argument(place(file, line.line) + "the line has " + std::to_string(n.size()) +
                                    (n.size() == 1 ? " number" : " numbers") + ", expected " +
                                    (space == Space::kSe3 ? "7: x y z qx qy qz qw" : "3: x y yaw"));
    }
    if (space == Space::kSe3) return {{n[0], n[1], n[2]}, quaternionAt(line, 3, file)};
    return {{n[0], n[1], 0}, *fromAxisAngle({Vector3::UnitZ(), n[2]})};
}

std::string lineOf(const PartState& state, Space space) {
    const Vector3& p = state.position;
    const Rotation& q = state.rotation;
    std::vector<double> numbers = {p.x(), p.y(), yawOf(q)};
    if (space == Space::kSe3) numbers = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    std::string line;
    for (const double number : numbers) line += (line.empty() ? "" : " ") + formatNumber(number);
    return line + "\n";
}

}  // namespace

void writePath(const std::vector<PartState>& path, Space space, const std::string& file) {
    replaceFile(file, [&](std::ostream& stream) {
        for (const PartState& state : path) stream << lineOf(state, space);
    });
}

std::vector<PartState> readPath(const std::string& file, Space space) {
    std::vector<PartState> path;
    for (const NumberLine& line : readNumberLines(file, "a path file with one state a line")) {
        path.push_back(stateOf(line, space, file));
    }
    return path;
}

}  // namespace clearway
