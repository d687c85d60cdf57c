#include "program/render/colour.h"

#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(colour_test)

using namespace render;

constexpr int kSteps = 64;

/// CIE lightness, 0 to 100.
double lightness(const Colour& linear) {
    const double y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

/// The colour as a viewer without one of the three kinds of cones sees it. Source: Vienot, Brettel, Mollon,
/// Digital Video Colourmaps for Checking the Legibility of Displays by Dichromats, 1999, for red (0) and
/// green (1).
Colour asSeenWithout(int cone, const Colour& linear) {
    Eigen::Matrix3f toCones;
    toCones << 17.8824f, 43.5161f, 4.11935f, 3.45565f, 27.1554f, 3.86714f, 0.0299566f, 0.184309f, 1.46709f;
    Eigen::Vector3f cones = toCones * linear;
    if (cone == 0) cones[0] = 2.02344f * cones[1] - 2.52581f * cones[2];
    if (cone == 1) cones[1] = 0.494207f * cones[0] + 1.24827f * cones[2];
    return toCones.inverse() * cones;
}

BOOST_AUTO_TEST_CASE(the_scale_gets_darker_all_the_way_whoever_looks_at_it) {
    for (int viewer = -1; viewer < 2; ++viewer) {
        double last = 101;
        for (int i = 0; i <= kSteps; ++i) {
            const Colour colour = clearanceColour(double(i) / kSteps);
            const double now = lightness(viewer < 0 ? colour : asSeenWithout(viewer, colour));
            BOOST_TEST(now < last, "viewer " << viewer << ", step " << i);
            last = now;
        }
        const Colour first = clearanceColour(0);
        BOOST_TEST(lightness(viewer < 0 ? first : asSeenWithout(viewer, first)) - last > 45);
    }
}

BOOST_AUTO_TEST_CASE(clearances_beyond_the_scale_have_its_end_colours) {
    BOOST_TEST((clearanceColour(-1) == clearanceColour(0)));
    BOOST_TEST((clearanceColour(7) == clearanceColour(1)));
}

BOOST_AUTO_TEST_CASE(bytes_come_back_as_they_were) {
    for (int value = 0; value < 256; ++value) {
        const auto bytes = toSRgb(sRgb(value, 255 - value, 128));
        BOOST_TEST(int(bytes[0]) == value);
        BOOST_TEST(int(bytes[1]) == 255 - value);
        BOOST_TEST(int(bytes[2]) == 128);
    }
}

BOOST_AUTO_TEST_CASE(a_scale_ends_at_a_round_number_that_holds_the_value) {
    BOOST_TEST(niceCeiling(9.3) == 10, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(niceCeiling(10) == 10, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(niceCeiling(10.5) == 15, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(niceCeiling(0.0042) == 0.005, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(niceCeiling(0) == 1);
    BOOST_TEST(niceCeiling(INFINITY) == 1);
    for (const double value : {5e-324, 3e-320, 1.7e308})
        BOOST_TEST((niceCeiling(value) >= value && std::isfinite(niceCeiling(value))));
    for (double value = 1e-8; value < 1e8; value *= 1.7) {
        BOOST_TEST(niceCeiling(value) >= value * (1 - 1e-12));
        BOOST_TEST(niceCeiling(value) <= 1.51 * value);
    }
}

BOOST_AUTO_TEST_CASE(a_scale_holds_all_clearances_or_tells_the_tight_ones_apart) {
    BOOST_TEST(scaleFor(3, 9, false) == 10);
    BOOST_TEST(scaleFor(3, 900, false) == 15);
    BOOST_TEST(scaleFor(3, INFINITY, false) == 15);
    BOOST_TEST(scaleFor(0, 900, false) == 1000);
    BOOST_TEST(scaleFor(0.001, 80, true) == 20);
    BOOST_TEST(scaleFor(15, 80, true) == 80);
    BOOST_TEST(scaleFor(-2, 0, false) == 1);
    BOOST_TEST(scaleFor(INFINITY, 0, false) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
