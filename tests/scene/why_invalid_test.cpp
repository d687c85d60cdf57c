// The words for what is wrong with a pose or a motion. No other test holds them.
#include <boost/test/unit_test.hpp>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "clearway/scene_clearance.h"
#include "support/random_meshes.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(why_invalid_test)

using Kind = WhyInvalid::Kind;

Pose at(double x) {
    return {Matrix3::Identity(), Vector3(x, 0, 0)};
}

/// A peg, 2 wide, and a block, 8 wide.
struct PegAndBlock {
    Mesh peg = named(box({1, 1, 1}), "peg"), block = named(box({4, 4, 4}), "block");
    Scene scene{Model::build(peg), Model::build(block)};

    PegAndBlock() { scene.unit = "mm"; }
    WhyInvalid why(const Pose& X_blockPeg) const { return SceneClearance(scene).whyInvalid(X_blockPeg); }
};

/// A value with all that its words tell.
WhyInvalid filled(Kind kind) {
    WhyInvalid why;
    why.kind = kind;
    why.nearest.witness.emplace();
    why.nearest.witness->partTriangle = 7;
    why.nearest.witness->environmentTriangle = 8;
    why.nearest.distance = 0.25;
    why.partMesh = "peg";
    why.environmentMesh = "block";
    why.limit = 0.5;
    why.reason = "no reason";
    why.unit = "mm";
    return why;
}

BOOST_AUTO_TEST_CASE(each_kind_has_its_words) {
    const std::pair<Kind, const char*> kWords[] = {
        {Kind::kValid, ""},
        {Kind::kOutOfBounds, "outside of the bounds of the state space"},
        {Kind::kCollides,
         "in collision: triangle 7 of the part's mesh 'peg' and triangle 8 of the environment's "
         "mesh 'block' are touching, expected a distance above 0.5 mm"},
        {Kind::kTooDeep,
         "in collision: the environment's mesh 'block' may reach deeper into the part's mesh 'peg' than the "
         "overlap "
         "0.5 mm, at triangle 8, nearest to triangle 7 of the part"},
        {Kind::kInSolid, "in collision: the solid 'block' is inside the part's mesh 'peg'"},
        {Kind::kTooClose,
         "too close: triangle 7 of the part's mesh 'peg' and triangle 8 of the environment's mesh "
         "'block' are 0.25 mm apart, expected more than the margin 0.5 mm"},
        {Kind::kNoPose, "unusable: no reason"},
        {Kind::kOutOfRange, "unusable: no reason"},
        {Kind::kUnusable, "unusable: no reason"},
        {Kind::kUndecided, "undecided: closer than can be told"},
    };
    std::set<std::string> names;
    for (const auto& [kind, words] : kWords) {
        BOOST_TEST(filled(kind).words() == words);
        names.insert(nameOf(kind));
    }
    BOOST_TEST(names.size() == std::size(kWords));
    WhyInvalid inside = filled(Kind::kInSolid), out = filled(Kind::kOutOfBounds);
    inside.isPartInside = true;
    BOOST_TEST(inside.words() == "in collision: the part's mesh 'peg' is inside the solid 'block'");
    out.coordinate = {'y', 3, -1, 2.5};
    BOOST_TEST(out.words() == "outside of the bounds of the state space: y is 3, expected from -1 to 2.5");
}

BOOST_AUTO_TEST_CASE(surfaces_that_touch_collide) {
    const PegAndBlock touching;
    const WhyInvalid why = touching.why(at(5));
    BOOST_TEST((why.kind == Kind::kCollides));
    BOOST_TEST(why.isCollision());
    BOOST_TEST(*why.obstacle == 0u);
    BOOST_TEST(why.partMesh == "peg");
    BOOST_TEST(why.environmentMesh == "block");
    BOOST_TEST_REQUIRE(why.nearest.witness.has_value());
    BOOST_TEST(why.nearest.witness->partTriangle >= 0);
    BOOST_TEST(why.nearest.collides());
    BOOST_TEST(why.limit == 0);
    BOOST_TEST(why.unit == "mm");
    BOOST_TEST(touching.why(at(6)).isValid());
    BOOST_TEST(!touching.why(at(6)).obstacle.has_value());
}

BOOST_AUTO_TEST_CASE(no_more_than_the_margin_is_too_close) {
    PegAndBlock near;
    near.scene.obstacles[0].margin = 1.5;
    const WhyInvalid why = near.why(at(6));
    BOOST_TEST((why.kind == Kind::kTooClose));
    BOOST_TEST(!why.isCollision());
    BOOST_TEST(why.limit == 1.5);
    BOOST_TEST(why.nearest.distance == 1, boost::test_tools::tolerance(1e-9));
    BOOST_TEST((near.why(at(5)).kind == Kind::kCollides));
}

BOOST_AUTO_TEST_CASE(the_solid_that_holds_the_part_is_the_obstacle_however_near_others_are) {
    PegAndBlock solid;
    solid.scene.obstacles.insert(solid.scene.obstacles.begin(),
                                 Obstacle(Model::build(transformed(box({0.1, 0.1, 0.1}), at(2)))));
    BOOST_TEST(solid.why(at(0)).isValid());
    solid.scene.partSolids = makeSolids(solid.peg).solids;
    solid.scene.obstacles[1].solids = makeSolids(solid.block).solids;
    const WhyInvalid why = solid.why(at(0));
    BOOST_TEST((why.kind == Kind::kInSolid));
    BOOST_TEST(why.isCollision());
    BOOST_TEST(*why.obstacle == 1u);
    BOOST_TEST(why.isPartInside);
    BOOST_TEST(why.environmentMesh == "block");
}

BOOST_AUTO_TEST_CASE(a_pose_that_queries_refuse_is_a_value_too) {
    PegAndBlock scene;
    Pose scaled;
    scaled.rotation *= 2;
    for (const Pose& pose : {at(std::numeric_limits<double>::quiet_NaN()), scaled}) {
        const WhyInvalid why = scene.why(pose);
        BOOST_TEST((why.kind == Kind::kNoPose));
        BOOST_TEST(why.isUnusable());
        BOOST_TEST(why.reason != "");
    }
    QueryRange range;
    range.positions = Box(Vector3(-8, -8, -8), Vector3(8, 8, 8));
    range.partRadius = scene.scene.part.radiusAboutOrigin();
    range.cap = 2;
    const Mesh far = transformed(scene.block, at(400));  // left out: a model that lacks nothing has no range
    scene.scene.obstacles[0] = Obstacle(Model::build(joined(scene.block, far), {}, range));
    BOOST_TEST(scene.why(at(7)).isValid());
    BOOST_TEST((scene.why(at(9)).kind == Kind::kOutOfRange));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
