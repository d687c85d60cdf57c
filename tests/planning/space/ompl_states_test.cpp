#include "planning/space/ompl_states.h"

#include <boost/test/unit_test.hpp>

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(ompl_states_test)

BOOST_AUTO_TEST_CASE(half_a_turn_either_way_is_within_the_planar_space) {
    const Box bounds(Vector3(-1, -1, 0), Vector3(1, 1, 0));
    const auto space = makeSpace(Space::kSe2, bounds, 1);
    for (const double angle :
         {M_PI, -M_PI, 3 * M_PI, std::nextafter(M_PI, 4), std::nextafter(M_PI, 3), 0.5}) {
        PartState state;
        state.rotation = Eigen::AngleAxisd(angle, Vector3::UnitZ());
        const auto made = toOmpl(space, Space::kSe2, state);
        BOOST_TEST(space->satisfiesBounds(made.get()), "at " << angle);
        const PartState back = fromOmpl(Space::kSe2, made.get());
        BOOST_TEST(back.rotation.angularDistance(state.rotation) < 1e-14);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
