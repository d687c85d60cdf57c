// The keys of [clearway] about obstacles, and worlds of several files: what is written reads back equal, and
// vice versa.
#include <boost/test/unit_test.hpp>
#include <map>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(obstacle_rules_test)

using Names = std::vector<std::string>;

std::string problemText(const std::string& world, const std::string& rules) {
    return "[problem]\nrobot = part.stl\nworld = " + world +
           "\nstart.x = 1\nstart.y = 2\nstart.theta = 0\ngoal.x = 3\ngoal.y = 4\ngoal.theta = "
           "0\n[clearway]\n" +
           rules;
}

Problem read(const TemporaryFolder& folder, const std::string& world, const std::string& rules) {
    folder.write("a.cfg", problemText(world, rules));
    return readProblem(folder.file("a.cfg"));
}

void requireRefused(const std::string& rules, std::vector<std::string> words) {
    const TemporaryFolder folder;
    words.push_back(folder.file("a.cfg") + ":11:");
    requireRefusedBy([&] { read(folder, "w.stl", rules); }, words);
}

BOOST_AUTO_TEST_CASE(rules_are_read_with_names_of_any_kind) {
    const TemporaryFolder folder;
    const Problem problem = read(folder, "w.stl",
                                 "margin = 1\n"
                                 "margin.Left Door = 2.5   # a comment\n"
                                 "margin.\"bolt#2\" = 0\n"
                                 "margin.\"a = b, c\" = 3\n"
                                 "ignore = floor/steel, \"seat, rear\", \"bolt#3\"\n"
                                 "solid = engine\n"
                                 "contact.start = tray, left rail, 5\n"
                                 "contact.goal = \"12\", 0.5\n");
    BOOST_TEST(problem.margin == 1);
    BOOST_TEST((problem.rules.margins ==
                std::map<std::string, double>{{"Left Door", 2.5}, {"bolt#2", 0}, {"a = b, c", 3}}));
    BOOST_TEST(largestMargin(problem) == 3);
    BOOST_TEST(problem.rules.ignored == (Names{"floor/steel", "seat, rear", "bolt#3"}),
               boost::test_tools::per_element());
    BOOST_TEST(!problem.rules.isAllSolid);
    BOOST_TEST(problem.rules.solid == Names{"engine"}, boost::test_tools::per_element());
    BOOST_TEST(problem.rules.startContact->names == (Names{"tray", "left rail"}),
               boost::test_tools::per_element());
    BOOST_TEST(problem.rules.startContact->distance == 5);
    BOOST_TEST(problem.rules.goalContact->names == Names{"12"}, boost::test_tools::per_element());
    BOOST_TEST(read(folder, "w.stl", "solid = all\n").rules.isAllSolid);
    BOOST_TEST(read(folder, "w.stl", "solid = \"all\"\n").rules.solid == Names{"all"},
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wrong_rules_are_refused_with_their_line) {
    requireRefused("margin.door = -1\n", {"margin.door is '-1'", "a number of at least 0"});
    requireRefused("margin.door = nan\n", {"'nan'", "a finite number"});
    requireRefused("margin. = 1\n", {"margin.NAME = M"});
    for (const char* names : {"a,, b", "a\"b\""})
        requireRefused(std::string("ignore = ") + names + "\n", {"names, separated by commas"});
    for (const char* wrong : {"tray", "5", "tray, 0", "tray, -1", "tray, far", "tray, nan"})
        requireRefused(std::string("contact.start = ") + wrong + "\n", {"names and a length above 0"});
    requireRefused("contact.gaol = tray, 1\n", {"unknown key", "'contact.goal'"});
    requireRefused("overlap = -1\n", {"overlap is '-1'", "a number of at least 0"});
    requireRefused("overlap.a = x\n", {"overlap.a is 'x'"});
    requireRefused("overlap.a = -2\n", {"a number of at least 0"});
    requireRefused("overlap.tolerance = 0.1\n", {"no such key", "its tolerance, added up, as the overlap"});
    requireRefused("overlap.thin = allow\n", {"no such key", "thin places are told"});
    requireRefused("overlap.a,b = 1\n", {"overlap.NAME = X with each name once"});
    BOOST_TEST(holds(refusalBy([] { read(TemporaryFolder(), "w.stl", "margin.a = 1\nmargin.\"a\" = 2\n"); }),
                     "each name once"));
}

BOOST_AUTO_TEST_CASE(a_world_may_be_several_files) {
    const TemporaryFolder folder;
    Problem problem = read(folder, "tray.stl, the wall.obj,\"a, b.stl\"", "");
    BOOST_TEST(worldFiles(problem) ==
                   (Names{folder.file("tray.stl"), folder.file("the wall.obj"), folder.file("a, b.stl")}),
               boost::test_tools::per_element());
    folder.write("c, d.stl", "solid x\nendsolid x\n");
    problem = read(folder, "c, d.stl", "");  // there as a whole
    BOOST_TEST(worldFiles(problem) == Names{folder.file("c, d.stl")}, boost::test_tools::per_element());
    BOOST_CHECK_THROW(read(folder, "a.stl,,b.stl", ""), std::invalid_argument);
    requireRefusedBy([&] { read(folder, "a.stl, b.stl, ./a.stl", ""); }, {"each file once"});
    BOOST_CHECK_THROW(read(folder, "a.stl,\"b.stl", ""), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(rules_and_worlds_written_read_back_the_same) {
    const TemporaryFolder folder;
    Problem problem;
    problem.meshes.robot = folder.file("part.stl");
    problem.meshes.world = folder.file("tray.stl");
    problem.meshes.furtherWorlds = {folder.file("a, b.stl"), folder.file("c.obj")};
    problem.rules.margins = {{"door", 0.1}, {" spaced ", 2}, {"a=b#c,d", 1.0 / 3}, {"x.y", 4}};
    problem.rules.ignored = {"one", "[two]", "three, four"};
    problem.rules.solid = {"all"};
    problem.rules.startContact = ContactRule{{"tray", "5"}, 1.0 / 3};
    problem.rules.goalContact = ContactRule{{"shelf #2"}, 7};
    for (const bool isAllSolid : {false, true}) {
        problem.rules.isAllSolid = isAllSolid;
        writeProblem(problem, folder.file("b.cfg"));
        const Problem back = readProblem(folder.file("b.cfg"));
        BOOST_TEST(back.warnings.empty());
        BOOST_TEST(worldFiles(back) == worldFiles(problem), boost::test_tools::per_element());
        BOOST_TEST((back.rules.margins == problem.rules.margins));
        BOOST_TEST(back.rules.ignored == problem.rules.ignored, boost::test_tools::per_element());
        BOOST_TEST(back.rules.isAllSolid == isAllSolid);
        if (!isAllSolid)
            BOOST_TEST(back.rules.solid == problem.rules.solid, boost::test_tools::per_element());
        BOOST_TEST((back.rules.startContact->names == problem.rules.startContact->names));
        BOOST_TEST(back.rules.startContact->distance == problem.rules.startContact->distance);
        BOOST_TEST((back.rules.goalContact->names == problem.rules.goalContact->names));
    }
    problem.meshes.furtherWorlds.clear();
    problem.meshes.world = folder.file("a, b.stl");
    writeProblem(problem, folder.file("b.cfg"));
    BOOST_TEST(worldFiles(readProblem(folder.file("b.cfg"))) == Names{folder.file("a, b.stl")},
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(names_that_no_file_can_hold_are_not_written) {
    const TemporaryFolder folder;
    Problem problem;
    problem.meshes.robot = problem.meshes.world = folder.file("part.stl");
    for (const char* wrong : {"", "a\"b", "a\nb"}) {
        problem.rules.ignored = {wrong};
        BOOST_CHECK_THROW(writeProblem(problem, folder.file("b.cfg")), std::invalid_argument);
    }
    problem.rules.ignored.clear();
    problem.rules.startContact = ContactRule{{}, 1};
    BOOST_CHECK_THROW(writeProblem(problem, folder.file("b.cfg")), std::invalid_argument);
    problem.rules.startContact = ContactRule{{"a"}, 0};
    BOOST_CHECK_THROW(writeProblem(problem, folder.file("b.cfg")), std::invalid_argument);
    problem.rules.startContact.reset();
    problem.rules.overlap.common = -1;
    BOOST_CHECK_THROW(writeProblem(problem, folder.file("b.cfg")), std::invalid_argument);
    BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_CASE(overlaps_are_read_and_written_back) {
    const TemporaryFolder folder;
    const std::string keys = "overlap = 0.5\noverlap.bolt = 0\noverlap.\"thin\" = 2\noverlap.\"a, b\" = 3\n";
    const Problem problem = read(folder, "w.stl", keys);
    const OverlapRules& rules = problem.rules.overlap;
    BOOST_TEST(rules.common == 0.5);
    BOOST_TEST((rules.byName == std::map<std::string, double>{{"bolt", 0}, {"thin", 2}, {"a, b", 3}}));
    writeProblem(problem, folder.file("b.cfg"));
    const OverlapRules back = readProblem(folder.file("b.cfg")).rules.overlap;
    BOOST_TEST(back.common == rules.common);
    BOOST_TEST((back.byName == rules.byName));
    const OverlapRules none = read(folder, "w.stl", "").rules.overlap;
    BOOST_TEST(none.common == 0);
    BOOST_TEST(none.byName.empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
