// Refusals by OMPL are caught as clearway's own type, and still as OMPL's.
#include "planning/space/ompl_refusal.h"

#include <ompl/base/spaces/SE3StateSpace.h>

#include <boost/test/unit_test.hpp>

#include "clearway/planning/plan.h"
#include "clearway/planning/planners.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(ompl_refusal_test)

BOOST_AUTO_TEST_CASE(what_ompl_refuses_is_an_ompl_error_with_its_message) {
    const auto space = std::make_shared<ompl::base::SE3StateSpace>();
    const auto si = std::make_shared<ompl::base::SpaceInformation>(space);
    const ompl::base::PlannerPtr planner = makePlanner(si, "rrt");
    std::string refusal;  // the planner has no problem definition
    try {
        planner->solve(0);
    } catch (const ompl::Exception& error) {
        refusal = error.what();
    }
    BOOST_TEST_REQUIRE(!refusal.empty());
    const auto solve = [&] {
        solveSideBySide({planner}, ompl::base::plannerNonTerminatingCondition(), [] {});
    };
    const auto has = [&](const auto& error) { return error.what() == refusal; };
    BOOST_CHECK_EXCEPTION(solve(), OmplError, has);
    BOOST_CHECK_EXCEPTION(solve(), Error, has);
    BOOST_CHECK_EXCEPTION(solve(), ompl::Exception, has);
    BOOST_CHECK_EXCEPTION(solve(), std::runtime_error, has);
    BOOST_CHECK_EXCEPTION(solve(), std::exception, has);
}

BOOST_AUTO_TEST_CASE(what_plan_refuses_itself_is_an_argument_error) {
    static_assert(std::is_base_of_v<ArgumentError, RefusedOption> &&
                  std::is_base_of_v<ArgumentError, InvalidStart>);
    BOOST_CHECK_THROW(makePlanner(nullptr, "rrtt"), ArgumentError);
    BOOST_CHECK_THROW(solveSideBySide({}, ompl::base::plannerNonTerminatingCondition(), [] {}),
                      ArgumentError);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
