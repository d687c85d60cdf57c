#include "demos/study/table.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "support/full_disk.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(table_test)

using namespace study;

struct Row {
    std::string a, b;
};

const Columns<Row> kColumns = {{"a", &Row::a}, {"b", &Row::b}};

template <class AnyRow>
std::string refusal(const std::string& file, const Columns<AnyRow>& columns) {
    return refusalBy<std::runtime_error>([&] { const GrowingTable<AnyRow> table(file, columns); });
}

BOOST_AUTO_TEST_CASE(what_was_appended_is_there_again) {
    const TemporaryFolder folder;
    const std::string file = folder.file("runs.csv");
    {
        GrowingTable<Row> table(file, kColumns);
        table.append({{"1", "x y"}, {"2", ""}});
        BOOST_TEST(table.rows().at(1).b.empty());
    }
    GrowingTable<Row> again(file, kColumns);
    again.append({{"", "z"}});
    BOOST_TEST(readText(file) == "a,b\n1,x y\n2,\n,z\n");
    BOOST_TEST_REQUIRE(again.rows().size() == 3u);
    BOOST_TEST(again.rows()[0].b == "x y");
    BOOST_TEST(again.rows()[2].a.empty());
}

BOOST_AUTO_TEST_CASE(a_line_that_was_cut_short_is_taken_away) {
    const TemporaryFolder folder;
    for (const std::string text : {"a,b\n1,2\n3,", "a,b\n1,2\n3,4", "a,b\n1,2\n"}) {
        const std::string file = folder.write("runs.csv", text);
        GrowingTable<Row> table(file, kColumns);
        BOOST_TEST(table.rows().size() == 1u, text);
        table.append({{"5", "6"}});
        BOOST_TEST(readText(file) == "a,b\n1,2\n5,6\n");
    }
    const std::string cutHead = folder.write("head.csv", "a,");
    GrowingTable<Row> table(cutHead, kColumns);
    BOOST_TEST(readText(cutHead) == "a,b\n");
}

BOOST_AUTO_TEST_CASE(rows_that_do_not_all_find_room_are_not_there_at_all) {
    const TemporaryFolder folder;
    const std::string file = folder.file("runs.csv");
    GrowingTable<Row> table(file, kColumns);
    table.append({{"1", "2"}});
    const std::vector<Row> rows(10, {"3", "4"});
    {
        const FullDisk full(20);
        BOOST_CHECK_THROW(table.append(rows), std::runtime_error);
    }
    BOOST_TEST(table.rows().size() == 1u);
    BOOST_TEST(readText(file) == "a,b\n1,2\n");
    table.append(rows);
    BOOST_TEST(GrowingTable<Row>(file, kColumns).rows().size() == 11u);
}

BOOST_AUTO_TEST_CASE(rows_that_are_removed_are_gone_from_the_file) {
    const TemporaryFolder folder;
    const std::string file = folder.write("runs.csv", "a,b\n1,x\n2,y\n1,z\n");
    GrowingTable<Row> table(file, kColumns);
    table.remove([](const Row& row) { return row.a == "1"; });
    table.append({{"3", ""}});
    BOOST_TEST(readText(file) == "a,b\n2,y\n3,\n");
    BOOST_TEST(table.rows().size() == 2u);
}

struct Numbers {
    int whole = 0;
    std::uint64_t count = 0;
    double number = 0;
    Count perhaps;
    Measure measure;
    std::vector<double> list;
};

const Columns<Numbers> kNumbers = {{"whole", &Numbers::whole},     {"count", &Numbers::count},
                                   {"number", &Numbers::number},   {"perhaps", &Numbers::perhaps},
                                   {"measure", &Numbers::measure}, {"list", &Numbers::list}};

BOOST_AUTO_TEST_CASE(numbers_read_back_as_they_were_and_other_texts_are_refused) {
    const TemporaryFolder folder;
    const std::string file = folder.file("numbers.csv");
    const double third = 1.0 / 3, infinity = std::numeric_limits<double>::infinity();
    GrowingTable<Numbers>(file, kNumbers)
        .append({{-3, 10000000000, third, 7, -infinity, {third, 1e-300}}, {0, 0, std::nan(""), {}, {}, {}}});
    const GrowingTable<Numbers> again(file, kNumbers);
    BOOST_TEST_REQUIRE(again.rows().size() == 2u);
    const Numbers &full = again.rows()[0], &empty = again.rows()[1];
    BOOST_TEST(full.whole == -3);
    BOOST_TEST(full.count == 10000000000u);
    BOOST_TEST(full.number == third);
    BOOST_TEST(full.perhaps.value() == 7u);
    BOOST_TEST(full.measure.value() == -infinity);
    BOOST_TEST(full.list == std::vector<double>({third, 1e-300}), boost::test_tools::per_element());
    BOOST_TEST(std::isnan(empty.number));
    BOOST_TEST(!empty.perhaps);
    BOOST_TEST(!empty.measure);
    BOOST_TEST(empty.list.empty());
    BOOST_TEST(readText(file) == tableText(kNumbers, again.rows()));

    const std::string head = "whole,count,number,perhaps,measure,list\n";
    for (const char* line :
         {"1.5,1,1,,,", ",1,1,,,", "1,-1,1,,,", "1,1,x,,,", "1,1,1,0.5,,", "1,1,1,,two,", "1,1,1,,,1 x"}) {
        const std::string wrong = folder.write("wrong.csv", head + "1,1,1,,,\n" + line + "\n");
        BOOST_TEST(holds(refusal(wrong, kNumbers), "wrong.csv:3: "), line);
    }
}

BOOST_AUTO_TEST_CASE(a_folder_is_held_by_one_at_a_time) {
    const TemporaryFolder folder;
    {
        const FolderLock lock(folder.path());
        requireRefusedBy<std::runtime_error>([&] { FolderLock second(folder.path()); }, {folder.path()});
    }
    BOOST_CHECK_NO_THROW(FolderLock again(folder.path()));
}

BOOST_AUTO_TEST_CASE(another_table_is_refused_and_left_as_it_is) {
    const TemporaryFolder folder;
    const std::string file = folder.write("runs.csv", "a,c\n1,2\n");
    BOOST_TEST(holds(refusal(file, kColumns), "other columns"));
    BOOST_TEST(readText(file) == "a,c\n1,2\n");
    const std::string longer = folder.write("longer.csv", "a,b\n1,2\n1,2,3\n");
    BOOST_TEST(holds(refusal(longer, kColumns), "longer.csv:3: 3 values", "expected 2"));
    BOOST_TEST(holds(refusal(folder.file("none/x.csv"), kColumns), "cannot be written"));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
