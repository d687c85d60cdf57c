#include "program/study/growing_table.h"

#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <fstream>
#include <stdexcept>

#include "program/study/call_file.h"
#include "program/study/folder_lock.h"
#include "support/temporary_folder.h"

namespace clearway::testing {

using namespace study;
namespace {

std::string refusal(const std::string& file, const std::vector<std::string>& columns) {
    try {
        const GrowingTable table(file, columns);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing";
}

BOOST_AUTO_TEST_CASE(what_was_appended_is_there_again) {
    const TemporaryFolder folder;
    const std::string file = folder.file("runs.csv");
    {
        GrowingTable table(file, {"a", "b"});
        table.append({{{"a", "1"}, {"b", "x y"}}, {{"a", "2"}}});
        BOOST_TEST(table.rows().at(1).at("b") == "");
    }
    GrowingTable again(file, {"a", "b"});
    again.append({{{"b", "z"}}});
    BOOST_TEST(readText(file) == "a,b\n1,x y\n2,\n,z\n");
    BOOST_TEST_REQUIRE(again.rows().size() == 3u);
    BOOST_TEST(again.rows()[0].at("b") == "x y");
    BOOST_TEST(again.rows()[2].at("a") == "");
}

BOOST_AUTO_TEST_CASE(a_line_that_was_cut_short_is_taken_away) {
    const TemporaryFolder folder;
    for (const std::string text : {"a,b\n1,2\n3,", "a,b\n1,2\n3,4", "a,b\n1,2\n"}) {
        const std::string file = folder.write("runs.csv", text);
        GrowingTable table(file, {"a", "b"});
        BOOST_TEST(table.rows().size() == 1u, text);
        table.append({{{"a", "5"}, {"b", "6"}}});
        BOOST_TEST(readText(file) == "a,b\n1,2\n5,6\n");
    }
    const std::string cutHead = folder.write("head.csv", "a,");
    GrowingTable table(cutHead, {"a", "b"});
    BOOST_TEST(readText(cutHead) == "a,b\n");
}

/// Files may not grow beyond so many bytes while it lives, as on a disk that is full.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit full = {bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &full);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    void (*handler_)(int);
    rlimit before_ = {};
};

BOOST_AUTO_TEST_CASE(rows_that_do_not_all_find_room_are_not_there_at_all) {
    const TemporaryFolder folder;
    const std::string file = folder.file("runs.csv");
    GrowingTable table(file, {"a", "b"});
    table.append({{{"a", "1"}, {"b", "2"}}});
    const std::vector<TableRow> rows(10, {{"a", "3"}, {"b", "4"}});
    {
        const FullDisk full(20);
        BOOST_CHECK_THROW(table.append(rows), std::runtime_error);
    }
    BOOST_TEST(table.rows().size() == 1u);
    BOOST_TEST(readText(file) == "a,b\n1,2\n");
    table.append(rows);
    BOOST_TEST(GrowingTable(file, {"a", "b"}).rows().size() == 11u);
}

BOOST_AUTO_TEST_CASE(rows_that_are_removed_are_gone_from_the_file) {
    const TemporaryFolder folder;
    const std::string file = folder.write("runs.csv", "a,b\n1,x\n2,y\n1,z\n");
    GrowingTable table(file, {"a", "b"});
    table.remove([](const TableRow& row) { return row.at("a") == "1"; });
    table.append({{{"a", "3"}}});
    BOOST_TEST(readText(file) == "a,b\n2,y\n3,\n");
    BOOST_TEST(table.rows().size() == 2u);
}

BOOST_AUTO_TEST_CASE(a_folder_is_held_by_one_at_a_time) {
    const TemporaryFolder folder;
    {
        const FolderLock lock(folder.path());
        BOOST_CHECK_EXCEPTION(FolderLock second(folder.path()), std::runtime_error,
                              [&](const std::runtime_error& error) {
                                  return std::string(error.what()).find(folder.path()) != std::string::npos;
                              });
    }
    BOOST_CHECK_NO_THROW(FolderLock again(folder.path()));
}

BOOST_AUTO_TEST_CASE(another_table_is_refused_and_left_as_it_is) {
    const TemporaryFolder folder;
    const std::string file = folder.write("runs.csv", "a,c\n1,2\n");
    BOOST_TEST(refusal(file, {"a", "b"}).find("other columns") != std::string::npos);
    BOOST_TEST(readText(file) == "a,c\n1,2\n");
    const std::string longer = folder.write("longer.csv", "a,b\n1,2\n1,2,3\n");
    BOOST_TEST(refusal(longer, {"a", "b"}).find("longer.csv:3: 3 values, expected 2") != std::string::npos);
    BOOST_TEST(refusal(folder.file("none/x.csv"), {"a"}).find("cannot be written") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(calls_and_answers_read_back_as_they_were) {
    const TemporaryFolder folder;
    const std::vector<CallBlock> blocks = {
        {Call{CallKind::kState, {0.1, -2e-300}, {}}, Call{CallKind::kMotion, {1.0 / 3, 2}, {3, 4}}},
        {Call{CallKind::kForwardMotion, {1, 2}, {5, 6}}, Call{CallKind::kClearance, {1, 2}, {}},
         Call{CallKind::kMotionCost, {1, 2}, {7, 8}}}};
    writeCalls(blocks, folder.file("a.calls"));
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
    // other calls have other answers
    writeAnswers(answers, answersFile(folder.file("a.calls")));
    writeCalls(blocks, folder.file("a.calls"));
    BOOST_CHECK_THROW(readAnswers(answersFile(folder.file("a.calls"))), std::runtime_error);
    BOOST_CHECK_THROW(readCalls(folder.write("b.calls", "motion 1 2 3\n")), std::invalid_argument);
    BOOST_CHECK_THROW(readCalls(folder.write("b.calls", "motion 1 x\n")), std::invalid_argument);
    BOOST_CHECK_THROW(readCalls(folder.write("b.calls", "jump 1 2\n")), std::invalid_argument);
    BOOST_CHECK_THROW(readAnswers(folder.write("b.answers", "yx\n")), std::invalid_argument);
}

}  // namespace
}  // namespace clearway::testing
