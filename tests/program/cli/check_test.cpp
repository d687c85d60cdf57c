#include <fstream>
#include <sstream>

#include "clearway/problem.h"
#include "program/cli/window_folder.h"
#include "support/random_meshes.h"

namespace clearway::testing {

BOOST_AUTO_TEST_SUITE(check_test)

namespace {

/// With a path through the wall's window that keeps clear of it.
struct CheckFolder : WindowProblemFolder {
    CheckFolder() { writePath(free(), Space::kSe3, file("free.path")); }

    PartState at(double x, double z = 0) const {
        PartState state;
        state.position = {x, 0, z};
        return state;
    }

    /// The path from start to goal. The plate is flat while it passes the window.
    std::vector<PartState> free() const {
        return {window.problem.start, at(-40), at(40), window.problem.goal};
    }

    void writeLines(const std::string& name, const std::string& text) const { write(name, text); }

    using TemporaryFolder::write;
};

/// The lines that begin like the table's rows, with the number of a segment.
std::vector<std::string> segmentRows(const Outcome& outcome) {
    std::istringstream stream(outcome.out);
    std::vector<std::string> rows;
    bool isTable = false;
    for (std::string line; std::getline(stream, line);) {
        if (isTable && line.empty()) break;
        if (isTable) rows.push_back(line);
        isTable = isTable || line.find("segment  verdict") == 0;
    }
    return rows;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_valid_path_is_0_with_a_table_and_a_plot_of_80_columns) {
    const CheckFolder folder;
    const Outcome outcome = runIn(folder, "check window.cfg free.path");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "audit") == "valid along the whole path, certified");
    // The window is 32 high, the plate 10 thick, and 64 wide, the plate 40.
    BOOST_TEST(contains(row(outcome, "least clearance"), " to 11"), outcome.out);
    BOOST_TEST(contains(row(outcome, "  on the path"), "segment 2 of 3, t = "));
    BOOST_TEST(contains(row(outcome, "  on the part"), " of 'plate', at ("));
    BOOST_TEST(contains(row(outcome, "  pose of the part"), "quaternion (x, y, z, w) ("));
    BOOST_TEST(std::stod(row(outcome, "length")) == 120);
    const std::vector<std::string> rows = segmentRows(outcome);
    BOOST_REQUIRE(rows.size() == 3u);
    for (const std::string& line : rows) BOOST_TEST(contains(line, "  valid "), line);

    std::istringstream plot(outcome.out.substr(outcome.out.find("clearance along the path")));
    int lines = 0, bars = 0;
    for (std::string line; std::getline(plot, line); ++lines) {
        BOOST_TEST(line.size() <= 80, line);
        bars += contains(line, "#");
    }
    BOOST_TEST(lines > 10);
    BOOST_TEST(bars > 5);
}

BOOST_AUTO_TEST_CASE(a_path_that_collides_is_1_and_every_segment_that_does_is_told) {
    const CheckFolder folder;
    writePath({folder.window.problem.start, folder.at(-40), folder.at(-40, 20), folder.at(40, 20),
               folder.at(40), folder.at(40, 45), folder.window.problem.goal},
              Space::kSe3, folder.file("bad.path"));
    const Outcome outcome = runIn(folder, "check window.cfg bad.path");
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(contains(row(outcome, "audit"), "NOT valid: 3 of 6 segments"));
    const std::vector<std::string> rows = segmentRows(outcome);
    BOOST_REQUIRE(rows.size() == 6u);
    BOOST_TEST(contains(rows[0], "  valid "));
    BOOST_TEST(contains(rows[2], "  collides "));
    BOOST_TEST(contains(rows[2], "'above'"));
    BOOST_TEST(contains(rows[4], "  outside "));
    BOOST_TEST(contains(row(outcome, "first"), "segment 3, valid up to t = 0.0"));
    BOOST_TEST(contains(row(outcome, "first"), "is in collision: triangle "));
    BOOST_TEST(contains(rows[5], "not valid from its beginning"));
    BOOST_TEST(contains(outcome.out, "xxx"));  // the plot's foot
}

