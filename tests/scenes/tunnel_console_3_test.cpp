// The tunnel console at full size: what the scene says of itself, and that it is no toy.
#define BOOST_TEST_MODULE tunnel_console_3
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/util/Console.h>

#include <array>
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <deque>
#include <set>

#include "planning/setup.h"
#include "scenes/scene_checks.h"
#include "scenes/tunnel_console.h"

using namespace clearway;
using namespace clearway::testing;

namespace {

SceneOptions atClearance(double clearance) {
    SceneOptions options = kTunnelConsole3;
    options.clearance = clearance;
    return options;
}

/// Of full size, with trees that are built quickly; made once for each clearance.
struct FullSize {
    explicit FullSize(double clearance)
        : scene(makeTunnelConsole3(atClearance(clearance))),
          part(Model::build(scene.part, buildPreset("fast"))),
          environment(Model::build(scene.environment, buildPreset("fast"))) {}

    GeneratedScene scene;
    Model part, environment;
};

const FullSize& fullSize(double clearance) {
    static const FullSize kUsual(10), kNarrow(2);
    return clearance == 10 ? kUsual : kNarrow;
}

bool isWithin(std::size_t count, std::size_t wanted, double share) {
    return count <= wanted && static_cast<double>(count) >= (1 - share) * static_cast<double>(wanted);
}

std::string stem(const std::string& name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    return end + 1 < name.size() && name[end] == '_' ? name.substr(0, end) : name;
}

}  // namespace

BOOST_DATA_TEST_CASE(it_has_the_triangles_and_the_components_of_a_real_one,
                     boost::unit_test::data::make({10.0, 2.0}), clearance) {
    const GeneratedScene& scene = fullSize(clearance).scene;
    BOOST_TEST(isWithin(scene.part.triangles.size(), 73425, 0.005));
    BOOST_TEST(isWithin(scene.environment.triangles.size(), 300401, 0.005));
    std::set<std::string> kinds;
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        testNamedClosedSolids(*mesh);
        testSlivers(*mesh);
        for (const Component& component : mesh->components) kinds.insert(stem(component.name));
    }
    BOOST_TEST(scene.part.components.size() >= 60);
    BOOST_TEST(scene.environment.components.size() >= 150);
    BOOST_TEST(kinds.size() >= 50);
    BOOST_TEST(std::abs(boundingBox(scene.part).diagonal().norm() - 900) < 10);
}

BOOST_DATA_TEST_CASE(smaller_and_larger_ones_reach_their_triangles,
                     boost::unit_test::data::make<std::size_t>({20000, 150000}), triangles) {
    const GeneratedScene scene = makeTunnelConsole3({3, triangles, 4 * triangles, 10});
    BOOST_TEST(isWithin(scene.part.triangles.size(), triangles, 0.02));
    BOOST_TEST(isWithin(scene.environment.triangles.size(), 4 * triangles, 0.02));
    std::vector<Vector3> some;  // their hull is within that of all
    for (std::size_t i = 0; i < scene.part.vertices.size(); i += scene.part.vertices.size() / 400)
        some.push_back(scene.part.vertices[i]);
    BOOST_TEST(signedVolume(convexHull(some)) >= 2 * signedVolume(scene.part));
}

BOOST_DATA_TEST_CASE(the_path_keeps_the_clearance_and_is_tight_for_three_tenths,
                     boost::unit_test::data::make({10.0, 2.0}), clearance) {
    const FullSize& made = fullSize(clearance);
    const PathClearance walk =
        walkPath(made.part, made.environment, made.scene.path, clearance, 1.5 * clearance, 5);
    BOOST_TEST_MESSAGE("least " << walk.least << " mm, " << 100 * walk.tightLength / walk.length
                                << " % tight");
    BOOST_TEST(walk.proven);
    BOOST_TEST(walk.tightLength >= 0.3 * walk.length);
}

BOOST_DATA_TEST_CASE(the_straight_motion_collides_over_half_its_length_with_three_components,
                     boost::unit_test::data::make({10.0, 2.0}), clearance) {
    const FullSize& made = fullSize(clearance);
    Workspace workspace;
    constexpr int kSamples = 200;
    int collisions = 0;
    std::set<int> hit;
    for (int i = 0; i < kSamples; ++i) {
        const PartState state =
            between(made.scene.path.front(), made.scene.path.back(), (i + 0.5) / kSamples);
        const DistanceResult found = distance(made.part, made.environment, poseOf(state), {}, workspace);
        if (!found.collides()) continue;
        ++collisions;
        hit.insert(found.environmentComponent);
    }
    BOOST_TEST(collisions >= kSamples / 2);
    BOOST_TEST(hit.size() >= 3);
}

/// Neighbouring free cells count as connected whatever lies between them, so the flood leaks rather than
/// stops.
BOOST_AUTO_TEST_CASE(a_flood_of_translations_stays_near_the_start) {
    constexpr double kCell = 4;  // mm
    constexpr int kEscape = 38;  // cells: 150 mm of the 900 mm to go
    const FullSize& made = fullSize(10);
    Workspace workspace;
    const auto isFree = [&](const std::array<int, 3>& cell) {
        PartState state = made.scene.path.front();
        state.position += kCell * Vector3(cell[0], cell[1], cell[2]);
        return !collides(made.part, made.environment, poseOf(state), workspace);
    };
    std::set<std::array<int, 3>> seen{{0, 0, 0}};
    std::deque<std::array<int, 3>> open{{0, 0, 0}};
    std::size_t freeCells = 0;
    int reach = 0;
    while (!open.empty() && reach < kEscape) {
        const auto cell = open.front();
        open.pop_front();
        if (!isFree(cell)) continue;
        ++freeCells;
        for (const int steps : cell) reach = std::max(reach, std::abs(steps));
        for (int i = 0; i < 27; ++i) {
            const std::array<int, 3> next{cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1};
            if (seen.insert(next).second) open.push_back(next);
        }
    }
    BOOST_TEST_MESSAGE(freeCells << " free cells, reach " << reach * kCell << " mm");
    BOOST_TEST(freeCells > 27);
    BOOST_TEST(reach < kEscape);
}

/// OMPL takes its seed once a process: every run draws on from there.
BOOST_DATA_TEST_CASE(no_planner_solves_it_within_its_first_100_motions,
                     boost::unit_test::data::make({"RRTConnect", "RRT"}), name) {
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const FullSize& made = fullSize(10);
    const Scene scene(made.part, made.environment);
    std::size_t motions = 0;
    for (int run = 1; run <= 20; ++run) {
        planning::PlanOptions options;
        options.planner = name;
        planning::PlanReport report;
        const planning::Setup setup = planning::prepare(made.scene.problem, scene, options, report);
        const auto judged = [&] {
            const auto counters = setup.certified->counters();
            return counters.valid + counters.invalid;
        };
        setup.planners[0]->solve(ompl::base::PlannerTerminationCondition([&] { return judged() >= 100; }));
        motions += judged();
        BOOST_TEST(!setup.definition->hasExactSolution(), "run " << run);
    }
    BOOST_TEST(motions >= 20 * 100u);
}
