#include "clearway/planning/planners.h"

#include <ompl/base/spaces/SE3StateSpace.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/test/unit_test.hpp>
#include <functional>
#include <set>
#include <stdexcept>

#include "clearway/planning/ompl_messages.h"
#include "clearway/types.h"
#include "planning/space/ompl_states.h"
#include "support/motion_window.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(planners_test)

ob::SpaceInformationPtr spaceInformation() {
    const Box bounds(Vector3(-1, -1, -1), Vector3(1, 1, 1));
    const auto si = std::make_shared<ob::SpaceInformation>(makeSpace(Space::kSe3, bounds, 1));
    si->setStateValidityChecker([](const ob::State*) { return true; });
    si->setup();
    return si;
}

/// The text of the std::invalid_argument that the call throws, or "nothing".
BOOST_AUTO_TEST_CASE(the_promised_planners_are_known_in_any_case) {
    for (const std::string name : {"RRTConnect", "RRT", "KPIECE1", "BKPIECE1", "LBKPIECE1", "EST", "STRIDE",
                                   "PRM", "RRTstar", "PRMstar", "BITstar"}) {
        BOOST_TEST(plannerClassName(name) == name);
        BOOST_TEST(plannerClassName(boost::to_lower_copy(name)) == name);
        BOOST_TEST(plannerClassName(boost::to_upper_copy(name)) == name);
    }
    BOOST_TEST(plannerClassName("kpiece") == "KPIECE1");
    BOOST_TEST(plannerClassName("aps") == "AnytimePathShortening");
}

BOOST_AUTO_TEST_CASE(every_row_makes_a_planner) {
    const OmplMessages quiet;
    const auto si = spaceInformation();
    const auto names = plannerNames();
    BOOST_TEST(names.size() >= 11u);
    BOOST_TEST(std::set<std::string>(names.begin(), names.end()).size() == names.size());
    for (const std::string& name : names) BOOST_TEST(makePlanner(si, name) != nullptr, name);
}

BOOST_AUTO_TEST_CASE(an_unknown_planner_is_refused_with_the_known_ones) {
    const std::string message = testing::refusalBy([] { plannerClassName("RTRConnect"); });
    BOOST_TEST(testing::holds(message, "'RTRConnect'"));
    for (const std::string& name : plannerNames()) BOOST_TEST(testing::holds(message, name));
}

BOOST_AUTO_TEST_CASE(planners_with_threads_or_a_clock_are_declared_unrepeatable) {
    for (const char* name :
         {"PRM", "PRMstar", "SPARS", "SPARStwo", "pRRT", "pSBL", "CForest", "AnytimePathShortening"}) {
        BOOST_TEST(!isRepeatable(name), name);
    }
    for (const char* name : {"RRTConnect", "RRT", "KPIECE1", "EST", "RRTstar", "BITstar"}) {
        BOOST_TEST(isRepeatable(name), name);
    }
}

BOOST_AUTO_TEST_CASE(a_parameter_is_set_and_a_wrong_one_refused) {
    const OmplMessages quiet;
    const auto planner = makePlanner(spaceInformation(), "RRT");
    setParameter(*planner, "range", "12.5");
    setParameter(*planner, "intermediate_states", "1");
    std::string value;
    BOOST_TEST(planner->params().getParam("range", value));
    BOOST_TEST(std::stod(value) == 12.5);

    BOOST_TEST(!hasParameter(*planner, "rnage"));
    const std::string unknown = testing::refusalBy([&] { setParameter(*planner, "rnage", "1"); });
    BOOST_TEST(testing::holds(unknown, "'rnage'"));
    BOOST_TEST(testing::holds(unknown, "goal_bias, intermediate_states, range"));

    for (const char* wrong : {"", "wide", "1x", "nan", "inf", "1e999", "-1"}) {
        const std::string message = testing::refusalBy([&] { setParameter(*planner, "range", wrong); });
        BOOST_TEST(testing::holds(message, "range of planner RRT is '" + std::string(wrong) + "'"));
    }
    BOOST_TEST(
        testing::holds(testing::refusalBy([&] { setParameter(*planner, "intermediate_states", "yes"); }),
                       "expected 0 or 1"));
    BOOST_TEST(planner->params().getParam("range", value));
    BOOST_TEST(std::stod(value) == 12.5);

    const auto prm = makePlanner(spaceInformation(), "PRM");
    BOOST_TEST(testing::holds(testing::refusalBy([&] { setParameter(*prm, "max_nearest_neighbors", "2.5"); }),
                              "whole number"));
    BOOST_TEST(testing::holds(
        testing::refusalBy([&] { setParameter(*prm, "max_nearest_neighbors", "99999999999999999999"); }),
        "99999"));
}

BOOST_AUTO_TEST_CASE(rising_floor_ends_at_once_without_a_valid_start) {
    const testing::MotionWindow f;
    const auto definition = std::make_shared<ob::ProblemDefinition>(f.si);
    definition->setStartAndGoalStates(f.at({0, 35, 0}), f.at({60, 0, 0}));
    const auto planner = makePlanner(f.si, "RisingFloor");
    planner->setProblemDefinition(definition);
    int asked = 0;
    const ob::PlannerTerminationCondition isSpent([&] { return ++asked > 100; });
    const ob::PlannerStatus status = planner->solve(isSpent);
    BOOST_TEST((status == ob::PlannerStatus::INVALID_START));
    BOOST_TEST(asked <= 100);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
