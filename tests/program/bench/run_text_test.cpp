#include "program/bench/run_text.h"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "support/window_scene.h"

namespace clearway::study {
BOOST_AUTO_TEST_SUITE(run_text_test)

BOOST_AUTO_TEST_CASE(a_benchmarks_run_is_read_as_it_was_told) {
    EndedRun told;
    told.number = 12;
    told.run.properties = {
        {"time REAL", "0.1"}, {"status ENUM", "6"}, {"name VARCHAR", "a \"b\"; c,\n\xc3\xa9"}};
    told.run.progress = {{{"time REAL", "0.05"}}, {{"time REAL", "0.1"}, {"best cost REAL", "inf"}}};
    told.run.isSolved = true;
    told.run.length = 1.0 / 3;
    const auto window = testing::windowScene();
    told.run.path = {window.problem.start, window.problem.goal};
    told.run.path[0].position.x() = 0.1 + 0.2;  // needs 17 digits
    told.warnings = {"one", "two"};
    const EndedRun read = readEndedRun(textOf(told));
    BOOST_TEST(read.number == 12u);
    BOOST_TEST((read.run.properties == told.run.properties));
    BOOST_TEST((read.run.progress == told.run.progress));
    BOOST_TEST(read.run.isSolved);
    BOOST_TEST(read.run.length == told.run.length);
    BOOST_TEST_REQUIRE(read.run.path.size() == 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        BOOST_TEST((read.run.path[i].position == told.run.path[i].position));
        BOOST_TEST((read.run.path[i].rotation.coeffs() == told.run.path[i].rotation.coeffs()));
    }
    BOOST_TEST(read.warnings == told.warnings, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_text_that_is_no_run_is_refused) {
    const std::string whole = textOf(EndedRun());
    for (const std::string& text :
         {std::string(), whole.substr(0, whole.size() / 2), std::string("{}"), std::string("[1, 2]")}) {
        BOOST_CHECK_THROW(readEndedRun(text), std::exception);
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::study
