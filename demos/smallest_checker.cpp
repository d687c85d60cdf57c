// demos/smallest_checker.cpp PART ENVIRONMENT: clearway in an OMPL program. Takes two mesh files, such as
// data/window/plate.obj and data/window/wall.obj, and moves the part along x from one side of the environment to the other.
#include <clearway/planning/motion_validator.h>
#include <clearway/planning/planners.h>
#include <clearway/planning/validity_checker.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

int main(int argc, char** argv) try {
    if (argc != 3) throw std::invalid_argument("expected two mesh files, PART ENVIRONMENT");
    const auto build = [](const char* file) { return clearway::Model::build(clearway::loadMesh(file)); };
    const clearway::Scene scene{build(argv[1]), build(argv[2]), /*margin, mesh units*/ 1.0};
    const clearway::Box box = scene.environmentBox();
    const double radius = scene.part.radiusAboutOrigin();

    auto space = std::make_shared<ompl::base::SE3StateSpace>();
    ompl::base::RealVectorBounds bounds(3);  // of the part's origin: the environment's box, longer along x
    for (int i = 0; i < 3; ++i) bounds.setLow(i, box.min()[i]), bounds.setHigh(i, box.max()[i]);
    bounds.low[0] -= 2 * radius, bounds.high[0] += 2 * radius;
    space->setBounds(bounds);
    space->setSubspaceWeight(1, radius);  // without it rotations hardly count

    ompl::geometric::SimpleSetup setup(space);
    const auto si = setup.getSpaceInformation();
    si->setStateValidityChecker(std::make_shared<clearway::planning::ValidityChecker>(si, scene));
    si->setMotionValidator(std::make_shared<clearway::planning::MotionValidator>(si, scene));  // certified
    // Any planner of OMPL fits here. Where RRTConnect has a bad day, this team often takes a second.
    setup.setPlanner(clearway::planning::makePlanner(si, "PlannerTeam"));

    const clearway::Vector3 middle = box.center();
    ompl::base::ScopedState<ompl::base::SE3StateSpace> start(space), goal(space);
    start->setXYZ(bounds.low[0] + radius / 2, middle.y(), middle.z()), start->rotation().setIdentity();
    goal->setXYZ(bounds.high[0] - radius / 2, middle.y(), middle.z()), goal->rotation().setIdentity();
    setup.setStartAndGoalStates(start, goal);
    setup.solve(/*seconds*/ 10);
    if (!setup.haveExactSolutionPath()) return 1;
    setup.getSolutionPath().printAsMatrix(std::cout);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "smallest_checker: " << error.what() << "\n";
    return 2;
}
