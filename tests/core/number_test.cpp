#include "core/number.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace clearway {
BOOST_AUTO_TEST_SUITE(number_test)

BOOST_AUTO_TEST_CASE(only_a_whole_finite_decimal_number_is_one) {
    for (const char* text : {"",    " ",     "abc", "1 ",  " 1",  "1 2", "1,5", "0x10", "inf", "-inf",
                             "nan", "1e999", "--1", "+-1", "-+1", "+",   "-",   ".",    "1e",  "1.0mm"}) {
        BOOST_TEST(!parseNumber(text), "'" << text << "' was read as a number");
    }
    BOOST_TEST(parseNumber("+1.5").value() == 1.5);
    BOOST_TEST(parseNumber("-.5e-2").value() == -0.005);
    BOOST_TEST(parseNumber("5e-324").value() == 5e-324);
}

BOOST_AUTO_TEST_CASE(only_a_whole_integer_that_fits_is_one) {
    for (const char* text : {"", "1.0", "1e3", "x", "9223372036854775808", "1 ", "+-2"}) {
        BOOST_TEST(!parseInteger(text), "'" << text << "' was read as an integer");
    }
    BOOST_TEST(parseInteger("-12").value() == -12);
    BOOST_TEST(parseInteger("+7").value() == 7);
}

BOOST_AUTO_TEST_CASE(numbers_written_read_back_to_the_same_bits) {
    constexpr unsigned kSeed = 7;
    BOOST_TEST_MESSAGE("seed " << kSeed);
    std::mt19937_64 random(kSeed);
    int compared = 0;
    while (compared < 100000) {
        const std::uint64_t bits = random();
        double value;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        ++compared;
        for (const std::string& text : {formatNumber(value), shortNumber(value)}) {
            const double back = parseNumber(text).value();
            BOOST_TEST_REQUIRE(std::memcmp(&back, &value, sizeof value) == 0, text << " changed on reading");
        }
    }
}

BOOST_AUTO_TEST_CASE(written_numbers_have_the_digits_promised) {
    BOOST_TEST(formatNumber(0.1) == "0.10000000000000001");
    BOOST_TEST(shortNumber(0.1) == "0.1");
    BOOST_TEST(roundedNumber(0.1 * 0.2) == "0.02");
    const double infinity = std::numeric_limits<double>::infinity();
    BOOST_TEST(formatNumber(infinity) == "inf");
    BOOST_TEST(formatNumber(-infinity) == "-inf");
    BOOST_TEST(formatNumber(-std::numeric_limits<double>::quiet_NaN()) == "nan");
}

BOOST_AUTO_TEST_CASE(numbers_beyond_a_float_keep_their_size) {
    BOOST_TEST(roundedNumber(1e300) == "1e+300");
    BOOST_TEST(roundedNumber(-1.00000000000001e-200) == "-1e-200");
    BOOST_TEST(roundedNumber(0) == "0");
    BOOST_TEST(roundedNumber(std::numeric_limits<double>::infinity()) == "inf");
}

BOOST_AUTO_TEST_CASE(cut_numbers_are_the_next_ones_of_so_many_digits) {
    struct Cut {
        double value;
        int digits;
        double below, above;
    };
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();
    constexpr double kMost = std::numeric_limits<double>::max();
    for (const Cut& cut :
         {Cut{0.3, 4, 0.3, 0.3}, Cut{0.1 + 0.2, 4, 0.3, 0.3001}, Cut{0.29, 2, 0.29, 0.29},
          Cut{123456, 3, 123000, 124000}, Cut{9.9996, 4, 9.999, 10}, Cut{1 / 3., 1, 0.3, 0.4},
          Cut{kLeast, 4, kLeast, kLeast}, Cut{kMost, 4, 1.797e308, kMost}, Cut{0, 4, 0, 0}}) {
        BOOST_TEST(towardsZero(cut.value, cut.digits) == cut.below);
        BOOST_TEST(awayFromZero(cut.value, cut.digits) == cut.above);
        BOOST_TEST(towardsZero(-cut.value, cut.digits) == -cut.below);
        BOOST_TEST(awayFromZero(-cut.value, cut.digits) == -cut.above);
    }
}

BOOST_AUTO_TEST_CASE(cut_numbers_are_bounds_of_any_value) {
    constexpr unsigned kSeed = 8;
    BOOST_TEST_MESSAGE("seed " << kSeed);
    std::mt19937_64 random(kSeed);
    for (int i = 0; i < 100000; ++i) {
        const std::uint64_t bits = random() >> 1;  // positive
        double value;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        const double below = towardsZero(value, 4), above = awayFromZero(value, 4);
        BOOST_TEST_REQUIRE((below <= value && value <= above), formatNumber(value)
                                                                   << " is beyond its bounds");
        if (value > 1e-300 && value < 1e300)
            BOOST_TEST_REQUIRE((value - below < 1.001e-3 * value && above - value < 1.001e-3 * value));
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
