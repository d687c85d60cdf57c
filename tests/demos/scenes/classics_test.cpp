// Tests of the small problems in data/: their commands make equal files, and planners solve them.
#include <ompl/util/Console.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "clearway/planning/check_path.h"
#include "clearway/planning/plan.h"
#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/temporary_folder.h"

BOOST_AUTO_TEST_SUITE(classics_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;
namespace data = boost::unit_test::data;

/// The options of a scene, as in data/README.md.
struct Classic {
    const char* folder;
    const char* scene;
    SceneOptions options;
};

std::ostream& operator<<(std::ostream& out, const Classic& classic) {
    return out << classic.folder;
}

const std::vector<Classic> kClassics{{"peg-in-hole", "peg-in-hole-1", {1, 2000, 2000, 1}},
                                     {"apartment", "apartment-1", {1, 3000, 8000, 60}},
                                     {"puzzle", "puzzle-2", {1, 2000, 2000, 4}}};

std::string fileIn(const Classic& classic, const std::string& ending) {
    return std::string(CLEARWAY_DATA_DIR) + "/" + classic.folder + "/" + classic.folder + ending;
}

struct Read {
    explicit Read(const std::string& problemFile, const std::string& pathFile)
        : problem(readProblem(problemFile)),
          part(loadPart(problem)),
          environment(loadEnvironment(problem)),
          path(readPath(pathFile, problem.space)) {}

    Problem problem;
    Mesh part, environment;
    std::vector<PartState> path;
};

void requireSame(const Mesh& a, const Mesh& b) {
    BOOST_TEST_REQUIRE(a.triangles.size() == b.triangles.size());
    double farthest = 0;
    for (std::size_t i = 0; i < a.triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3 &p = a.vertices[a.triangles[i][k]], &q = b.vertices[b.triangles[i][k]];
            farthest = std::max(farthest, (p - q).norm());
        }
    }
    BOOST_TEST(farthest <= 1e-3);  // mm; another machine's sine may round otherwise
}

BOOST_DATA_TEST_CASE(what_is_in_data_is_what_the_command_makes, data::make(kClassics), classic) {
    const TemporaryFolder folder;
    const SceneFiles files = writeScene(sceneNamed(classic.scene).make(classic.options), folder.path());
    const Read made(files.problem, files.path), kept(fileIn(classic, ".cfg"), fileIn(classic, ".path"));
    requireSame(made.part, kept.part);
    requireSame(made.environment, kept.environment);
    BOOST_TEST_REQUIRE(made.path.size() == kept.path.size());
    for (std::size_t i = 0; i < made.path.size(); ++i)
        BOOST_TEST(longestMotion(made.path[i], kept.path[i], 1000) < 1e-2);
    BOOST_TEST(kept.problem.name == made.problem.name);
    BOOST_TEST(kept.problem.warnings.empty());
    BOOST_TEST(readPoses(fileIn(classic, "_replay.poses")).poses.size() == 1000);
}

BOOST_DATA_TEST_CASE(the_kept_path_keeps_the_clearance_between_closed_solids, data::make(kClassics),
                     classic) {
    const Read kept(fileIn(classic, ".cfg"), fileIn(classic, ".path"));
    const Scene scene(Model::build(kept.part), Model::build(kept.environment), classic.options.clearance);
    BOOST_TEST(planning::checkPath(kept.problem, scene, kept.path).audit.isValid());
    testNamedClosedSolids(kept.part);
    testNamedClosedSolids(kept.environment);
}

BOOST_DATA_TEST_CASE(plan_solves_it_with_a_path_that_passes_check, data::make({kClassics[0], kClassics[1]}),
                     classic) {
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const Read kept(fileIn(classic, ".cfg"), fileIn(classic, ".path"));
    const Scene scene(Model::build(kept.part), Model::build(kept.environment));
    planning::PlanOptions options;
    options.seconds = 500;  // usually a few seconds suffice; only a planner that hangs reaches the limit
    const planning::PlanReport report = plan(kept.problem, scene, options);
    BOOST_REQUIRE((report.outcome == planning::PlanReport::Outcome::kFound));
    const planning::PathCheck check = planning::checkPath(kept.problem, scene, report.path);
    BOOST_TEST(check.audit.isValid());
    BOOST_TEST(check.beginsAtStart());
    BOOST_TEST(check.endsAtGoal());
}

BOOST_AUTO_TEST_SUITE_END()
