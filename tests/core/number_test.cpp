#include "core/number.h"

#include <boost/test/unit_test.hpp>
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

BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway
