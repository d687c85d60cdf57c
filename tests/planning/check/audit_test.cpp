#include "clearway/planning/audit.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/motion_scene.h"
#include "support/motion_window.h"
#include "support/words.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(audit_test)

using Fixture = testing::MotionWindow;

PathAudit profiled(const og::PathGeometric& path, const MotionValidator& validator) {
    AuditOptions options;
    options.profile = true;
    return audit(path, validator, options);
}

BOOST_AUTO_TEST_CASE(the_least_clearance_is_found_in_its_segment_between_its_meshes) {
    const Fixture f(1);
    // The plate reaches 30 before its origin: 2 from the wall at x = -2, above the window.
    const auto path = pathOf(f, {f.at({-60, 0, 0}), f.at({-34, 0, 40}), f.at({-80, 20, 40})});
    const PathAudit found = audit(path, *f.validator);
    BOOST_TEST(found.isValid());
    BOOST_TEST(found.notValid.empty());
    BOOST_REQUIRE(found.segments.size() == 2u);
    BOOST_TEST(found.lowerClearance <= 1);
    BOOST_TEST(found.lowerClearance >= 0.9);
    BOOST_TEST(found.upperClearance == 1, boost::test_tools::tolerance(1e-9));
    const SegmentAudit& closest = found.segments[found.closest];
    BOOST_TEST(closest.partMesh == "plate");
    BOOST_TEST(closest.environmentMesh == "above");
    BOOST_TEST(closest.motion.closest.witness.has_value());
    BOOST_TEST(closest.X_environmentPart.translation.isApprox(Vector3(-34, 0, 40)));
    BOOST_TEST(found.length == Vector3(26, 0, 40).norm() + Vector3(46, 20, 0).norm(),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(found.rotation == 0);
    BOOST_TEST(found.queries == found.segments[0].motion.queries + found.segments[1].motion.queries);
    BOOST_TEST(found.profile.empty());
}

BOOST_AUTO_TEST_CASE(an_invalid_path_is_audited_to_its_end) {
    const Fixture f;
    const auto path = pathOf(f, {f.at({-60, 0, 0}), f.at({-60, 0, 30}), f.at({60, 0, 30}),
                                 f.at({60, 0, 0}, 1), f.at({170, 0, 0}, 1), f.at({60, 0, 0})});
    const PathAudit found = profiled(path, *f.validator);
    BOOST_TEST((found.verdict == MotionVerdict::kInvalid));
    BOOST_TEST((found.notValid == std::vector<std::size_t>{1, 3, 4}));
    BOOST_REQUIRE(found.segments.size() == 5u);
    BOOST_TEST(found.segments[0].isValid());
    BOOST_TEST(found.segments[2].isValid());
    const MotionReport& through = found.segments[1].motion;
    BOOST_TEST(through.certifiedTime == 28.0 / 120, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(through.upperClearance == 0);
    BOOST_TEST(found.segments[0].motion.whyInvalid.isValid());
    BOOST_TEST((through.whyInvalid.kind == WhyInvalid::Kind::kCollides));
    const WhyInvalid& out = found.segments[3].motion.whyInvalid;
    BOOST_TEST((out.kind == WhyInvalid::Kind::kOutOfBounds));
    BOOST_TEST_REQUIRE(out.coordinate.has_value());
    BOOST_TEST(out.coordinate->name == 'x');
    BOOST_TEST(out.coordinate->value > 100);
    BOOST_TEST(out.coordinate->least == -100);
    BOOST_TEST(out.coordinate->most == 100);
    BOOST_TEST(found.segments[1].environmentMesh == "above");
    BOOST_TEST(found.closest == 1u);
    BOOST_TEST(found.segments[4].motion.certifiedTime == 0);
    BOOST_TEST(found.lowerClearance <= 0);
    BOOST_TEST(found.profile.back().segment == 4u);
    BOOST_TEST(found.profile.back().time == 1);
    BOOST_TEST(found.profile.back().clearance > 20);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_told_is_undecided) {
    const Fixture f(0, testing::withLeastInterval(0.1));
    const auto path = pathOf(f, {f.at({-32 - 1e-12, -20, 30}), f.at({-32 - 1e-12, 20, 30})});
    const PathAudit found = audit(path, *f.validator);
    BOOST_TEST((found.verdict == MotionVerdict::kUndecided));
    BOOST_TEST((found.notValid == std::vector<std::size_t>{0}));
    BOOST_TEST((found.segments[0].motion.whyInvalid.kind == WhyInvalid::Kind::kUndecided));
}

BOOST_AUTO_TEST_CASE(an_audit_that_is_stopped_tells_nothing) {
    const Fixture f;
    const auto path = pathOf(f, {f.at({-60, 0, 0}), f.at({-60, 0, 30}), f.at({-60, 0, 0})});
    int asked = 0, least = 0;
    AuditOptions options;
    options.isStopped = [&] { return ++asked > least; };
    for (; least < 3; ++least) {  // before each of the two motions, and after the last one
        asked = 0;
        BOOST_CHECK_THROW(audit(path, *f.validator, options), AuditStopped);
    }
    asked = 0;
    BOOST_TEST(audit(path, *f.validator, options).isValid());
}

BOOST_AUTO_TEST_CASE(where_a_contact_zone_was_used_is_told) {
    // The assembled plate is half a unit within the wall. The wall counts again 5 further on.
    const Fixture f;
    Scene scene = f.window.scene;
    scene.obstacles[0].isIgnoredAtStart = true;
    const auto path = pathOf(f, {f.at({-31.5, 0, 30}), f.at({-51.5, 0, 30}), f.at({-60, 0, 0})});
    BOOST_TEST(!audit(path, *f.validator).isValid());
    scene.startContact = ContactZone{f.validator->pose(path.getState(0)), 5};
    const PathAudit found = audit(path, MotionValidator(f.si, scene));
    BOOST_TEST(found.isValid());
    BOOST_TEST(found.lowerClearance <= 4.5);
    BOOST_TEST(found.lowerClearance >= 4);
    const auto& used = found.segments[0].motion.startContact;
    BOOST_REQUIRE(used.has_value());
    BOOST_TEST(used->first == 0);
    BOOST_TEST(used->last <= 0.25);
    BOOST_TEST(!found.segments[1].motion.startContact);
    BOOST_TEST(!found.segments[0].motion.goalContact);
}

BOOST_AUTO_TEST_CASE(a_path_of_one_state_is_that_state) {
    const Fixture f;
    const PathAudit valid = profiled(pathOf(f, {f.at({-42, 0, 30})}), *f.validator);
    BOOST_TEST(valid.isValid());
    BOOST_REQUIRE(valid.segments.size() == 1u);
    BOOST_TEST(valid.lowerClearance == 10, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(valid.length == 0);
    BOOST_TEST(valid.profile.size() == 2u);
    BOOST_TEST(!audit(pathOf(f, {f.at({0, 0, 30})}), *f.validator).isValid());
    const PathAudit beyond = audit(pathOf(f, {f.at({-200, 0, 30})}), *f.validator);
    BOOST_TEST((beyond.segments[0].motion.whyInvalid.kind == WhyInvalid::Kind::kOutOfBounds));
    BOOST_CHECK_THROW(audit(og::PathGeometric(f.si), *f.validator), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_path_of_another_space_is_refused_by_name) {
    const Fixture se3, se2(0, {}, Space::kSe2);
    const auto path = pathOf(se2, {se2.at({-60, 0, 0})});
    testing::requireRefusedBy([&] { audit(path, *se3.validator); },
                              {se2.space->getName(), se3.space->getName()});
    BOOST_TEST(audit(path, *se2.validator).isValid());
}

BOOST_AUTO_TEST_CASE(states_without_a_pose_are_told_and_the_rest_is_audited) {
    const Fixture f;
    const auto good = f.at({-60, 0, 0});
    auto twice = good;  // a quaternion of length 2
    for (unsigned int i = 3; i < 7; ++i) twice[i] *= 2;
    for (const auto& bad : {f.at({std::nan(""), 0, 0}), twice}) {
        const PathAudit found = profiled(pathOf(f, {good, bad, good, f.at({-60, 10, 0})}), *f.validator);
        BOOST_TEST((found.notValid == std::vector<std::size_t>{0, 1}));
        BOOST_TEST(found.segments[0].motion.whyInvalid.isUnusable());
        BOOST_TEST(found.segments[0].motion.whyInvalid.reason != "");
        BOOST_TEST(found.segments[2].isValid());
    }
}

// The oracle judges, in SE(3) and SE(2), with and without margins: the scenes' own paths and, in tight
// scenes, paths beside them that collide.
BOOST_AUTO_TEST_CASE(no_pose_of_a_path_has_less_clearance_than_its_audit_says) {
    constexpr unsigned kSeed = 11;
    for (const auto& scene : testing::motionScenes()) {
        testing::Random random(kSeed);
        for (int round = 0; round < 4; ++round) {
            og::PathGeometric path(scene->si);
            for (int k = 0; k < 4; ++k) {
                path.append(scene->state(scene->nearPath(random, round * 3.0, round * 0.1)).get());
            }
            const PathAudit found = profiled(path, *scene->close);
            BOOST_TEST_CONTEXT(scene->name << ", seed " << kSeed << ", round " << round) {
                for (std::size_t k = 0; k < found.segments.size(); ++k) {
                    const auto* s1 = path.getState(static_cast<unsigned int>(k));
                    const auto* s2 = path.getState(static_cast<unsigned int>(k + 1));
                    const double truth = scene->leastTrueClearance(s1, s2, 1, 100, 3);
                    BOOST_TEST(found.segments[k].motion.lowerClearance <= truth + 1e-9);
                    BOOST_TEST(found.lowerClearance <= truth + 1e-9);
                    if (truth <= 0) BOOST_TEST(!found.segments[k].isValid());
                    if (found.segments[k].motion.certifiedTime == 1) BOOST_TEST(truth > 0);
                }
                for (const PathProfilePoint& point : found.profile) {
                    BOOST_TEST(point.clearance >= point.lowerToNext - 1e-9);
                }
            }
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
