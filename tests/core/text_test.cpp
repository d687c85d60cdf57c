#include "core/text.h"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(text_test)

using testing::TemporaryFolder;

BOOST_AUTO_TEST_CASE(lines_come_without_ends_and_byte_order_mark) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.txt",
                                          "\xEF\xBB\xBF"
                                          "one\r\n\ntwo");
    const std::vector<std::string> expected = {"one", "", "two"};
    BOOST_TEST(readLines(file, "a text") == expected, boost::test_tools::per_element());
    BOOST_TEST(readLines(folder.write("empty.txt", ""), "a text").empty());
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_named_with_what_was_expected) {
    const TemporaryFolder folder;
    const auto messageOf = [](const std::string& file) {
        return testing::refusalBy<std::runtime_error>([&] { readLines(file, "a pose file"); });
    };
    const std::string missing = folder.file("x");
    BOOST_TEST(messageOf(missing) ==
               "cannot read '" + missing + "': No such file or directory, expected a pose file");
    BOOST_TEST(messageOf(folder.path()) ==
               "cannot read '" + folder.path() + "': it is a folder, expected a pose file");
}

BOOST_AUTO_TEST_CASE(words_are_the_runs_between_white_space) {
    const std::vector<std::string_view> expected = {"a", "b=c", "d"};
    BOOST_TEST(words(" a\tb=c  d\r") == expected, boost::test_tools::per_element());
    BOOST_TEST(words(" \t").empty());
}

BOOST_AUTO_TEST_CASE(quotes_are_short_and_hold_no_control_characters) {
    BOOST_TEST(quote("a\nb\x1B") == "'a?b?'");
    BOOST_TEST(quote(std::string(100, 'x')) == "'" + std::string(60, 'x') + "...'");
}

BOOST_AUTO_TEST_CASE(joined_texts_have_the_separator_only_between_them) {
    BOOST_TEST(joined({}) == "");
    BOOST_TEST(joined({"a"}) == "a");
    BOOST_TEST(joined({"", "b", ""}, "; ") == "; b; ");
}

BOOST_AUTO_TEST_CASE(a_row_is_found_by_its_name_or_the_names_are_listed) {
    struct Row {
        const char* name;
        int value;
    };
    constexpr Row kTable[] = {{"one", 1}, {"two", 2}};
    BOOST_TEST(rowNamed(kTable, "the number", "two").value == 2);
    testing::requireRefusedBy([&] { rowNamed(kTable, "the number", "three"); },
                              {"the number is 'three', expected one of one, two"});
}

BOOST_AUTO_TEST_CASE(a_misspelt_word_is_told_the_nearest_name_and_no_far_one) {
    const auto meant = [](const char* name) { return " (did you mean '" + std::string(name) + "'?)"; };
    BOOST_TEST(didYouMean("chekc", {"plan", "check"}) == meant("check"));
    BOOST_TEST(didYouMean("kyes", {"formats", "keys"}) == meant("keys"));
    BOOST_TEST(didYouMean("rrtconnct", {"RRT", "RRTConnect"}) == meant("RRTConnect"));
    BOOST_TEST(didYouMean("MM", {"um", "mm"}) == meant("mm"));
    BOOST_TEST(didYouMean("inch", {"mm", "in"}) == meant("in"));
    BOOST_TEST(didYouMean("start.thta", {"start.x", "start.theta"}) == meant("start.theta"));
    BOOST_TEST(didYouMean("strat.x", {"goal.x", "start.x"}) == meant("start.x"));
    BOOST_TEST(didYouMean("start.w", {"start.x", "start.theta"}) == "");
    BOOST_TEST(didYouMean("goal.w", {"goal"}) == "");
    BOOST_TEST(didYouMean("yard", {"mm", "in", "m"}) == "");
    BOOST_TEST(didYouMean("", {"m", "mm"}) == "");
    BOOST_TEST(didYouMean("a", {}) == "");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
