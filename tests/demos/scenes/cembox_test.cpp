#include "demos/scenes/scenes.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "demos/scenes/cembox.h"
#include "demos/scenes/scene_checks.h"
#include "support/convex_hull.h"
#include "support/full_run.h"
#include "support/oracle.h"

BOOST_AUTO_TEST_SUITE(cembox_test)

using namespace clearway;
using namespace clearway::scenes;
using namespace clearway::testing;

namespace {

std::string refusal(const SceneOptions& options) {
    try {
        makeCembox2(options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

bool mentions(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

bool sameMesh(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles &&
           a.components.size() == b.components.size();
}

constexpr SceneOptions kSmall{1, 3600, 80000, 4};

/// The small scene, made once.
const GeneratedScene& smallScene() {
    static const GeneratedScene scene = makeCembox2(kSmall);
    return scene;
}

/// Sizes of the scene's meshes. With CLEARWAY_FULL=1 larger ones and the full size are included.
std::vector<std::pair<std::size_t, std::size_t>> sizes() {
    if (!isFullRun()) return {{3600, 46000}};
    return {{3600, 46000}, {11000, 130000}, {30000, 500000}};
}

BOOST_AUTO_TEST_CASE(triangle_counts_are_reached_within_five_percent) {
    for (const auto& [part, environment] : sizes()) {
        const GeneratedScene scene = makeCembox2({1, part, environment, 4});
        BOOST_TEST_INFO("asked for " << part << " and " << environment);
        BOOST_TEST(scene.part.triangles.size() <= part);
        BOOST_TEST(scene.part.triangles.size() >= 0.95 * part);
        BOOST_TEST(scene.environment.triangles.size() <= environment);
        BOOST_TEST(scene.environment.triangles.size() >= 0.95 * environment);
    }
}

BOOST_AUTO_TEST_CASE(the_seed_alone_decides) {
    SceneOptions options = kSmall;
    const GeneratedScene &one = smallScene(), again = makeCembox2(options);
    BOOST_TEST(sameMesh(one.part, again.part));
    BOOST_TEST(sameMesh(one.environment, again.environment));
    options.seed = 2;
    const GeneratedScene other = makeCembox2(options);
    BOOST_TEST(!sameMesh(one.part, other.part));
    BOOST_TEST(!sameMesh(one.environment, other.environment));
}

/// With CLEARWAY_FULL=1 also three times as fine.
BOOST_DATA_TEST_CASE(every_component_is_a_named_closed_solid,
                     boost::unit_test::data::make(isFullRun() ? std::vector<int>{1, 3} : std::vector<int>{1}),
                     fineness) {
    const GeneratedScene scene =
        makeCembox2({3, kSmall.partTriangles * fineness, kSmall.environmentTriangles * fineness, 4});
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        testNamedClosedSolids(*mesh);
    }
    BOOST_TEST(scene.part.components.size() > 60);
    BOOST_TEST(scene.environment.components.size() > 300);
}

BOOST_AUTO_TEST_CASE(coordinates_are_floats) {
    const GeneratedScene& scene = smallScene();
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        for (const Vector3& v : mesh->vertices) BOOST_REQUIRE((v == v.cast<float>().cast<double>()));
    }
}

BOOST_AUTO_TEST_CASE(slivers_lie_beside_large_and_beside_tiny_triangles) {
    const GeneratedScene& scene = smallScene();
    for (const Mesh* mesh : {&scene.part, &scene.environment}) {
        double shortest = 1e9, longest = 0, thinnest = 1e9;
        for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
            const auto [a, b, c] = cornersOf(*mesh, i);
            const double edge = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
            shortest = std::min({shortest, (b - a).norm(), (c - b).norm(), (a - c).norm()});
            longest = std::max(longest, edge);
            thinnest = std::min(thinnest, (b - a).cross(c - a).norm() / edge / edge);
        }
        BOOST_TEST(shortest < 1);                                           // mm
        BOOST_TEST(longest > 0.5 * boundingBox(*mesh).sizes().minCoeff());  // a flat face is two triangles
        BOOST_TEST(thinnest < 1.0 / 100);                                   // height over longest edge
        BOOST_TEST(thinnest > 0);
    }
}

/// The bay leaves room for the envelope, so the envelope must hold the module.
BOOST_AUTO_TEST_CASE(the_module_measures_between_300_and_400_mm_and_stays_in_its_envelope) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
        const CemboxDesign design = designCembox({seed, 0, 0, 4});
        for (const double richness : {0.2, 1.0, 3.0}) {
            const int quarter = static_cast<int>(std::ceil(richness));
            const Detail detail{quarter, 8 * quarter, 60 / richness, richness};
            const Mesh part = buildModule(design, detail, scenes::Random(seed), /*studs*/ 3).mesh();
            const double diagonal = boundingBox(part).diagonal().norm();
            BOOST_TEST(diagonal > 300);
            BOOST_TEST(diagonal < 400);
            for (const Vector3& v : part.vertices) {
                bool isHeld = false;
                for (Box box : design.envelope()) {
                    box.min().array() -= 1e-4, box.max().array() += 1e-4;  // allows for rounding to float
                    isHeld = isHeld || box.contains(v);
                }
                BOOST_REQUIRE(isHeld);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(the_problem_starts_in_the_rails_and_ends_above_them) {
    const GeneratedScene& scene = smallScene();
    const Problem& problem = scene.problem;
    BOOST_REQUIRE(problem.volume.has_value());
    for (const PartState& state : scene.path) BOOST_TEST(problem.volume->contains(state.position));
    BOOST_TEST((problem.start.position == scene.path.front().position));
    BOOST_TEST((problem.goal.position == scene.path.back().position));
    BOOST_TEST(problem.fineness.value() == 0.6);  // half of the sheets' 1.2 mm
    BOOST_TEST(problem.name == "cembox v2");
    double railTop = 0;
    for (const Component& component : scene.environment.components) {
        if (component.name.rfind("guide_rail", 0) != 0) continue;
        for (std::uint32_t i = 0; i < component.triangleCount; ++i) {
            for (const Vector3& p : cornersOf(scene.environment, component.firstTriangle + i))
                railTop = std::max(railTop, p.z());
        }
    }
    double lowestAtStart = 1e9, lowestAtGoal = 1e9;
    for (const Vector3& v : scene.part.vertices) {
        lowestAtStart = std::min(lowestAtStart, (poseOf(problem.start) * v).z());
        lowestAtGoal = std::min(lowestAtGoal, (poseOf(problem.goal) * v).z());
    }
    BOOST_TEST(lowestAtStart < railTop - 150);
    BOOST_TEST(lowestAtGoal > railTop + 100);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_made_is_refused_by_name) {
    BOOST_TEST(mentions(refusal({1, 100, 80000, 4}), "part-triangles is 100, expected "));
    BOOST_TEST(mentions(refusal({1, 3600, 100, 4}), "environment-triangles is 100, expected "));
    BOOST_TEST(mentions(refusal({1, 5000000, 80000, 4}), "part-triangles is 5000000, expected "));
    for (const double clearance : {0.0, -3.0, 8.1, std::nan(""), 1e300}) {
        BOOST_TEST(mentions(refusal({1, 3600, 80000, clearance}), "clearance is "));
        BOOST_TEST(mentions(refusal({1, 3600, 80000, clearance}), ", expected 0.5 to 8"));
    }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
