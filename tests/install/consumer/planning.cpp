// A program of a user with OMPL: asks the checker about one state.
#include <clearway/planning/motion_validator.h>
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
    std::printf("%.17g %d\n", checker->clearance(state.get()), information->isValid(state.get()));
}
