// demos/certificate.cpp: shows what certified motions are. A cover, 2 mm thin, moves in a space of the size
// of a car: first through a panel as thin as itself, then past the panel's edge. Millimetres.
#include <clearway/planning/problem_setup.h>
#include <ompl/base/DiscreteMotionValidator.h>

#include <algorithm>
#include <cstdio>

namespace cp = clearway::planning;
using clearway::Vector3;

clearway::Model box(const char* name, const Vector3& low, const Vector3& high) {
    return clearway::Model::build(clearway::boxMesh({low, high}, name));
}

clearway::PartState at(const Vector3& position, double turnAboutZ) {
    clearway::PartState state;
    state.position = position;
    state.rotation = Eigen::AngleAxisd(turnAboutZ, Vector3::UnitZ());
    return state;
}

const char* say(bool isValid) {
    return isValid ? "valid" : "not valid";
}

/// A motion that collides, but only along 4 of its 304 mm.
void throughThePanel(const ompl::base::SpaceInformationPtr& si, const cp::MotionValidator& certified) {
    const auto path = cp::pathThrough(si, {at({-152, 0, 0}, 0), at({152, 0, 0}, 0)});
    const auto *from = path.getState(0), *to = path.getState(1);
    std::printf("1. Straight through the panel, from x = -152 to 152:\n");
    for (const double share : {0.01, 0.0012}) {  // of the space's extent: 69 and 8 mm
        si->setStateValidityCheckingResolution(share);
        si->setup();
        std::printf("   OMPL's check, %4g %% of the space apart:  %s (%u states)\n", 100 * share,
                    say(ompl::base::DiscreteMotionValidator(si).checkMotion(from, to)),
                    si->getStateSpace()->validSegmentCount(from, to) + 1);
    }
    const bool isCertified = certified.checkMotion(from, to);
    std::printf("   certified:                                %s (%zu distances)\n", say(isCertified),
                std::size_t(certified.counters().queries));
    const cp::MotionReport report = certified.report(from, to);
    std::printf("   Valid up to t = %.6f. At t = %.6f it is %s.\n", report.certifiedTime, report.blockedTime,
                report.whyInvalid.words().c_str());
}

/// A valid motion, with its certified clearance between the poses that were looked at.
void pastTheEdge(const ompl::base::SpaceInformationPtr& si, const cp::MotionValidator& certified) {
    const auto path = cp::pathThrough(si, {at({-150, 601, 0}, -0.35), at({150, 601, 0}, 0.35)});
    const cp::MotionProfile profile = certified.profile(path.getState(0), path.getState(1));
    const auto& [report, points] = profile;
    std::printf("2. Past the panel's edge, 1 mm beside it, turning by 40 degrees:\n");
    std::printf(
        "   certified: %s, with %zu distances. Its least clearance is between %.4f and %.4f, at t = %.4f.\n",
        say(report.verdict == cp::MotionVerdict::kValid), std::size_t(report.queries), report.lowerClearance,
        report.upperClearance, report.closestTime);
    std::printf("   stretch of t      no pose of it is closer than\n");
    const auto isLess = [](const auto& a, const auto& b) { return a.lowerToNext < b.lowerToNext; };
    for (std::size_t i = 0; i + 1 < points.size(); i += 4) {  // four stretches a line
        const std::size_t end = std::min(i + 4, points.size() - 1);
        const auto least = std::min_element(points.begin() + i, points.begin() + end, isLess);
        std::printf("   %.4f to %.4f  %8.4f\n", points[i].time, points[end].time, least->lowerToNext);
    }
}

int main() {
    const clearway::Scene scene(box("cover", {-1, -100, -60}, {1, 100, 60}),
                                box("panel", {-1, -500, -400}, {1, 500, 400}));
    clearway::Problem problem;  // made in memory
    problem.volume = clearway::Box(Vector3(-2000, -2000, -2000), Vector3(2000, 2000, 2000));
    problem.start = at({-1000, 0, 0}, 0);
    problem.goal = at({1000, 0, 0}, 0);
    const auto si = cp::makeSetup(problem, scene).getSpaceInformation();
    const cp::MotionValidator& certified = cp::motionValidatorOf(si);
    throughThePanel(si, certified);
    pastTheEdge(si, certified);
}
