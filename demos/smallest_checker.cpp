// demos/smallest_checker.cpp PART ENVIRONMENT: uses clearway in an OMPL program, on two mesh files.
#include <clearway/planning/motion_validator.h>
#include <clearway/planning/validity_checker.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

int main(int, char** files) {
    const auto build = [](const char* file) { return clearway::Model::build(clearway::loadMesh(file)); };
    const clearway::Scene scene{build(files[1]), build(files[2]), /*margin, mesh units*/ 1.0};
    auto space = std::make_shared<ompl::base::SE3StateSpace>();
    space->as<ompl::base::RealVectorStateSpace>(0)->setBounds(-80, 80);
    space->setSubspaceWeight(1, scene.part.radiusAboutOrigin());  // without it rotations hardly count
    ompl::geometric::SimpleSetup setup(space);
    const auto si = setup.getSpaceInformation();
    si->setStateValidityChecker(std::make_shared<clearway::planning::ValidityChecker>(si, scene));
    si->setMotionValidator(std::make_shared<clearway::planning::MotionValidator>(si, scene));  // certified
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(si));
    setup.getPlanner()->params().setParam("range", "20");
    ompl::base::ScopedState<ompl::base::SE3StateSpace> start(space), goal(space);
    start->setXYZ(-60, 0, 0), start->rotation().setIdentity();
    goal->setXYZ(60, 0, 0), goal->rotation().setAxisAngle(1, 0, 0, 1.57);
    setup.setStartAndGoalStates(start, goal);
    setup.solve(/*seconds*/ 10);
    if (setup.haveExactSolutionPath()) setup.getSolutionPath().printAsMatrix(std::cout);
}
