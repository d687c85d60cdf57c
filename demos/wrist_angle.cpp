// demos/wrist_angle.cpp: clearway checks an OMPL program that has a state space of its own. A carriage drives in
// the plane and holds a plate by a wrist. The plate must lie flat to pass a slit, and stand upright to pass another.
#include <clearway/planning/audit.h>
#include <clearway/planning/validity_checker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>
#include <cstdio>

namespace ob = ompl::base;
namespace cp = clearway::planning;
using clearway::Vector3;

clearway::Mesh joined(const std::vector<clearway::Box>& boxes) {
    clearway::Mesh mesh;
    for (const clearway::Box& box : boxes) {
        const clearway::Mesh one = clearway::boxMesh(box);
        const auto first = std::uint32_t(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (const auto& [a, b, c] : one.triangles)
            mesh.triangles.push_back({first + a, first + b, first + c});
    }
    return mesh;
}

/// The part is rigid, so clearway needs no more than its pose in each state of the space, and how its points move.
class Carriage {
  public:
    explicit Carriage(const clearway::Model& part)
        : radius_(part.radiusAboutOrigin()), radiusAboutWrist_(part.radiusAboutAxis(Vector3::UnitX())) {
        auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
        plane->setBounds(-150, 150);
        // Weighted by how far the part's points move, so that OMPL's distances are lengths.
        space->addSubspace(plane, 1);
        space->addSubspace(std::make_shared<ob::SO2StateSpace>(), kArm + radius_);     // yaw
        space->addSubspace(std::make_shared<ob::SO2StateSpace>(), radiusAboutWrist_);  // wrist
        space->lock();
    }

    Carriage(const Carriage&) = delete;  // the functions below refer to this object

    struct Values {
        double x, y, yaw, wrist;
    };

    static Values valuesOf(const ob::State* state) {
        const auto& parts = *state->as<ob::CompoundState>();
        const double* position = parts.as<ob::RealVectorStateSpace::StateType>(0)->values;
        return {position[0], position[1], parts.as<ob::SO2StateSpace::StateType>(1)->value,
                parts.as<ob::SO2StateSpace::StateType>(2)->value};
    }

    /// The carriage's frame turns by yaw about z. The part's is kArm ahead of it, and turns about the heading.
    static clearway::Pose poseAt(const Values& at) {
        const clearway::Matrix3 yaw = Eigen::AngleAxisd(at.yaw, Vector3::UnitZ()).toRotationMatrix();
        const clearway::Matrix3 wrist = Eigen::AngleAxisd(at.wrist, Vector3::UnitX()).toRotationMatrix();
        return {yaw * wrist, Vector3(at.x, at.y, 0) + yaw * Vector3(kArm, 0, 0)};
    }

    /// From one state to another, as OMPL interpolates: each value at a constant rate, angles the shorter way.
    static Values wayBetween(const Values& from, const Values& to) {
        const auto turn = [](double angle) {
            return angle > M_PI ? angle - 2 * M_PI : angle < -M_PI ? angle + 2 * M_PI : angle;
        };
        return {to.x - from.x, to.y - from.y, turn(to.yaw - from.yaw), turn(to.wrist - from.wrist)};
    }

    /// No point of the part moves further on this way: kArm + radius_ is how far points are from the yaw's axis.
    double lengthOf(const Values& way) const {
        const double length = std::hypot(way.x, way.y) + std::abs(way.yaw) * (kArm + radius_) +
                              std::abs(way.wrist) * radiusAboutWrist_;
        return length * (1 + 1e-12);  // rounding
    }

    /// Returns a stretch of the way as seen from its middle. Velocities are per unit of time, from 0 to 1.
    clearway::MotionPiece pieceOf(const Values& start, const Values& way, double from, double to) const {
        const double t = from + (to - from) / 2, half = (to - from) / 2;
        const Values middle = {start.x + t * way.x, start.y + t * way.y, start.yaw + t * way.yaw,
                               start.wrist + t * way.wrist};
        const Vector3 heading(std::cos(middle.yaw), std::sin(middle.yaw), 0), up = Vector3::UnitZ();
        clearway::MotionPiece piece;
        piece.middle = poseAt(middle);
        piece.velocity = Vector3(way.x, way.y, 0) + way.yaw * up.cross(kArm * heading);
        piece.angularVelocity = way.yaw * up + way.wrist * heading;
        // Points leave straight lines by at most half^2 / 2 times their largest acceleration: that of the yaw, that of
        // the wrist, and Coriolis'.
        const double yaw = std::abs(way.yaw), wrist = std::abs(way.wrist);
        piece.deviation =
            half * half / 2 *
            (yaw * yaw * (kArm + radius_) + (wrist * wrist + 2 * yaw * wrist) * radiusAboutWrist_);
        return piece;
    }

    const cp::StateToPose pose = [](const ob::State* state) { return poseAt(valuesOf(state)); };
    const cp::DisplacementBound bound = [this](const ob::State* from, const ob::State* to) {
        return lengthOf(wayBetween(valuesOf(from), valuesOf(to)));
    };
    const cp::StateMotion motion = [this](const ob::State* from, const ob::State* to) {
        const Values start = valuesOf(from), way = wayBetween(start, valuesOf(to));
        return clearway::PartMotion{
            [this, start, way](double begin, double end) { return pieceOf(start, way, begin, end); },
            lengthOf(way), /*endJump*/ 0};
    };
    const std::shared_ptr<ob::CompoundStateSpace> space = std::make_shared<ob::CompoundStateSpace>();

  private:
    static constexpr double kArm = 30;  ///< from the axis of the yaw to the origin of the part's coordinates
    double radius_, radiusAboutWrist_;
};

/// With a rib along one edge.
clearway::Mesh plate() {
    return joined({{Vector3(-10, -20, -2), Vector3(20, 20, 2)}, {Vector3(-10, 16, -2), Vector3(20, 20, 6)}});
}

/// Two walls: the slit of the first one lies flat, that of the other stands upright.
clearway::Mesh walls() {
    const double end = 200;
    return joined({{Vector3(-5, -end, 12), Vector3(5, end, end)},
                   {Vector3(-5, -end, -end), Vector3(5, end, -12)},
                   {Vector3(65, 12, -end), Vector3(75, end, end)},
                   {Vector3(65, -end, -end), Vector3(75, -12, end)}});
}

int main() {
    const clearway::Scene scene(clearway::Model::build(plate()), clearway::Model::build(walls()),
                                /*margin*/ 0.5);
    const Carriage carriage(scene.part);
    ompl::geometric::SimpleSetup setup(carriage.space);
    const auto si = setup.getSpaceInformation();
    const cp::SharedScene shared(scene, carriage.pose, carriage.bound, carriage.motion);
    si->setStateValidityChecker(std::make_shared<cp::ValidityChecker>(si, shared));
    const auto motions = std::make_shared<cp::MotionValidator>(si, shared);
    si->setMotionValidator(motions);  // certified pair by pair

    ompl::RNG::setSeed(1);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(si));
    setup.getPlanner()->params().setParam("range", "40");
    ob::ScopedState<> start(carriage.space), goal(carriage.space);
    start = std::vector<double>{-100, 0, 0, M_PI / 2};
    goal = std::vector<double>{120, 0, M_PI / 2, 0};
    setup.setStartAndGoalStates(start, goal);
    setup.solve(/*seconds*/ 60);
    if (!setup.haveExactSolutionPath()) return std::puts("no path found"), 1;

    ompl::geometric::PathGeometric& path = setup.getSolutionPath();
    std::printf("     x       y      yaw    wrist\n");
    for (const ob::State* state : path.getStates()) {
        const Carriage::Values at = Carriage::valuesOf(state);
        std::printf("%7.2f %7.2f %8.4f %8.4f\n", at.x, at.y, at.yaw, at.wrist);
    }
    const cp::PathAudit audit = cp::audit(path, *motions);
    std::printf("%zu motions, %s along the whole path, certified clearance %.4f above the margin\n",
                audit.segments.size(), audit.isValid() ? "valid" : "not valid", audit.lowerClearance);
    return audit.isValid() ? 0 : 1;
}
