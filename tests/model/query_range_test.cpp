// A model without its unreachable triangles answers like the whole model, or says why it cannot.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "clearway/batch.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "support/each_target.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(query_range_test)

using testing::Random;
using testing::requireRefusedBy;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A part away from its origin in a wide environment, and poses within the range: anywhere, and at its
/// border.
struct Case {
    explicit Case(std::uint64_t seed, const BuildOptions& options = {})
        : random(seed),
          environmentMesh(testing::randomSoup(random, 1500, 15, 1)),
          part(Model::build(testing::transformed(testing::randomSoup(random, 60, 0.7, 0.5),
                                                 {random.rotation(), {0.5, 0, 0.3}}),
                            options)),
          whole(Model::build(environmentMesh, options)),
          range{Box(Vector3(-3, 1, -6), Vector3(2, 4, -6)), part.radiusAboutOrigin(), random.uniform(0.3, 1)},
          reduced(Model::build(environmentMesh, options, range)) {
        const Vector3 low = range.positions.min(), high = range.positions.max();
        for (int i = 0; i < 150; ++i) {
            Pose pose = random.pose(0);
            for (int axis = 0; axis < 3; ++axis) {
                pose.translation[axis] = i % 3 != 0        ? random.uniform(low[axis], high[axis])
                                         : random.below(2) ? low[axis]
                                                           : high[axis];
            }
            poses.push_back(pose);
        }
    }

    Random random;
    Mesh environmentMesh;
    Model part;
    Model whole;
    QueryRange range;
    Model reduced;
    std::vector<Pose> poses;
};

/// Both intervals hold one distance; the reduced model may clamp it to the cap.
void checkAgreement(const DistanceResult& whole, const DistanceResult& reduced, double cap, bool isExact) {
    constexpr double kRounding = 1e-13;  // coordinates are below 20
    if (reduced.upper == kInfinity) {
        BOOST_TEST(whole.upper > cap - kRounding);
        BOOST_TEST(reduced.lower == cap);
        BOOST_TEST(reduced.distance == kInfinity);
        BOOST_TEST(!reduced.witness);
        return;
    }
    BOOST_TEST(reduced.lower <= whole.upper);
    BOOST_TEST(whole.lower <= reduced.upper);
    if (!isExact) return;
    BOOST_TEST(whole.distance <= cap + kRounding);
    BOOST_TEST(std::abs(whole.distance - reduced.distance) <= kRounding);
    BOOST_TEST(whole.collides() == reduced.collides());
    if (whole.collides()) return;  // any of the pairs that touch may be named
    BOOST_TEST(whole.witness->partTriangle == reduced.witness->partTriangle);
    BOOST_TEST(whole.witness->environmentTriangle == reduced.witness->environmentTriangle);
    BOOST_TEST(whole.witness->environmentComponent == reduced.witness->environmentComponent);
}

