#include <algorithm>
#include <sstream>

#include "clearway/scene_clearance.h"
#include "program/cli/window_folder.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(check_test)

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
};

BOOST_AUTO_TEST_CASE(a_valid_path_is_0_with_a_table_and_a_plot_of_80_columns) {
    const CheckFolder folder;
    const Outcome outcome = runIn(folder, "check window.cfg free.path --json facts.json");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");
    const auto audit = jsonIn(folder, "facts.json")["audit"];
    BOOST_TEST(audit["verdict"] == "valid");
    // The window is 32 high, the plate 10 thick, and 64 wide, the plate 40.
    BOOST_TEST(audit["clearance"]["upper"].get<double>() == 11, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(audit["closest"]["segment"] == 2);
    BOOST_TEST(audit["closest"]["pair"]["part"]["mesh"] == "plate");
    BOOST_TEST(audit["length"].get<double>() == 120, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(audit["segments"].size() == 3u);
    for (const auto& segment : audit["segments"]) BOOST_TEST(segment["verdict"] == "valid");

    BOOST_TEST(holds(row(outcome, "audit"), "valid", "certified"));
    BOOST_TEST(holds(row(outcome, "least clearance"), " to 11"), outcome.out);
    BOOST_TEST(holds(outcome.out, "segment  verdict"));
    std::istringstream plot(outcome.out.substr(outcome.out.find("clearance along the path")));
    int lines = 0, bars = 0;
    for (std::string line; std::getline(plot, line); ++lines) {
        BOOST_TEST(line.size() <= 80, line);
        bars += holds(line, "#");
    }
    BOOST_TEST(lines > 10);
    BOOST_TEST(bars > 5);
}

BOOST_AUTO_TEST_CASE(a_path_that_collides_is_1_and_every_segment_that_does_is_told) {
    const CheckFolder folder;
    writePath({folder.window.problem.start, folder.at(-40), folder.at(-40, 20), folder.at(40, 20),
               folder.at(40), folder.at(40, 45), folder.window.problem.goal},
              Space::kSe3, folder.file("bad.path"));
    const Outcome outcome = runIn(folder, "check window.cfg bad.path --json facts.json");
    BOOST_TEST(outcome.code == 1);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(holds(row(outcome, "audit"), "NOT valid: 3 of 6"));
    BOOST_TEST(holds(outcome.out, nameOf(WhyInvalid::Kind::kCollides), nameOf(WhyInvalid::Kind::kOutOfBounds),
                     "xxx"));  // xxx: the plot's foot
    const auto audit = jsonIn(folder, "facts.json")["audit"];
    BOOST_TEST(audit["verdict"] == "invalid");
    const auto& segments = audit["segments"];
    BOOST_TEST_REQUIRE(segments.size() == 6u);
    for (const int valid : {0, 1, 3}) BOOST_TEST(segments[valid]["verdict"] == "valid");
    for (const int invalid : {2, 4, 5}) BOOST_TEST(segments[invalid]["verdict"] == "invalid");
    BOOST_TEST(segments[0]["kind"] == nameOf(WhyInvalid::Kind::kValid));
    BOOST_TEST(segments[0]["trouble"] == "");
    BOOST_TEST(segments[2]["kind"] == nameOf(WhyInvalid::Kind::kCollides));
    BOOST_TEST(holds(segments[2]["trouble"].get<std::string>(), "'above'"));
    BOOST_TEST(segments[2]["valid_until_t"].get<double>() == 0.1, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(segments[5]["valid_until_t"] == 0.0);
}

BOOST_AUTO_TEST_CASE(the_margin_counts_and_clearance_is_what_is_beyond_it) {
    const CheckFolder folder;
    const auto within = factsOf(folder, "check window.cfg free.path --margin 10");
    BOOST_TEST(within["audit"]["clearance"]["upper"].get<double>() == 1, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(within["audit"]["closest"]["segment"] == 2);
    const auto beyond = factsOf(folder, "check window.cfg free.path --margin 11.5", 1);
    BOOST_TEST(beyond["audit"]["segments"][1]["kind"] == nameOf(WhyInvalid::Kind::kTooClose));
    BOOST_TEST(holds(beyond["audit"]["segments"][1]["trouble"].get<std::string>(), "11.5"));
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
    const auto facts = factsOf(folder, "check window.cfg off.path", 1);
    BOOST_TEST(facts["off_start"].get<double>() > 0.5);
    BOOST_TEST(facts["off_goal"].get<double>() > facts["ends_tolerance"].get<double>());
    BOOST_TEST(facts["ends_tolerance"].get<double>() < 0.0073);
    const Outcome outcome = runIn(folder, "check window.cfg off.path");
    for (const char* label : {"begins", "ends"})
        BOOST_TEST(holds(row(outcome, label), "problem's", "expected at most 0.0072"), outcome.out);
    BOOST_TEST(runIn(folder, "check window.cfg off.path --any-ends").code == 0);
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
    BOOST_TEST(factsOf(folder, "check window.cfg one.path --any-ends")["audit"]["segments"].size() == 1u);
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
    folder.write("flat.path", "-60 0 0\n60 0 0\n");
    BOOST_TEST(runIn(folder, "check flat.cfg flat.path").code == 0);
    folder.write("flat.path", "-60 0 0\n-60 0 1.5\n60 0 1.5\n60 0 0\n");
    BOOST_TEST(runIn(folder, "check flat.cfg flat.path").code == 0);
    BOOST_TEST(runIn(folder, "check flat.cfg flat.path --margin 3").code == 1);
}

BOOST_AUTO_TEST_CASE(what_plan_writes_passes_check_until_a_sheet_closes_the_way) {
    const CheckFolder folder;
    BOOST_TEST(runIn(folder, "plan window.cfg --path out.path --quick --iterations 200000").code == 0);
    BOOST_TEST(runIn(folder, "check window.cfg out.path").code == 0);
    const Mesh sheet = box({0.01, 90, 90});
    saveMesh(joined(folder.window.wallMesh, sheet), folder.file("wall.obj"));
    BOOST_TEST(factsOf(folder, "check window.cfg out.path", 1)["audit"]["verdict"] == "invalid");
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused_in_one_line) {
    const CheckFolder folder;
    requireRefused(folder, "check window.cfg", {"IN.path is missing"});
    requireRefused(folder, "check window.cfg nowhere.path", {"nowhere.path"});
    requireRefused(folder, "check nowhere.cfg free.path", {"nowhere.cfg"});
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
    folder.write("nan.path", "-60 0 0 0 0 0 1\n-60 nan 0 0 0 0 1\n");
    requireRefused(folder, "check window.cfg nan.path", {"nan.path", "2", "'nan'", "finite number"});
    folder.write("flat.path", "-60 0 0\n60 0 0\n");
    requireRefused(folder, "check window.cfg flat.path", {"flat.path", "3 numbers", "expected 7"});
    folder.write("zero.path", "-60 0 0 0 0 0 0\n");
    requireRefused(folder, "check window.cfg zero.path", {"zero.path", "quaternion is 0 0 0 0"});
    folder.write("empty.path", "# nothing\n");
    requireRefused(folder, "check window.cfg empty.path", {"empty.path", "no line with numbers"});
}

BOOST_AUTO_TEST_CASE(states_too_far_for_any_query_are_refused_in_one_line) {
    const CheckFolder folder;
    folder.write("far.path", "-60 0 0 0 0 0 1\n1e300 0 0 0 0 0 1\n");
    requireRefused(folder, "check window.cfg far.path",
                   {"state 2 of the path", "1e+300", "expected at most 1e+14"});
    folder.write("far.path", "-60 0 0 0 0 0 1\n1e9 0 0 0 0 0 1\n");
    BOOST_TEST(runIn(folder, "check window.cfg far.path").code == 1);  // outside
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
