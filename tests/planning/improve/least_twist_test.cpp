// The shortest twist within half-spaces: feasible, and as short as the multipliers of its bounds prove.
#include "planning/improve/least_twist.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(least_twist_test)

using testing::Random;

Twist drawnTwist(Random& random) {
    Twist twist;
    for (int i = 0; i < 6; ++i) twist[i] = random.normal();
    return twist;
}

/// By Hildreth's steps on the multipliers, until they change no more.
std::optional<Twist> slowLeastTwist(const std::vector<TwistBound>& bounds) {
    std::vector<double> multipliers(bounds.size(), 0);
    Twist twist = Twist::Zero();
    for (int round = 0; round < 200000; ++round) {
        double changed = 0;
        for (std::size_t i = 0; i < bounds.size(); ++i) {
            const double square = bounds[i].row.squaredNorm();
            const double next =
                std::max(0.0, multipliers[i] + (bounds[i].least - bounds[i].row.dot(twist)) / square);
            twist += (next - multipliers[i]) * bounds[i].row;
            changed = std::max(changed, std::abs(next - multipliers[i]));
            multipliers[i] = next;
        }
        if (changed < 1e-12) return twist;
    }
    return std::nullopt;
}

BOOST_AUTO_TEST_CASE(the_twist_is_feasible_and_no_feasible_twist_is_shorter) {
    Random random(1);
    int compared = 0;
    for (int k = 0; k < 300; ++k) {
        const Twist inside = drawnTwist(random);
        std::vector<TwistBound> bounds;
        const int count = 1 + random.below(60);
        for (int i = 0; i < count; ++i) {
            const Twist row = drawnTwist(random).normalized();
            const double spare = k % 3 == 0 ? 0 : std::abs(random.normal());
            bounds.push_back({row, row.dot(inside) - spare});
        }
        const std::optional<Twist> found = leastTwist(bounds);
        BOOST_REQUIRE(found.has_value());
        for (const TwistBound& bound : bounds) BOOST_TEST(bound.row.dot(*found) >= bound.least - 1e-9);
        BOOST_TEST(found->norm() <= inside.norm() + 1e-9);
        if (const std::optional<Twist> slow = slowLeastTwist(bounds)) {
            ++compared;
            BOOST_TEST((*found - *slow).norm() < 1e-6 * (1 + slow->norm()));
        }
    }
    BOOST_TEST(compared > 100);
}

BOOST_AUTO_TEST_CASE(bounds_that_contradict_each_other_leave_no_twist) {
    const Twist x = Twist::Unit(0);
    BOOST_TEST(!leastTwist({{x, 1}, {-x, 1}}).has_value());
    BOOST_TEST(leastTwist({{x, 1}, {-x, -1}}).has_value());
}

BOOST_AUTO_TEST_CASE(bounds_that_hold_already_leave_the_part_where_it_is) {
    const Twist x = Twist::Unit(3);
    BOOST_TEST(leastTwist({})->norm() == 0);
    BOOST_TEST(leastTwist({{x, 0}, {-x, -2}})->norm() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
