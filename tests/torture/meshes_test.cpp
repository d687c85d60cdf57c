#include <boost/test/unit_test.hpp>

#include "support/full_run.h"
#include "torture/runs.h"
#include "torture/truth.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(meshes_test)

constexpr std::uint64_t kSeed = 20261121;

BOOST_AUTO_TEST_CASE(meshes_that_rest_on_each_other_are_never_called_free) {
    TortureOptions options;
    options.poses = isFullRun() ? 20'000 : 900;
    options.seed = kSeed;
    options.withFcl = false;
    std::uint64_t verge = 0;
    for (const MeshFigures& figures : runMeshes(options)) {
        BOOST_TEST_CONTEXT("meshes " << figures.family << ", seed " << kSeed) {
            BOOST_TEST(figures.falseValid == 0u);
            BOOST_TEST(figures.violations == 0u);
            BOOST_TEST(figures.touching * 4 > figures.poses);  // otherwise too few poses are in contact
        }
        verge += figures.verge;
    }
    BOOST_TEST(verge * 20 > options.poses);
}

// Two fans of needles. One pair of needles is 3e-19 apart and another touches, although long double computes
// a larger distance for it.
BOOST_AUTO_TEST_CASE(the_mesh_oracle_sees_contact_behind_a_pair_that_nearly_touches) {
    for (const MeshFamily& family : meshFamilies()) {
        if (family.name != "needle-fan") continue;
        Pose pose;
        pose.rotation << 0, 0, 1, 0x1.c75262e06f829p-9, 0x1.ffff358a5a793p-1, 0, -0x1.ffff358a5a793p-1,
            0x1.c75262e06f829p-9, 0;
        pose.translation << 0x1.5df4f43ff46c7p-7, -0x1.d3aad9c4085cep-8, 0x1.9b0661bcb9bbbp+4;
        const MeshOracle oracle(family.part, family.environment);
        BOOST_TEST(exactDistance({family.part, family.environment, pose}).isZero());
        BOOST_TEST(oracle.collides(pose));
        BOOST_TEST(oracle.distance(pose).distance == 0.0);
        return;
    }
    BOOST_FAIL("there is no family of needle fans");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
