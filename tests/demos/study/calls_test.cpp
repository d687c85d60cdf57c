#include "demos/study/calls.h"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "support/temporary_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(calls_test)

using namespace study;

BOOST_AUTO_TEST_CASE(calls_and_answers_read_back_as_they_were) {
    const TemporaryFolder folder;
    const std::vector<CallBlock> blocks = {
        {Call{CallKind::kState, {0.1, -2e-300}, {}}, Call{CallKind::kMotion, {1.0 / 3, 2}, {3, 4}}},
        {Call{CallKind::kForwardMotion, {1, 2}, {5, 6}}, Call{CallKind::kClearance, {1, 2}, {}}}};
    writeCalls(callsText(blocks), folder.file("a.calls"));
    const auto read = readCalls(folder.file("a.calls"));
    BOOST_TEST_REQUIRE(read.size() == blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        BOOST_TEST_REQUIRE(read[i].size() == blocks[i].size());
        for (std::size_t k = 0; k < blocks[i].size(); ++k) {
            BOOST_TEST((read[i][k].kind == blocks[i][k].kind));
            BOOST_TEST(read[i][k].from == blocks[i][k].from, boost::test_tools::per_element());
            BOOST_TEST(read[i][k].to == blocks[i][k].to, boost::test_tools::per_element());
        }
    }
    const Answers answers = {{CallAnswer::kYes, CallAnswer::kNo}, {CallAnswer::kUndecided}};
    writeAnswers(answers, folder.file("a.answers"));
    BOOST_TEST((readAnswers(folder.file("a.answers")) == answers));
    // Writing other calls removes these answers.
    writeAnswers(answers, answersFile(folder.file("a.calls")));
    writeCalls(callsText(blocks), folder.file("a.calls"));
    BOOST_CHECK_THROW(readAnswers(answersFile(folder.file("a.calls"))), std::runtime_error);
    BOOST_CHECK_THROW(readCalls(folder.write("b.calls", "motion 1 2 3\n")), std::invalid_argument);
    BOOST_CHECK_THROW(readCalls(folder.write("b.calls", "motion 1 x\n")), std::invalid_argument);
    BOOST_CHECK_THROW(readCalls(folder.write("b.calls", "jump 1 2\n")), std::invalid_argument);
    BOOST_CHECK_THROW(readAnswers(folder.write("b.answers", "yx\n")), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
