// Path files and pose files: one state or pose a line, as numbers between white space. Blank lines and lines
// that begin with # are skipped.
#include "clearway/problem.h"

#include <fmt/format.h>
#include <ostream>
#include <string>
#include <vector>

#include "clearway/errors.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "problem/rotation.h"

namespace clearway {
namespace {

struct NumberLine {
    int line = 0;  ///< counted from 1
    std::vector<double> numbers;
};

/// The lines of numbers of a file. Throws FileError when the file cannot be read, and
/// ArgumentError when a word is not a finite number (naming the line) or no line has numbers.
/// expected: "a path file", for the messages.
std::vector<NumberLine> readNumberLines(const std::string& file, const char* expected) {
    std::vector<NumberLine> found;
    int lineNumber = 0;
    for (const std::string& text : readLines(file, expected)) {
        ++lineNumber;
        NumberLine line{lineNumber, {}};
        const std::vector<std::string_view> given = words(text);
        if (given.empty() || given[0][0] == '#') continue;
        for (const std::string_view word : given) {
            const std::optional<double> number = parseNumber(word);
            if (!number) {
                throw ArgumentError(place(file, lineNumber) + quote(word) + " is not a finite number");
            }
            line.numbers.push_back(*number);
        }
        found.push_back(std::move(line));
    }
    if (found.empty()) throw ArgumentError(file + ": no line with numbers, expected " + expected);
    return found;
}

/// The quaternion (qx qy qz qw) from the given position in the line on, scaled to unit length. Throws
/// ArgumentError naming the line when its length is 0.
Rotation quaternionAt(const NumberLine& line, std::size_t position, const std::string& file) {
    const double* q = line.numbers.data() + position;
    const std::optional<Rotation> rotation = normalized(Rotation(q[3], q[0], q[1], q[2]));
    if (!rotation) {
        throw ArgumentError(place(file, line.line) +
                            "the quaternion is 0 0 0 0, expected one of length above 0");
    }
    return *rotation;
}

PartState stateOf(const NumberLine& line, Space space, const std::string& file) {
    const std::vector<double>& n = line.numbers;
    const std::size_t expected = space == Space::kSe3 ? 7 : 3;
    if (n.size() != expected) {
        throw ArgumentError(
            fmt::format("{}the line has {}{}, expected {}", place(file, line.line), n.size(),
                        n.size() == 1 ? " number" : " numbers",
                        space == Space::kSe3 ? "7: x y z qx qy qz qw, w last" : "3: x y yaw"));
    }
    if (space == Space::kSe3) return {{n[0], n[1], n[2]}, quaternionAt(line, 3, file)};
    return {{n[0], n[1], 0}, *fromAxisAngle({Vector3::UnitZ(), n[2]})};
}

std::string lineOf(const std::vector<double>& numbers) {
    std::vector<std::string> texts;
    for (const double number : numbers) texts.push_back(formatNumber(number));
    return joined(texts, " ") + "\n";
}

std::string lineOf(const PartState& state, Space space) {
    const Vector3& p = state.position;
    const Rotation& q = state.rotation;
    if (space == Space::kSe2) return lineOf({p.x(), p.y(), yawOf(q)});
    return lineOf({p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()});
}

Pose poseOfMatrix(const NumberLine& line) {
    const std::vector<double>& n = line.numbers;
    Pose pose;
    pose.rotation << n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8];
    pose.translation << n[9], n[10], n[11];
    return pose;
}

/// The pose as queries accept it. Counts it if its rotation has to be projected.
Pose acceptable(const Pose& pose, const NumberLine& line, const std::string& file, std::size_t& projected) {
    const double defect = rotationDefect(pose);
    if (defect <= kPoseDefect) return pose;
    if (!(defect <= kProjectableDefect)) {
        throw ArgumentError(place(file, line.line) + "the matrix is no rotation: max |R^T R - I| is " +
                            shortNumber(defect) + " and det R " + shortNumber(pose.rotation.determinant()) +
                            ", expected at most " + shortNumber(kProjectableDefect) + " and above 0");
    }
    ++projected;
    return nearestPose(pose);
}

}  // namespace

void writePath(const std::vector<PartState>& path, Space space, const std::string& file) {
    replaceFile(file, [&](std::ostream& stream) { writePath(path, space, stream); });
}

void writePath(const std::vector<PartState>& path, Space space, std::ostream& stream) {
    for (const PartState& state : path) stream << lineOf(state, space);
}

std::vector<PartState> readPath(const std::string& file, Space space) {
    std::vector<PartState> path;
    for (const NumberLine& line : readNumberLines(file, "a path file with one state a line")) {
        path.push_back(stateOf(line, space, file));
    }
    return path;
}

PoseFile readPoses(const std::string& file) {
    PoseFile result;
    for (const NumberLine& line : readNumberLines(file, "a pose file with one pose a line")) {
        const std::vector<double>& n = line.numbers;
        if (n.size() == 7) {
            result.poses.push_back(poseOf({{n[0], n[1], n[2]}, quaternionAt(line, 3, file)}));
        } else if (n.size() == 12) {
            result.poses.push_back(acceptable(poseOfMatrix(line), line, file, result.projected));
        } else {
            throw ArgumentError(
                fmt::format("{}the line has {}{}, expected 12 (rotation row-major, translation) or 7 (x y z "
                            "qx qy qz qw, w last)",
                            place(file, line.line), n.size(), n.size() == 1 ? " number" : " numbers"));
        }
    }
    return result;
}

void writePoses(const std::vector<Pose>& poses, const std::string& file) {
    replaceFile(file, [&](std::ostream& stream) {
        for (const Pose& pose : poses) {
            const Matrix3& R = pose.rotation;
            const Vector3& p = pose.translation;
            stream << lineOf({R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2),
                              p.x(), p.y(), p.z()});
        }
    });
}

}  // namespace clearway
