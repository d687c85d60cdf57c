// A program of a user with OMPL: asks the checker about one state. What OMPL refuses within the library is caught by its types here.
#include <clearway/errors.h>
#include <clearway/planning/motion_validator.h>
#include <clearway/planning/planners.h>
#include <clearway/planning/validity_checker.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <cstdio>

int main() {
    clearway::Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    const clearway::Model model = clearway::Model::build(mesh);
    const clearway::Scene scene{model, model, /*margin*/ 0.5};
    const auto space = std::make_shared<ompl::base::SE3StateSpace>();
    space->as<ompl::base::RealVectorStateSpace>(0)->setBounds(-10, 10);
    const auto information = std::make_shared<ompl::base::SpaceInformation>(space);
    const auto checker = std::make_shared<clearway::planning::ValidityChecker>(information, scene);
    information->setStateValidityChecker(checker);
    information->setMotionValidator(
        std::make_shared<clearway::planning::MotionValidator>(information, scene));
    information->setup();
    ompl::base::ScopedState<ompl::base::SE3StateSpace> state(space);
    state->setXYZ(0, 0, 2), state->rotation().setIdentity();

    const auto refused = [&] {  // it has no problem definition
        const auto planner = clearway::planning::makePlanner(information, "rrt");
        clearway::planning::solveSideBySide({planner}, ompl::base::plannerNonTerminatingCondition(), [] {});
    };
    try {
        refused();
        return 1;
    } catch (const clearway::OmplError& error) {
        if (!dynamic_cast<const ompl::Exception*>(&error)) return 1;
    }
    try {
        refused();
        return 1;
    } catch (const ompl::Exception& error) {
        if (!dynamic_cast<const clearway::Error*>(&error)) return 1;
    }
    std::printf("%.17g %d\n", checker->clearance(state.get()), information->isValid(state.get()));
}
