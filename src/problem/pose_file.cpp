// Pose files: 12 numbers a line (rotation row-major, translation) or 7 (x y z qx qy qz qw).
#include <ostream>
#include <stdexcept>

#include "clearway/problem.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "problem/state_lines.h"

namespace clearway {

namespace {

Pose poseOfMatrix(const NumberLine& line) {
    const std::vector<double>& n = line.numbers;
    Pose pose;
    pose.rotation << n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8];
    pose.translation << n[9], n[10], n[11];
    return pose;
}

/// A pose that queries accept; counts it when its rotation had to be projected.
Pose acceptable(const Pose& pose, const NumberLine& line, const std::string& file, std::size_t& projected) {
    const double defect = rotationDefect(pose);
    if (defect <= kPoseDefect) return pose;
    if (!(defect <= kProjectableDefect)) {
        throw std::invalid_argument(place(file, line.line) + "the rotation is none: max |R^T R - I| is " +
                                    shortNumber(defect) + " and det R " +
                                    shortNumber(pose.rotation.determinant()) + ", expected at most " +
                                    shortNumber(kProjectableDefect) + " and above 0");
    }
    ++projected;
    return nearestPose(pose);
}

}  // namespace

PoseFile readPoses(const std::string& file) {
    PoseFile result;
    for (const NumberLine& line : readNumberLines(file, "a pose file with one pose a line")) {
        const std::vector<double>& n = line.numbers;
        if (n.size() == 7) {
            result.poses.push_back(poseOf({{n[0], n[1], n[2]}, quaternionAt(line, 3, file)}));
        } else if (n.size() == 12) {
            result.poses.push_back(acceptable(poseOfMatrix(line), line, file, result.projected));
        } else {
            throw std::invalid_argument(
                place(file, line.line) + "the line has " + std::to_string(n.size()) +
                (n.size() == 1 ? " number" : " numbers") +
                ", expected 12 (rotation row-major, translation) or 7 (x y z qx qy qz qw)");
        }
    }
    return result;
}

void writePoses(const std::vector<Pose>& poses, const std::string& file) {
    replaceFile(file, [&](std::ostream& stream) {
        for (const Pose& pose : poses) {
            for (int row = 0; row < 3; ++row) {
                for (int k = 0; k < 3; ++k) stream << formatNumber(pose.rotation(row, k)) << " ";
            }
            const Vector3& p = pose.translation;
            stream << formatNumber(p.x()) << " " << formatNumber(p.y()) << " " << formatNumber(p.z()) << "\n";
        }
    });
}

}  // namespace clearway
