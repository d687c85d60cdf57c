// The compiler must keep the rounding in (double)(float)x. g++ 12 drops it for neighbouring values unless it
// is told not to vectorise them (see CMakeLists.txt).
#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(float_rounding_test)

// The compiler does not know these values, so that it cannot compute the answers itself.
volatile double unknown[4] = {0.1, 0.3, 3, 7};

__attribute__((noinline)) void roundDifferences(double* x, const double* m) {
    const double first = static_cast<float>(x[0] - m[0]), second = static_cast<float>(x[1] - m[1]);
    x[0] = first;
    x[1] = second;
}

__attribute__((noinline)) void storeAndWiden(const double* x, float* stored, double* widened) {
    stored[0] = static_cast<float>(x[0]);
    stored[1] = static_cast<float>(x[1]);
    widened[0] = stored[0];
    widened[1] = stored[1];
}

bool isFloat(double value) {
    const volatile float rounded = static_cast<float>(value);
    return value == static_cast<double>(rounded);
}

BOOST_AUTO_TEST_CASE(neighbouring_doubles_are_rounded_to_float) {
    double x[2] = {unknown[0], unknown[1]};
    const double m[2] = {unknown[2], unknown[3]};
    roundDifferences(x, m);
    BOOST_TEST(isFloat(x[0]));
    BOOST_TEST(isFloat(x[1]));
}

BOOST_AUTO_TEST_CASE(neighbouring_stored_floats_are_what_is_read_back) {
    const double x[2] = {unknown[0], unknown[1]};
    float stored[2];
    double widened[2];
    storeAndWiden(x, stored, widened);
    BOOST_TEST(isFloat(widened[0]));
    BOOST_TEST(isFloat(widened[1]));
}

BOOST_AUTO_TEST_SUITE_END()
