#include "support/motion_validator_contract.h"

#include <boost/test/unit_test.hpp>
#include <memory>

#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "planning/space/ompl_states.h"
#include "support/window_scene.h"

namespace clearway::planning {

BOOST_AUTO_TEST_SUITE(motion_validator_contract_test)

namespace {

namespace ob = ompl::base;

struct Fixture {
    explicit Fixture(double margin) {
        window.scene.obstacles[0].margin = margin;
        si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, window.scene));
        si->setup();
    }

    ob::ScopedState<> at(const Vector3& position, double angle = 0) const {
        PartState state = window.problem.start;
        state.position = position;
        state.rotation = Eigen::AngleAxisd(angle, Vector3(1, 2, 2).normalized()) * state.rotation;
        return toOmpl(space, Space::kSe3, state);
    }

    /// States on both sides of the wall, where the part stands upright and does not fit through the window.
    testing::ContractMotions motions() const {
        return {at({-60, 0, 0}), at({-50, 20, 5}, 0.3), at({60, 10, 0}, 0.5), at({0, 0, 0}, 0.1)};
    }

    testing::WindowScene window = testing::windowScene();
    ob::StateSpacePtr space = makeSpace(Space::kSe3, *window.problem.volume, 1);
    ob::SpaceInformationPtr si = std::make_shared<ob::SpaceInformation>(space);
};

BOOST_AUTO_TEST_CASE(the_certified_validator_keeps_the_contract) {
    for (const double margin : {0.0, 2.0}) {
        const Fixture f(margin);
        MotionValidator validator(f.si, f.window.scene);
        checkMotionValidatorContract(*f.si, validator, f.motions());
    }
}

BOOST_AUTO_TEST_CASE(the_certified_validator_keeps_the_contract_through_callbacks) {
    const Fixture f(2);
    MotionValidator validator(f.si, SharedScene(f.window.scene, stateToPose(*f.space),
                                                displacementBound(*f.space, f.window.scene.part)));
    checkMotionValidatorContract(*f.si, validator, f.motions());
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::planning