BOOST_DATA_TEST_CASE(within_the_range_all_queries_agree_with_the_whole_model, testing::eachWidth(), width) {
    int beyond = 0, near = 0, colliding = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        BuildOptions options;
        options.nodeWidth = width;
        const Case c(seed, options);
        BOOST_TEST(c.reduced.report().unreachableTriangles > 1000u);
        BOOST_TEST(c.reduced.report().unreachableTriangles + c.reduced.report().triangles == 1500u);
        Workspace a, b;
        for (std::size_t i = 0; i < c.poses.size(); ++i) {
            const Pose& X = c.poses[i];
            BOOST_TEST_CONTEXT("seed " << seed << ", pose " << i) {
                const DistanceResult truth = distance(c.part, c.whole, X, {}, a);
                const DistanceResult found = distance(c.part, c.reduced, X, {}, b);
                checkAgreement(truth, found, c.range.cap, true);
                ++(found.upper == kInfinity ? beyond : found.collides() ? colliding : near);
                for (const double cap : {0.0, 0.5 * c.range.cap, c.range.cap, 4 * c.range.cap}) {
                    DistanceOptions capped;
                    capped.cap = cap;
                    const DistanceResult d = distance(c.part, c.reduced, X, capped, b);
                    BOOST_TEST(d.lower <= truth.upper);
                    BOOST_TEST((d.upper == kInfinity ? d.lower >= std::min(cap, c.range.cap)
                                                     : d.upper >= truth.lower));
                }
                DistanceOptions loose;
                loose.relativeError = 0.3;
                loose.absoluteError = 0.1;
                const DistanceResult d = distance(c.part, c.reduced, X, loose, b);
                if (d.upper < kInfinity || truth.distance > c.range.cap) {
                    checkAgreement(truth, d, c.range.cap, false);
                } else {
                    BOOST_ERROR("nothing found, the distance is " << truth.distance);
                }
                BOOST_TEST(collides(c.part, c.whole, X, a) == collides(c.part, c.reduced, X, b));
                for (const double d2 : {0.1 * c.range.cap, 0.7 * c.range.cap, c.range.cap}) {
                    BOOST_TEST(isWithin(c.part, c.whole, X, d2, a) == isWithin(c.part, c.reduced, X, d2, b));
                }
            }
        }
    }
    BOOST_TEST(beyond > 50);
    BOOST_TEST(near > 50);
    BOOST_TEST(colliding > 50);
}