BOOST_AUTO_TEST_CASE(the_margin_counts_and_clearance_is_what_is_beyond_it) {
    const CheckFolder folder;
    const Outcome within = runIn(folder, "check window.cfg free.path --margin 10");
    BOOST_TEST(within.code == 0);
    BOOST_TEST(row(within, "margin") == "10");
    BOOST_TEST(contains(row(within, "least clearance"), " to 1"), within.out);
    BOOST_TEST(contains(row(within, "  on the path"), "segment 2 of 3"), within.out);
    const Outcome beyond = runIn(folder, "check window.cfg free.path --margin 11.5");
    BOOST_TEST(beyond.code == 1);
    BOOST_TEST(contains(segmentRows(beyond).at(1), "  too close "));
    BOOST_TEST(contains(row(beyond, "first"), "expected more than the margin 11.5"));
}

BOOST_AUTO_TEST_CASE(the_profile_is_written_as_csv_in_order_and_bounds_hold) {
    const CheckFolder folder;
    BOOST_TEST(runIn(folder, "check window.cfg free.path --csv profile.csv").code == 0);
    std::istringstream lines(readText(folder.file("profile.csv")));
    std::string line;
    std::getline(lines, line);
    BOOST_TEST(line.find("segment,t,travel,clearance,clearance_to_next,x,y,z,qx,qy,qz,qw,part_mesh,") == 0u);
    const auto cells = std::count(line.begin(), line.end(), ',');
    double before = -1, least = 1e9;
    int count = 0, segment = 0;
    char comma = 0;
    for (; std::getline(lines, line); ++count) {
        BOOST_TEST(std::count(line.begin(), line.end(), ',') == cells);
        std::istringstream values(line);
        double t = 0, travel = 0, clearance = 0, next = 0;
        values >> segment >> comma >> t >> comma >> travel >> comma >> clearance >> comma >> next;
        BOOST_TEST(!values.fail(), line);
        BOOST_TEST(travel >= before);
        BOOST_TEST(clearance >= next);
        before = travel;
        least = std::min(least, next);
    }
    BOOST_TEST(count > 10);
    BOOST_TEST(segment == 3);
    BOOST_TEST(least > 9.9);
    BOOST_TEST(least <= 11);
}

BOOST_AUTO_TEST_CASE(a_path_that_is_not_from_start_to_goal_is_no_solution) {
    const CheckFolder folder;
    auto path = folder.free();
    path.front().position.x() += 1e-5;  // as in a file of 6 digits
    writePath(path, Space::kSe3, folder.file("rounded.path"));
    BOOST_TEST(runIn(folder, "check window.cfg rounded.path").err == "");
    path.front().position.x() += 0.5;
    path.back().rotation = Eigen::AngleAxisd(1.4, Vector3::UnitX());
    writePath(path, Space::kSe3, folder.file("off.path"));
    const Outcome outcome = runIn(folder, "check window.cfg off.path");
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST(row(outcome, "begins").find("0.5") == 0u, outcome.out);
    BOOST_TEST(contains(row(outcome, "begins"), "from the problem's start, expected at most 0.0072"),
               outcome.out);
    BOOST_TEST(contains(row(outcome, "ends"), "from the problem's goal, expected at most "), outcome.out);
    const Outcome any = runIn(folder, "check window.cfg off.path --any-ends");
    BOOST_TEST(any.code == 0);
    BOOST_TEST(contains(row(any, "begins"), "from the problem's start"));
    BOOST_TEST(!contains(row(any, "begins") + row(any, "ends"), "expected"), any.out);
}

BOOST_AUTO_TEST_CASE(a_swept_volume_too_fine_for_the_path_is_refused_with_what_is_fine_enough) {
    const CheckFolder folder;
    const std::string swept = " --swept swept.stl --swept-tolerance ";
    const std::vector<std::string> words = {"--swept-tolerance is 1e-07, too fine for ",
                                            "expected at least "};
    requireRefused(folder, "check window.cfg free.path" + swept + "1e-7", words);
    requireRefused(folder, "plan window.cfg --path out.path" + swept + "1e-7", words);
}

BOOST_AUTO_TEST_CASE(a_path_of_one_state_is_checked) {
    const CheckFolder folder;
    writePath({folder.window.problem.start}, Space::kSe3, folder.file("one.path"));
    const Outcome outcome = runIn(folder, "check window.cfg one.path --any-ends");
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(segmentRows(outcome).size() == 1u);
    BOOST_TEST(contains(outcome.out, "from the problem's goal"));
    writePath({folder.at(0, 20)}, Space::kSe3, folder.file("one.path"));
    BOOST_TEST(runIn(folder, "check window.cfg one.path --any-ends").code == 1);
}

