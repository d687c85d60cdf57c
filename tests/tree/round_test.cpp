#include "tree/rss.h"

#include <boost/test/unit_test.hpp>

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(round_test)

BOOST_AUTO_TEST_CASE(rounding_up_gives_the_least_float_not_below) {
    for (const double value : {0.1, -0.1, 1 / 3.0, 1 + 0x1p-40, -1 - 0x1p-40, 1e-46, 1e20, -7e-9}) {
        const float up = roundedUp(value);
        BOOST_TEST(static_cast<double>(up) >= value);
        BOOST_TEST(static_cast<double>(std::nextafter(up, -std::numeric_limits<float>::infinity())) < value);
    }
    for (const double exact : {0.0, 1.0, -2.5, 0x1p-149}) BOOST_TEST(roundedUp(exact) == exact);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
