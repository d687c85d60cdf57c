// A space of the user's own, in which the part runs along a curve: with velocities its motions are certified pair by pair,
// without them by clearances of the whole part, and both agree.
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/motion_validator.h"
#include "clearway/planning/validity_checker.h"
#include "support/random_meshes.h"
#include "support/window_scene.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(own_space_test)

namespace ob = ompl::base;

/// The plate runs through the window at y = 0 and z = height sin^2(waves pi x / 120), turning about x by `roll` on the way
/// from -60 to 60.
struct Rail {
    double height, waves, roll;

    Pose pose(double x) const {
        const double wave = std::sin(waves * M_PI * x / 120);
        return {Eigen::AngleAxisd(roll * (x + 60) / 120, Vector3::UnitX()).toRotationMatrix(),
                {x, 0, height * wave * wave}};
    }

    /// trust: the share of the true deviation that the piece admits.
    MotionPiece piece(double from, double to, double radius, double trust) const {
        const double x = from + 0.5 * (to - from), half = 0.5 * std::abs(to - from),
                     frequency = waves * M_PI / 120;
        MotionPiece piece;
        piece.middle = pose(x);
        piece.velocity = Vector3(1, 0, height * frequency * std::sin(2 * frequency * x));
        piece.angularVelocity = Vector3(roll / 120, 0, 0);
        piece.deviation = trust * height * frequency * frequency * half * half;
        piece.deviationAcrossRotation = 0.5 * std::pow(half * roll / 120, 2) * radius;
        return piece;
    }

    double speed(double radius) const {
        return std::hypot(1, height * waves * M_PI / 120) + std::abs(roll) / 120 * radius;
    }
};

struct RailFixture {
    explicit RailFixture(Rail theRail, double margin = 0) : rail(theRail), window(testing::windowScene()) {
        window.scene.obstacles[0].margin = margin;
        line->setBounds(-60, 60);
        radius = window.scene.part.radiusAboutOrigin();
        si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, SharedScene(window.scene, pose)));
    }

    StateMotion motion(double trust = 1) const {
        return [this, trust](const ob::State* a, const ob::State* b) -> PartMotion {
            const double from = xOf(a), way = xOf(b) - from;
            PartMotion motion;
            motion.pieces = [this, trust, from, way](double begin, double end) {
                MotionPiece piece = rail.piece(from + way * begin, from + way * end, radius, trust);
                piece.velocity *= way;
                piece.angularVelocity *= way;
                return piece;
            };
            motion.length = std::abs(way) * rail.speed(radius);
            motion.endJump = 0;
            return motion;
        };
    }

    ob::ScopedState<> at(double x) const {
        ob::ScopedState<> state(line);
        state[0] = x;
        return state;
    }

    bool isValidAlong(double from, double to) const {
        for (int i = 0; i <= 1000; ++i) {
            if (!si->isValid(at(from + (to - from) * i / 1000).get())) return false;
        }
        return true;
    }

    static double xOf(const ob::State* s) { return s->as<ob::RealVectorStateSpace::StateType>()->values[0]; }

    Rail rail;
    testing::WindowScene window;
    double radius = 0;
    std::shared_ptr<ob::RealVectorStateSpace> line = std::make_shared<ob::RealVectorStateSpace>(1);
    ob::SpaceInformationPtr si = std::make_shared<ob::SpaceInformation>(line);
    StateToPose pose = [this](const ob::State* s) { return rail.pose(xOf(s)); };
    DisplacementBound bound = [this](const ob::State* a, const ob::State* b) {
        return std::abs(xOf(a) - xOf(b)) * rail.speed(radius);
    };
};

BOOST_AUTO_TEST_CASE(motions_along_a_curve_have_the_verdicts_of_their_poses_with_and_without_velocities) {
    int valid = 0, invalid = 0;
    for (const double margin : {0.0, 1.0}) {
        for (const Rail rail :
             {Rail{0, 0, 0}, Rail{5, 1, 0}, Rail{13, 1, 0}, Rail{9, 3, 0.2}, Rail{0, 0, 1.2}}) {
            const RailFixture f(rail, margin);
            const MotionValidator pairs(f.si, SharedScene(f.window.scene, f.pose, f.bound, f.motion())),
                globally(f.si, SharedScene(f.window.scene, f.pose, f.bound));
            for (std::uint64_t seed = 1; seed <= 60; ++seed) {
                testing::Random random(seed);
                const double from = random.uniform(-60, 60), to = random.uniform(-60, 60);
                BOOST_TEST_CONTEXT("margin " << margin << ", height " << rail.height << ", roll " << rail.roll
                                             << ", from " << from << " to " << to) {
                    const auto s1 = f.at(from), s2 = f.at(to);
                    const bool isValid = f.isValidAlong(from, to);
                    if (!f.si->isValid(s1.get())) continue;
                    BOOST_TEST(pairs.checkMotion(s1.get(), s2.get()) == isValid);
                    BOOST_TEST(globally.checkMotion(s1.get(), s2.get()) == isValid);
                    std::pair<ob::State*, double> lastValid(nullptr, 1);
                    BOOST_TEST(pairs.checkMotion(s1.get(), s2.get(), lastValid) == isValid);
                    BOOST_TEST(f.isValidAlong(from, from + lastValid.second * (to - from)));
                    ++(isValid ? valid : invalid);
                }
            }
        }
    }
    BOOST_TEST(valid > 100);
    BOOST_TEST(invalid > 50);
}

BOOST_AUTO_TEST_CASE(the_least_clearance_along_a_curve_is_found_with_and_without_velocities) {
    const RailFixture f({5, 3, 0.1});
    const MinClearanceObjective pairs(f.si, SharedScene(f.window.scene, f.pose, f.bound, f.motion())),
        globally(f.si, SharedScene(f.window.scene, f.pose, f.bound));
    for (double x = -60; x < 60; x += 7) {
        const auto s1 = f.at(x), s2 = f.at(std::min(60.0, x + 31));
        const double found = pairs.motionCost(s1.get(), s2.get()).value(),
                     before = globally.motionCost(s1.get(), s2.get()).value();
        BOOST_TEST(found > 0);
        BOOST_TEST(found == before, boost::test_tools::tolerance(0.11));
    }
}

/// A motion that hides its waves between the times that a sweep looks at.
BOOST_AUTO_TEST_CASE(a_deviation_that_is_too_small_is_believed_and_caught_by_looking_at_poses) {
    const RailFixture f({12, 64, 0});
    const auto s1 = f.at(-60), s2 = f.at(60);
    const MotionValidator honest(f.si, SharedScene(f.window.scene, f.pose, f.bound, f.motion(1))),
        liar(f.si, SharedScene(f.window.scene, f.pose, f.bound, f.motion(0)));
    BOOST_TEST(!f.isValidAlong(-60, 60));
    BOOST_TEST(!honest.checkMotion(s1.get(), s2.get()));
    BOOST_TEST(liar.checkMotion(s1.get(), s2.get()));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
