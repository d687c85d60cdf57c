// The main function of every test program, which holds the test files of a top folder. Each file is a suite with its name, so that
// `--run_test=NAME_test` runs NAME_test.cpp alone. BOOST_TEST_MODULE would be one name for all of them.
#include <boost/test/unit_test.hpp>

int main(int argc, char** argv) {
    return boost::unit_test::unit_test_main([] { return true; }, argc, argv);
}
