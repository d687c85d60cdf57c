#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <sstream>
#include <string>

#include "clearway/problem.h"
#include "support/oracle.h"
#include "support/path_check.h"
#include "support/temporary_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(smallest_checker_test)

/// Returns the path that the demo prints; an empty one when its ten seconds are over.
std::vector<PartState> runDemo(const std::string& part, const std::string& wall) {
    const TemporaryFolder folder;
    const std::string command = CLEARWAY_DEMOS "/demo_smallest_checker '" + part + "' '" + wall + "' > '" +
                                folder.file("out") + "' 2> '" + folder.file("err") + "'";
    BOOST_TEST(std::system(command.c_str()) == 0);

    // OMPL prints one state a line among its messages.
    std::vector<PartState> path;
    std::istringstream lines(readText(folder.file("out")));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream numbers(line);
        PartState s;
        auto& q = s.rotation;
        if (numbers >> s.position.x() >> s.position.y() >> s.position.z() >> q.x() >> q.y() >> q.z() >>
            q.w()) {
            q.normalize();
            path.push_back(s);
        }
    }
    return path;
}

BOOST_AUTO_TEST_CASE(the_readme_example_runs_and_its_path_keeps_clear) {
    const std::string part = CLEARWAY_DATA_DIR "/window/plate.obj",
                      wall = CLEARWAY_DATA_DIR "/window/wall.obj";
    // The demo's planner has no seed, and on a busy machine ten seconds may not suffice: the first path
    // counts.
    std::vector<PartState> path;
    for (int run = 0; run < 20 && path.empty(); ++run) path = runDemo(part, wall);
    BOOST_TEST_REQUIRE(path.size() >= 2u);
    const double side =
        2 + 1.5 * Model::build(loadMesh(part)).radiusAboutOrigin();  // the wall ends at x = -2 and 2
    BOOST_TEST(path.front().position.x() == -side, boost::test_tools::tolerance(1e-4));  // printed digits
    BOOST_TEST(path.back().position.x() == side, boost::test_tools::tolerance(1e-4));
    const MeshOracle oracle(loadMesh(part), loadMesh(wall));
    BOOST_TEST(leastDistance(oracle, path, Problem(), 1000) > 0.999);  // margin 1, less printed digits
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