BOOST_AUTO_TEST_CASE(batches_agree_with_the_whole_model) {
    const Case c(21);
    const auto truth = distanceBatch(c.part, c.whole, c.poses),
               found = distanceBatch(c.part, c.reduced, c.poses);
    BOOST_TEST((isWithinBatch(c.part, c.whole, c.poses, c.range.cap) ==
                isWithinBatch(c.part, c.reduced, c.poses, c.range.cap)));
    for (std::size_t i = 0; i < c.poses.size(); ++i) {
        BOOST_TEST_CONTEXT("pose " << i) {
            checkAgreement(truth[i], found[i], c.range.cap, true);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_part_turned_to_its_farthest_finds_what_is_at_the_cap) {
    Mesh part;  // its second corner is 5 from its origin
    part.vertices = {{0, 0, 0}, {3, 4, 0}, {0, 0, 1}};
    part.triangles = {{0, 1, 2}};
    Mesh wall;  // at x = 10; with the positions up to x = 3 that is 2 from the part at its farthest
    wall.vertices = {{10, -9, -9}, {10, 9, -9}, {10, 0, 9}, {90, 0, 0}, {90, 1, 0}, {90, 0, 1}};
    wall.triangles = {{3, 4, 5}, {0, 1, 2}};
    const Model moving = Model::build(part);
    const QueryRange range{Box(Vector3(0, 0, 0), Vector3(3, 0, 0)), 5, 2};
    BOOST_TEST(moving.radiusAboutOrigin() > 5 - 1e-12);
    const Model model =
        Model::build(wall, {}, QueryRange{range.positions, moving.radiusAboutOrigin(), range.cap});
    BOOST_TEST(model.report().unreachableTriangles == 1u);
    Pose X;
    X.rotation << 0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1;
    X.translation = {3, 0, 0};
    Workspace workspace;
    BOOST_TEST(distance(moving, model, X, {}, workspace).lower == 2, boost::test_tools::tolerance(1e-13));
    X.translation = {3 - 1e-9, 0, 0};
    BOOST_TEST(!isWithin(moving, model, X, 2, workspace));
    X.translation = {3, 0, 0};
    BOOST_TEST(isWithin(moving, model, X, 2, workspace) ==
               isWithin(moving, Model::build(wall), X, 2, workspace));
}

BOOST_AUTO_TEST_CASE(a_rotation_off_by_what_is_accepted_lengthens_the_part_and_still_finds_its_wall) {
    Mesh part;
    part.vertices = {{0, 0, 0}, {5, 0, 0}, {0, 0, 1}};
    part.triangles = {{0, 1, 2}};
    const double x = 5 + 2 + 1.5e-12;
    Mesh wall;
    wall.vertices = {{x, -9, -9}, {x, 9, -9}, {x, 0, 9}, {90, 0, 0}, {90, 1, 0}, {90, 0, 1}};
    wall.triangles = {{3, 4, 5}, {0, 1, 2}};
    const Model moving = Model::build(part);
    const Model model = Model::build(
        wall, {}, QueryRange{Box(Vector3(0, 0, 0), Vector3(0, 0, 0)), moving.radiusAboutOrigin(), 2});
    Pose X;
    X.rotation *= 1 + 4e-13;  // the part ends at 5 + 2e-12
    Workspace workspace;
    BOOST_TEST(isWithin(moving, Model::build(wall), X, 2, workspace));
    BOOST_TEST(isWithin(moving, model, X, 2, workspace));
}

BOOST_AUTO_TEST_CASE(a_model_of_which_nothing_is_in_range_answers_farther_than_the_cap) {
    const Case c(4);
    const QueryRange range{Box(Vector3(50, 0, 0), Vector3(55, 5, 5)), c.part.radiusAboutOrigin(), 2};
    const Model model = Model::build(c.environmentMesh, {}, range);
    BOOST_TEST(model.report().triangles == 1u);
    BOOST_TEST(model.report().unreachableTriangles == 1499u);
    Workspace workspace;
    Pose X;
    X.translation = {51, 1, 1};
    const DistanceResult d = distance(c.part, model, X, {}, workspace);
    BOOST_TEST(d.lower == 2);
    BOOST_TEST(d.upper == kInfinity);
    BOOST_TEST(!isWithin(c.part, model, X, 2, workspace));
    BOOST_TEST(!collides(c.part, model, X, workspace));
}

BOOST_AUTO_TEST_CASE(a_model_that_lacks_nothing_has_no_range_and_answers_everything) {
    const Case c(4);
    QueryRange wide = c.range;
    wide.cap = 100;
    const Model model = Model::build(c.environmentMesh, {}, wide);
    BOOST_TEST(!model.range());
    BOOST_TEST(model.report().unreachableTriangles == 0u);
    Workspace a, b;
    Pose X;
    X.translation = {500, 0, 0};
    BOOST_TEST(distance(c.part, model, X, {}, a).distance == distance(c.part, c.whole, X, {}, b).distance);
    BOOST_TEST(isWithin(c.part, model, X, 1000, a));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_answered_is_refused_by_name) {
    const Case c(5);
    const double cap = c.range.cap;
    Workspace workspace;
    Pose X = c.poses[0];
    requireRefusedBy([&] { isWithin(c.part, c.reduced, X, std::nextafter(cap, 9), workspace); }, {"d is "});
    requireRefusedBy([&] { isWithinBatch(c.part, c.reduced, {X}, kInfinity); }, {"d is inf"});
    X.translation.y() = std::nextafter(4, 5);
    const std::vector<std::string> outside{"the pose's translation along y is 4.00", "expected 1 to 4"};
    const std::vector<Pose> poses{c.poses[0], X};
    requireRefusedBy([&] { distance(c.part, c.reduced, X, {}, workspace); }, outside);
    requireRefusedBy([&] { collides(c.part, c.reduced, X, workspace); }, outside);
    requireRefusedBy([&] { isWithin(c.part, c.reduced, X, 0.1, workspace); }, outside);
    requireRefusedBy([&] { distanceBatch(c.part, c.reduced, poses); }, outside);
    requireRefusedBy([&] { isWithinBatch(c.part, c.reduced, poses, 0.1); }, outside);
    X = c.poses[0];
    const Model larger = Model::build(testing::box({5, 5, 5}));
    requireRefusedBy([&] { collides(larger, c.reduced, X, workspace); },
                     {"the part's radius about its origin is 8.66"});
    requireRefusedBy([&] { collides(c.reduced, larger, X, workspace); }, {"the part was built with a range"});
    QueryRange wrong = c.range;
    wrong.cap = -1;
    requireRefusedBy([&] { Model::build(c.environmentMesh, {}, wrong); }, {"cap is -1"});
    const testing::TemporaryFolder folder;
    requireRefusedBy([&] { buildCached(c.environmentMesh, {}, folder.path(), wrong); }, {"cap is -1"});
}

BOOST_AUTO_TEST_CASE(the_box_and_the_ids_are_those_of_the_whole_mesh) {
    Case c(6);
    c.environmentMesh.components = {{"first", 0, 700}, {"second", 700, 800}};
    const Model model = Model::build(c.environmentMesh, {}, c.range);
    BOOST_TEST((model.box().min() == c.whole.box().min()));
    BOOST_TEST((model.box().max() == c.whole.box().max()));
    int second = 0;
    for (const DistanceResult& d : distanceBatch(c.part, model, c.poses)) {
        if (!d.witness) continue;
        BOOST_TEST(d.witness->environmentComponent == (d.witness->environmentTriangle < 700 ? 0 : 1));
        second += d.witness->environmentTriangle >= 700;
    }
    BOOST_TEST(second > 10);
}

BOOST_AUTO_TEST_CASE(a_saved_model_keeps_its_range_and_the_key_tells_it) {
    const Case c(7);
    const testing::TemporaryFolder folder;
    c.reduced.save(folder.file("a"));
    const Model loaded = Model::load(folder.file("a"));
    BOOST_TEST_REQUIRE(loaded.range().has_value());
    BOOST_TEST((loaded.range()->positions.min() == c.range.positions.min()));
    BOOST_TEST((loaded.range()->positions.max() == c.range.positions.max()));
    BOOST_TEST(loaded.range()->partRadius == c.range.partRadius);
    BOOST_TEST(loaded.range()->cap == c.range.cap);
    BOOST_TEST(loaded.report().unreachableTriangles == c.reduced.report().unreachableTriangles);
    BOOST_TEST(loaded.key() == modelKey(c.environmentMesh, {}, c.range));
    BOOST_TEST((loaded.box().max() == c.whole.box().max()));
    Workspace a, b;
    Pose X = c.poses[0];
    BOOST_TEST(distance(c.part, loaded, X, {}, a).lower == distance(c.part, c.reduced, X, {}, b).lower);
    X.translation.x() = 2.5;
    requireRefusedBy([&] { collides(c.part, loaded, X, a); }, {"expected -3 to 2"});

    std::vector<std::uint64_t> keys = {modelKey(c.environmentMesh, {}),
                                       modelKey(c.environmentMesh, {}, c.range)};
    for (int field = 0; field < 8; ++field) {
        QueryRange other = c.range;
        (field < 3   ? other.positions.min()[field]
         : field < 6 ? other.positions.max()[field - 3]
         : field < 7 ? other.partRadius
                     : other.cap) += 1e-9;
        keys.push_back(modelKey(c.environmentMesh, {}, other));
    }
    std::sort(keys.begin(), keys.end());
    BOOST_TEST((std::adjacent_find(keys.begin(), keys.end()) == keys.end()));
}

BOOST_AUTO_TEST_CASE(the_cache_keeps_models_of_different_reaches_apart) {
    const Case c(8);
    const testing::TemporaryFolder folder;
    BOOST_TEST(!buildCached(c.environmentMesh, {}, folder.path(), c.range).isLoaded);
    BOOST_TEST(!buildCached(c.environmentMesh, {}, folder.path()).isLoaded);
    const CachedModel again = buildCached(c.environmentMesh, {}, folder.path(), c.range);
    BOOST_TEST(again.isLoaded);
    BOOST_TEST(again.model.range().has_value());
    BOOST_TEST(!buildCached(c.environmentMesh, {}, folder.path()).model.range());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
