#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <set>

#include "clearway/planning/plan.h"
#include "clearway/planning/problem_setup.h"
#include "clearway/problem.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(data_problems_test)

namespace fs = std::filesystem;

/// The problem files of data, one or more a folder.
std::set<fs::path> problemFiles() {
    std::set<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(CLEARWAY_DATA_DIR)) {
        if (entry.path().extension() == ".cfg") files.insert(entry.path());
    }
    return files;
}

BOOST_AUTO_TEST_CASE(every_problem_of_data_is_read_without_warning_and_its_start_and_goal_are_valid) {
    std::set<std::string> names;
    for (const fs::path& file : problemFiles()) {
        BOOST_TEST_CONTEXT(file) {
            const Problem problem = readProblem(file.string());
            BOOST_TEST(problem.warnings.empty());
            const LoadedScene loaded = loadScene(problem);
            BOOST_CHECK_NO_THROW(
                makeSetup(problem, loaded.scene));  // refuses a start or goal that is not valid
            names.insert(file.stem().string());
        }
    }
    for (const char* name : {"angle", "apartment", "bayonet", "bracket", "dovetail", "gates", "peg-in-hole",
                             "puzzle", "screw", "tunnel-console", "window"}) {
        BOOST_TEST(names.count(name) == 1u, name << " is missing");
    }
}

BOOST_AUTO_TEST_CASE(the_bracket_turns_its_way_through_the_window) {
    const Problem problem = readProblem(CLEARWAY_DATA_DIR "/bracket/bracket.cfg");
    const Scene scene = loadScene(problem).scene;
    BOOST_TEST(scene.part.box().sizes() == Vector3(60, 40, 10));
    PlanOptions options;
    options.iterations = 200000;
    const PlanReport report = plan(problem, scene, options);
    BOOST_REQUIRE((report.outcome == PlanReport::Outcome::kFound));
    BOOST_TEST(report.audit.isValid());
    BOOST_TEST(report.rotation > M_PI / 2);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
