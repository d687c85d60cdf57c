#include <boost/test/unit_test.hpp>
#include <set>
#include <stdexcept>
#include <string>

#include "demos/scenes/scene_checks.h"
#include "demos/scenes/scenes.h"
#include "support/full_run.h"

BOOST_AUTO_TEST_SUITE(cembox2_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

constexpr SceneOptions kSmall{1, 3000, 6000, 4};

std::set<std::string> namesOf(const Mesh& mesh) {
    std::set<std::string> names;
    for (const Component& component : mesh.components) names.insert(component.name);
    return names;
}

std::string refusal(const SceneOptions& options) {
    try {
        makeCembox2(options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

/// The sizes range from those that leave out most components to those with more components of every kind.
BOOST_AUTO_TEST_CASE(triangle_counts_are_reached_within_five_percent) {
    std::vector<std::pair<std::size_t, std::size_t>> sizes{{2500, 5000}, {3000, 20000}, {9000, 60000}};
    if (isFullRun()) sizes.push_back({60000, 300000});
    for (const auto& [part, environment] : sizes) {
        const GeneratedScene scene = makeCembox2({1, part, environment, 4});
        BOOST_TEST_CONTEXT("asked for " << part << " and " << environment) {
            BOOST_TEST(scene.part.triangles.size() <= part);
            BOOST_TEST(scene.part.triangles.size() >= 0.95 * part);
            BOOST_TEST(scene.environment.triangles.size() <= environment);
            BOOST_TEST(scene.environment.triangles.size() >= 0.95 * environment);
        }
    }
}

BOOST_AUTO_TEST_CASE(every_component_is_a_named_closed_solid_with_slivers_beside_fine_roundings) {
    for (const SceneOptions& options : {kSmall, SceneOptions{2, 9000, 90000, 4}}) {
        const GeneratedScene scene = makeCembox2(options);
        for (const Mesh* mesh : {&scene.part, &scene.environment}) {
            testNamedClosedSolids(*mesh);
            testSlivers(*mesh);
            for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_bay_has_its_large_components) {
    const SceneOptions options{1, 4000, 80000, 4};
    const std::set<std::string> names = namesOf(makeCembox2(options).environment);
    for (const char* name :
         {"bumper_beam", "bumper_foam", "subframe", "subframe_cross", "steering_rack",
          "insulation_heavy_layer", "insulation_foam", "wing_brace_left", "wing_brace_right", "cowl_tray",
          "wiper_motor", "grommet_06", "shaft_boot_04", "steering_bellows_02", "crash_can_02", "engine_block",
          "bulkhead_upper", "wiper_tube", "strut_brace"}) {
        BOOST_TEST(names.count(name) == 1, name);
    }
}

/// Small components are left out first. Those that make the path tight stay.
BOOST_AUTO_TEST_CASE(what_holds_the_module_is_there_at_any_size) {
    const std::set<std::string> names = namesOf(makeCembox2(kSmall).environment);
    for (const char* name : {"guide_rail_left", "guide_rail_right", "buffer_left", "buffer_right",
                             "wiper_tube", "strut_brace"}) {
        BOOST_TEST(names.count(name) == 1, name);
    }
}

/// The clearance is proven along the whole way, also between the samples.
BOOST_AUTO_TEST_CASE(the_constructed_path_keeps_the_clearance_and_is_tight_for_three_tenths) {
    std::vector<SceneOptions> cases{kSmall, {2, 3000, 30000, 2}};
    if (isFullRun()) {
        for (std::uint64_t seed = 3; seed <= 8; ++seed) cases.push_back({seed, 8000, 90000, 1.0 * seed});
        cases.push_back({1, 30000, 500000, 2});
    }
    for (const SceneOptions& options : cases) {
        const PathClearance walk =
            walkPath(makeCembox2(options), options.clearance, 1.5 * options.clearance, 5);
        BOOST_TEST_CONTEXT("seed " << options.seed << ", clearance " << options.clearance << ": least "
                                   << walk.least << " mm, tight for " << walk.tightLength << " of "
                                   << walk.length << " mm, " << walk.samples << " samples") {
            BOOST_TEST(walk.proven);
            BOOST_TEST(walk.tightLength >= 0.3 * walk.length);
        }
    }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_made_is_refused_by_name) {
    BOOST_TEST(refusal({1, 100, 60000, 4}).rfind("part-triangles is 100, expected ", 0) == 0);
    BOOST_TEST(refusal({1, 4000, 100, 4}).rfind("environment-triangles is 100, expected ", 0) == 0);
    BOOST_TEST(refusal({1, 4000, 4000001, 4}).rfind("environment-triangles is 4000001, expected ", 0) == 0);
    BOOST_TEST(refusal({1, 4000, 60000, 9}).rfind("clearance is 9, expected ", 0) == 0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
