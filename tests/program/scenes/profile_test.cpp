#include "program/scenes/profile.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace clearway;
using namespace clearway::scenes;

namespace {

/// A hat with different corners, both left and right turns.
const Polyline kHat{{120, 2}, {90, 2}, {80, 148}, {-80, 148}, {-90, 2}, {-120, 2}};
const std::vector<double> kRadii{6, 20, 20, 6};

BOOST_AUTO_TEST_CASE(a_profile_runs_from_end_to_end_at_an_even_pace_without_kinks) {
    const Profile profile(kHat, kRadii);
    BOOST_TEST((profile.at(0) - kHat.front()).norm() < 1e-12);
    BOOST_TEST((profile.at(profile.length()) - kHat.back()).norm() < 1e-9);
    constexpr double kStep = 0.01;
    Vector2 before = profile.at(kStep) - profile.at(0);
    for (double w = kStep; w + kStep < profile.length(); w += kStep) {
        const Vector2 step = profile.at(w + kStep) - profile.at(w);
        BOOST_REQUIRE(std::abs(step.norm() - kStep) < 1e-6);
        BOOST_REQUIRE((step - before).norm() < 1.1 * kStep * kStep / 6);  // no sharper than the least radius
        before = step;
    }
}

BOOST_AUTO_TEST_CASE(arcs_are_marked_by_lines_and_touch_their_legs) {
    const Profile profile(kHat, kRadii);
    const std::vector<double> lines = profile.arcLines(3);
    BOOST_TEST(lines.size() == 4 * 4);  // each corner turns by less than 90 degrees
    BOOST_TEST(std::abs(profile.at(lines[4]).y() - 148) > 20 * (1 - std::cos(1.4)));
    BOOST_TEST(std::abs(profile.at(lines[7]).y() - 148) < 1e-9);
    for (int k = 0; k < 4; ++k) {
        BOOST_TEST(profile.corner(k) > lines[4 * k]);
        BOOST_TEST(profile.corner(k) < lines[4 * k + 3]);
    }
}

BOOST_AUTO_TEST_CASE(a_radius_that_does_not_fit_is_lessened) {
    const Profile profile({{0, 0}, {10, 0}, {10, 10}}, {1000});
    BOOST_TEST((profile.at(profile.length()) - Vector2(10, 10)).norm() < 1e-9);
    BOOST_TEST(profile.length() < 20);
    BOOST_TEST(profile.length() > 10 * std::sqrt(2.0));
}

}  // namespace
