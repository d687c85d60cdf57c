#include <boost/test/unit_test.hpp>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"

BOOST_AUTO_TEST_SUITE(sheets_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

/// The thickness of each wall's four boxes.
std::set<double> thicknesses(const Mesh& environment) {
    std::map<std::string, Box> boxes;
    for (std::size_t i = 0; i < environment.components.size(); ++i) {
        const Component& component = environment.components[i];
        for (std::size_t t = component.firstTriangle; t < component.firstTriangle + component.triangleCount;
             ++t) {
            for (const auto vertex : environment.triangles[t])
                boxes[component.name].extend(environment.vertices[static_cast<std::size_t>(vertex)]);
        }
    }
    BOOST_TEST(boxes.size() == 12u);
    std::set<double> all;
    for (const auto& [name, box] : boxes) all.insert(box.sizes().y());
    return all;
}

BOOST_AUTO_TEST_CASE(the_paths_keep_the_clearance_and_the_walls_differ_in_their_thickness_alone) {
    for (const double clearance : {1.0, 25.0, 28.0}) {
        const SceneOptions options{1, 500, 6000, clearance};
        const GeneratedScene sheets = makeSheets(options), slabs = makeSlabs(options);
        for (const GeneratedScene* scene : {&sheets, &slabs}) {
            const PathClearance walk = walkPath(*scene, 0.5 * clearance, 1.02 * clearance, 5);
            BOOST_TEST(walk.proven);
            BOOST_TEST(walk.least >= clearance);
            BOOST_TEST(walk.least < 1.02 * clearance);
            BOOST_TEST(std::abs(double(scene->environment.triangles.size()) - 6000) < 0.05 * 6000);
        }
        BOOST_TEST(thicknesses(sheets.environment) == std::set<double>({2}),
                   boost::test_tools::per_element());
        BOOST_TEST(thicknesses(slabs.environment) == std::set<double>({40}),
                   boost::test_tools::per_element());
        BOOST_TEST((sheets.problem.start.position == slabs.problem.start.position));
        BOOST_TEST((sheets.problem.goal.position == slabs.problem.goal.position));
        BOOST_TEST((sheets.part.vertices == slabs.part.vertices));
    }
    BOOST_CHECK_THROW(makeSheets({1, 500, 6000, 29}), std::invalid_argument);
    BOOST_CHECK_THROW(makeSlabs({1, 500, 500, 25}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
