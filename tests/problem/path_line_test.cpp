#include "problem/path_line.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(path_line_test)

PartState turned(double x, double degrees) {
    const double half = degrees * M_PI / 360;
    return {{x, 0, 0}, {std::cos(half), 0, 0, std::sin(half)}};
}

constexpr auto kClose = 1e-12;

BOOST_AUTO_TEST_CASE(the_pace_is_even_over_states_however_far_apart) {
    const PathLine line({turned(0, 0), turned(1, 0), turned(10, 0)}, 5);
    for (const double share : {0.0, 0.05, 0.1, 0.5, 0.93, 1.0})
        BOOST_TEST(line.at(share).position.x() == 10 * share, boost::test_tools::tolerance(kClose));
    BOOST_TEST(line.shares() == (std::vector<double>{0, 0.1, 1}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(turning_takes_its_share_of_the_way) {
    const PathLine line({turned(0, 0), turned(M_PI, 0), turned(M_PI, 90)}, 2);  // ways of pi and pi
    BOOST_TEST(line.shares()[1] == 0.5, boost::test_tools::tolerance(kClose));
    BOOST_TEST(line.at(0.75).position.x() == M_PI, boost::test_tools::tolerance(kClose));
    BOOST_TEST(line.at(0.75).rotation.angularDistance(turned(0, 45).rotation) < 1e-7);
}

BOOST_AUTO_TEST_CASE(the_shorter_way_round_is_taken) {
    PartState end = turned(1, 300);  // 60 degrees the other way
    const PathLine line({turned(0, 0), end}, 1);
    BOOST_TEST(line.at(0.5).rotation.angularDistance(turned(0, -30).rotation) < 1e-7);
}

BOOST_AUTO_TEST_CASE(ends_are_exactly_the_states_and_nothing_lies_beyond) {
    const PathLine line({turned(3, 10), turned(4, 20), turned(5, 30)}, 1);
    for (const double share : {-1.0, 0.0}) BOOST_TEST((line.at(share).position == line.states()[0].position));
    for (const double share : {1.0, 2.0}) {
        BOOST_TEST((line.at(share).position == line.states()[2].position));
        BOOST_TEST((line.at(share).rotation.coeffs() == line.states()[2].rotation.coeffs()));
    }
}

BOOST_AUTO_TEST_CASE(a_path_that_stays_where_it_is_has_a_place_for_every_share) {
    const PathLine alone({turned(3, 10)}, 1);
    BOOST_TEST(alone.at(0.5).position.x() == 3);
    const PathLine resting({turned(3, 10), turned(3, 10)}, 1);
    BOOST_TEST(resting.at(0.5).position.x() == 3);
    BOOST_CHECK_THROW(PathLine({}, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(even_shares_go_from_0_to_1) {
    BOOST_TEST(evenShares(1) == (std::vector<double>{0}), boost::test_tools::per_element());
    BOOST_TEST(evenShares(3) == (std::vector<double>{0, 0.5, 1}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