BOOST_AUTO_TEST_CASE(a_planar_path_is_checked_in_se2) {
    const CheckFolder folder;
    Problem problem = folder.window.problem;
    problem.space = Space::kSe2;
    problem.start.rotation = problem.goal.rotation = Eigen::Quaterniond::Identity();
    problem.volume = Box(Vector3(-80, -80, 0), Vector3(80, 80, 0));
    writeProblem(problem, folder.file("flat.cfg"));
    folder.writeLines("flat.path", "-60 0 0\n60 0 0\n");
    BOOST_TEST(runIn(folder, "check flat.cfg flat.path").code == 0);
    folder.writeLines("flat.path", "-60 0 0\n-60 0 1.5\n60 0 1.5\n60 0 0\n");
    BOOST_TEST(runIn(folder, "check flat.cfg flat.path").code == 0);
    BOOST_TEST(runIn(folder, "check flat.cfg flat.path --margin 3").code == 1);
}

BOOST_AUTO_TEST_CASE(what_plan_writes_passes_check_until_a_sheet_closes_the_way) {
    const CheckFolder folder;
    BOOST_TEST(runIn(folder, "plan window.cfg --path out.path --iterations 200000").code == 0);
    const Outcome outcome = runIn(folder, "check window.cfg out.path");
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(outcome.err == "");

    const Mesh sheet = box({0.01, 90, 90});
    saveMesh(joined(folder.window.wallMesh, sheet), folder.file("wall.obj"));
    const Outcome closed = runIn(folder, "check window.cfg out.path");
    BOOST_TEST(closed.code == 1);
    BOOST_TEST(contains(row(closed, "audit"), "NOT valid: "));
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused_in_one_line) {
    const CheckFolder folder;
    requireRefused(folder, "check window.cfg", {"IN.path is missing"});
    requireRefused(folder, "check window.cfg nowhere.path", {"nowhere.path"});
    requireRefused(folder, "check nowhere.cfg free.path", {"nowhere.cfg"});
    requireRefused(folder, "check window.cfg free.path --margin -1", {"--margin is '-1'"});
    requireRefused(folder, "check window.cfg free.path --margin nan", {"--margin is 'nan'"});
    requireRefused(folder, "check window.cfg free.path --csv nowhere/x.csv", {"nowhere/x.csv"});
    requireRefused(folder, "check window.cfg free.path --report nowhere/x.html", {"nowhere/x.html"});
    requireRefused(folder, "check window.cfg free.path --csv x --report x",
                   {"--report is 'x'", "another file"});
    requireRefused(folder, "check window.cfg free.path --csv x.glb --export ./x.glb",
                   {"--export is './x.glb'", "another file"});
    requireRefused(folder, "check window.cfg free.path --export free.path", {"--export is 'free.path'"});
    requireRefused(folder, "check window.cfg free.path --csv free.path",
                   {"--csv is 'free.path'", "input file"});
    folder.writeLines("nan.path", "-60 0 0 0 0 0 1\n-60 nan 0 0 0 0 1\n");
    requireRefused(folder, "check window.cfg nan.path", {"nan.path", "2", "'nan'", "finite number"});
    folder.writeLines("flat.path", "-60 0 0\n60 0 0\n");
    requireRefused(folder, "check window.cfg flat.path", {"flat.path", "3 numbers", "expected 7"});
    folder.writeLines("zero.path", "-60 0 0 0 0 0 0\n");
    requireRefused(folder, "check window.cfg zero.path", {"zero.path", "quaternion is 0 0 0 0"});
    folder.writeLines("empty.path", "# nothing\n");
    requireRefused(folder, "check window.cfg empty.path", {"empty.path", "no line with numbers"});
}

BOOST_AUTO_TEST_CASE(states_too_far_for_any_query_are_refused_in_one_line) {
    const CheckFolder folder;
    folder.writeLines("far.path", "-60 0 0 0 0 0 1\n1e300 0 0 0 0 0 1\n");
    requireRefused(folder, "check window.cfg far.path",
                   {"state 2 of the path", "1e+300", "expected at most 1e+14"});
    folder.writeLines("far.path", "-60 0 0 0 0 0 1\n1e9 0 0 0 0 0 1\n");
    BOOST_TEST(runIn(folder, "check window.cfg far.path").code == 1);  // outside
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::testing
