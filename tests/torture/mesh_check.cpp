#include "torture/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "clearway/query.h"
#include "support/query_cases.h"

namespace clearway::testing {
namespace {

double largestOf(const Mesh& mesh) {
    double largest = 0;
    for (const Vector3& p : mesh.vertices) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return largest;
}

double largestMoved(const Mesh& mesh, const Pose& pose) {
    double largest = pose.translation.cwiseAbs().maxCoeff();
    for (const Vector3& p : mesh.vertices) largest = std::max(largest, (pose * p).cwiseAbs().maxCoeff());
    return largest;
}

template <typename Value>
std::string line(const char* what, const Value& says, double truth) {
    std::ostringstream text;
    text.precision(17);
    text << what << " is " << says << "; the truth is " << truth;
    return text.str();
}

}  // namespace

MeshCheck::MeshCheck(const MeshFamily& family)
    : family_(family),
      oracle_(family.part, family.environment),
      part_(Model::build(family.part)),
      environment_(Model::build(family.environment)),
      largest_(std::max(largestOf(family.part), largestOf(family.environment))) {}

Pose MeshCheck::draw(Random& random) {
    return adversarialPose(random, family_, [this](const Pose& pose) -> Vector3 {
        const DistanceResult result = distance(part_, environment_, pose, {}, workspace_);
        return result.witness->pointOnEnvironment - result.witness->pointOnPart;
    });
}

CheckedPose MeshCheck::check(const Pose& pose, Random& random) {
    CheckedPose checked;
    checked.distance = oracle_.distance(pose).distance;  // 0 exactly when they touch
    checked.touches = checked.distance == 0;
    const double truth = checked.distance;
    const auto require = [&](bool holds, const auto& describe) {
        if (!holds) checked.complaints.push_back(describe());
    };
    const auto verdict = [&](const char* what, bool says) {
        require(says == checked.touches, [&] { return line(what, says, truth); });
        checked.falseValid |= checked.touches && !says;
    };
    if (random.below(2) == 0) workspace_.forgetWarmStart();
    verdict("collides", collides(part_, environment_, pose, workspace_));
    verdict("isWithin(0)", isWithin(part_, environment_, pose, 0, workspace_));
    if (random.below(2) == 0) workspace_.forgetWarmStart();
    const DistanceResult result = distance(part_, environment_, pose, {}, workspace_);
    verdict("contact by distance", result.collides());

    const double M = std::max(largest_, largestMoved(family_.part, pose));
    // The oracle's error: its distance rounds once to double, and before that a little in long double.
    const double error = kUnitRoundoff * truth + (truth > 0 ? 0x1p-58 * M : 0);
    const double width = 1e-12 * sceneSize() + 32 * kUnitRoundoff * M;
    require(result.lower <= truth + error, [&] { return line("lower", result.lower, truth); });
    require(result.upper >= truth - error, [&] { return line("upper", result.upper, truth); });
    require(result.upper - result.lower <= width,
            [&] { return line("width", result.upper - result.lower, truth); });
    const double farther = truth * (1 + 0x1p-30) + 4 * error, nearer = truth * (1 - 0x1p-30) - 4 * error;
    require(isWithin(part_, environment_, pose, farther, workspace_),
            [&] { return line("isWithin a little farther", false, truth); });
    require(!(nearer > 0) || !isWithin(part_, environment_, pose, nearer, workspace_),
            [&] { return line("isWithin a little nearer", true, truth); });
    return checked;
}

}  // namespace clearway::testing
