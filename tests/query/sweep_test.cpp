// Sweeps never certify a time at which the part is within the margin, and find contact only where it is: judged by exact
// queries at many poses of random and of hard motions, on every instruction set and node width. With CLEARWAY_FULL=1 there
// are 20,000 random motions of 1,000 poses.
#include "clearway/sweep.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/each_target.h"
#include "support/full_run.h"
#include "support/random_meshes.h"
#include "support/swept_pairs.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(sweep_test)

struct Tally {
    int certified = 0, contact = 0, undecided = 0;
};

/// Sweeps a motion whole and forward, and checks both answers at evenly spread poses.
Tally judge(const SweptPair& pair, const RigidMotion& motion, SweepOptions options, int samples) {
    Workspace workspace;
    const MotionPieces pieces = piecesOf(motion, pair.part);
    const auto isWithinAt = [&](double time) {
        return isWithin(pair.part, pair.environment, poseAt(motion, time), options.margin, workspace);
    };
    options.isForward = false;
    const SweepResult whole = sweep(pair.part, pair.environment, pieces, options, workspace);
    options.isForward = true;
    const SweepResult forward = sweep(pair.part, pair.environment, pieces, options, workspace);
    const double certified = std::max(whole.certifiedUntil, forward.certifiedUntil);
    for (int i = 0; i <= samples && certified > 0; ++i) {
        const double time = certified * i / samples;
        BOOST_TEST(!isWithinAt(time), "within at " << time << " of " << certified);
    }
    for (const SweepResult& found : {whole, forward}) {
        if (found.verdict != SweepVerdict::kContact) continue;
        BOOST_TEST(isWithinAt(found.contactTime.value()));
        BOOST_TEST(found.certifiedUntil <= *found.contactTime);
        BOOST_TEST(found.contact.has_value());
    }
    if (forward.verdict == SweepVerdict::kContact) {
        BOOST_TEST(forward.contactTime.value() - forward.certifiedUntil <= 2 * options.contactTime);
    }
    return {whole.verdict == SweepVerdict::kCertified, whole.verdict == SweepVerdict::kContact,
            whole.verdict == SweepVerdict::kUndecided};
}

BOOST_DATA_TEST_CASE(no_certified_time_is_within_the_margin, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    Tally tally;
    const std::uint64_t motions = isFullRun() ? 400 : 40;
    for (const SweptPair& pair : sweptPairs(width)) {
        for (std::uint64_t seed = 0; seed < motions; ++seed) {
            BOOST_TEST_CONTEXT(pair.name << ", seed " << seed) {
                Random random(seed);
                const RigidMotion motion = randomMotion(random, pair);
                const double margin = random.below(2) * pair.size * std::pow(10, random.uniform(-4, -1));
                const Tally one = judge(pair, motion, optionsFor(pair, margin), isFullRun() ? 1000 : 60);
                tally.certified += one.certified;
                tally.contact += one.contact;
                tally.undecided += one.undecided;
            }
        }
    }
    BOOST_TEST_MESSAGE(tally.certified << " certified, " << tally.contact << " in contact, "
                                       << tally.undecided << " undecided");
    BOOST_TEST(tally.certified > 100);
    BOOST_TEST(tally.contact > 50);
    BOOST_TEST(tally.undecided < 5);
}

struct HardMotion {
    const char* name;
    RigidMotion motion;
    double margin;
    SweepVerdict expected;
};

/// A box of half sides 1, 2, 3 and a plate of half sides 40, 40, 1 below it. Its bottom is 2 above the plate's top when the
/// box is at z = 6.
std::vector<HardMotion> hardMotions() {
    const auto at = [](double x, double y, double z) { return Pose{Matrix3::Identity(), {x, y, z}}; };
    const Vector3 none = Vector3::Zero(), along(30, 7, 0), up(0, 0, 1);
    const double edge = 40 + 1;  // the plate's border and half the box's width
    Pose tilted = at(0, 0, 4 + std::sqrt(5.0));
    tilted.rotation = Eigen::AngleAxisd(std::atan2(1, 3), Vector3::UnitY()).toRotationMatrix();
    constexpr auto kCertified = SweepVerdict::kCertified;
    constexpr auto kContact = SweepVerdict::kContact;
    return {
        {"slides along a face at the margin", {at(-20, 0, 6), along, none}, 2, kContact},
        {"slides a millionth beyond the margin", {at(-20, 0, 6 + 1e-6), along, none}, 2, kCertified},
        {"slides a millionth above the face", {at(-20, 0, 4 + 1e-6), along, none}, 0, kCertified},
        {"slides on the face", {at(-20, 0, 4), along, none}, 0, kContact},
        {"turns on its face, a millionth above", {at(0, 0, 4 + 1e-6), none, 3 * up}, 0, kCertified},
        {"screws along an axis that leans, above the margin",
         {at(-20, 0, 6 + 1e-5), along, 2 * up},
         2,
         kCertified},
        {"passes over the border", {at(edge - 5, 0, 4 + 1e-6), {10, 0, 0}, none}, 0, kCertified},
        {"dips below the face behind the border", {at(edge + 1e-6, 0, 6), {0, 0, -8}, none}, 0, kCertified},
        {"grazes the border with a side", {at(edge, 0, 6), {0, 0, -8}, none}, 0, kContact},
        {"grazes the border for an instant",
         {at(edge - 4, 0, 8), {8, 0, -8}, none},
         std::sqrt(0.5),
         kContact},
        {"turns by nearly pi above the face", {at(0, 0, 8), none, Vector3(M_PI - 1e-9, 0, 0)}, 0, kCertified},
        {"turns by nearly pi into the face", {at(0, 0, 5), none, Vector3(0, M_PI - 1e-9, 0)}, 0, kCertified},
        {"turns into the face", {at(0, 0, 4.1), none, Vector3(M_PI - 1e-9, 0, 0)}, 0, kContact},
        {"does not move, clear", {at(0, 0, 5), none, none}, 0.5, kCertified},
        {"does not move, in contact", {at(0, 0, 4), none, none}, 0, kContact},
        {"does not move, at the margin", {at(0, 0, 6), none, none}, 2, kContact},
        {"moves by very little", {at(0, 0, 4.1), {1e-9, 0, 1e-9}, Vector3(1e-9, 0, 0)}, 0.05, kCertified},
    };
}

BOOST_DATA_TEST_CASE(hard_motions_are_told_apart, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    const SweptPair pair("box over plate", box({1, 2, 3}, 2), box({40, 40, 1}, 5), width);
    for (const HardMotion& hard : hardMotions()) {
        BOOST_TEST_CONTEXT(hard.name) {
            SweepOptions options = optionsFor(pair, hard.margin);
            options.leastInterval = 1e-6;
            const Tally tally = judge(pair, hard.motion, options, 1000);
            BOOST_TEST(tally.certified == (hard.expected == SweepVerdict::kCertified));
            BOOST_TEST(tally.contact == (hard.expected == SweepVerdict::kContact));
        }
    }
}

/// A box that swings on a parabola over the plate: 2 above it at first and at last, `dip` nearer in the middle.
class Swing {
  public:
    explicit Swing(double dip) : dip_(dip) {}
    Pose at(double time) const {
        return {Matrix3::Identity(), {-20 + 40 * time, 0, 6 - 4 * dip_ * time * (1 - time)}};
    }
    MotionPieces pieces() const {
        return [*this](double from, double to) {
            const double middle = from + 0.5 * (to - from), half = 0.5 * (to - from);
            MotionPiece piece;
            piece.middle = at(middle);
            piece.velocity = {40, 0, -4 * dip_ * (1 - 2 * middle)};
            piece.angularVelocity.setZero();
            piece.deviation = 4 * dip_ * half * half;
            return piece;
        };
    }

  private:
    double dip_;
};

BOOST_DATA_TEST_CASE(a_curved_motion_is_certified_by_its_deviation, eachWidth(), width) {
    const SweptPair pair("box over plate", box({1, 2, 3}), box({40, 40, 1}), width);
    const SweepOptions options = optionsFor(pair, 0.5);
    Workspace workspace;
    const auto certify = [&](double dip) {
        return sweep(pair.part, pair.environment, Swing(dip).pieces(), options, workspace).verdict;
    };
    const auto isEverWithin = [&](double dip) {
        bool isWithinSomewhere = false;
        for (int i = 0; i <= 1000; ++i) {
            const Pose X = Swing(dip).at(i / 1000.0);
            isWithinSomewhere = isWithinSomewhere || isWithin(pair.part, pair.environment, X, 0.5, workspace);
        }
        return isWithinSomewhere;
    };
    BOOST_TEST((certify(1.499) == SweepVerdict::kCertified));
    BOOST_TEST(!isEverWithin(1.499));
    BOOST_TEST((certify(1.501) == SweepVerdict::kContact));
    BOOST_TEST(isEverWithin(1.501));
    const LeastDistanceOptions least;
    BOOST_TEST(
        leastDistance(pair.part, pair.environment, Swing(1.25).pieces(), least, workspace).upper == 0.75,
        boost::test_tools::tolerance(1e-2));
}

/// Each piece stands still in its middle, so that all of the way is a deviation, of either kind.
BOOST_DATA_TEST_CASE(deviations_count_in_all_directions_where_nothing_turns, eachWidth(), width) {
    const SweptPair pair("box and wall", box({1, 2, 3}), translated(box({0.1, 40, 40}), {-8, 0, 0}), width);
    Workspace workspace;
    for (const auto kind : {&MotionPiece::deviation, &MotionPiece::deviationAcrossRotation}) {
        const auto standing = [&](double from, double to) {
            MotionPiece piece;
            piece.middle = Swing(0).at(from + 0.5 * (to - from));
            piece.velocity = piece.angularVelocity = Vector3::Zero();
            piece.*kind = 0.5 * (to - from) * 40;
            return piece;
        };
        const SweepResult found =
            sweep(pair.part, pair.environment, standing, optionsFor(pair, 0), workspace);
        BOOST_TEST((found.verdict == SweepVerdict::kContact));
    }
}

BOOST_DATA_TEST_CASE(the_least_distance_is_bounded_from_both_sides, eachTarget() * eachWidth(), target,
                     width) {
    const UsingTarget using_(target);
    Workspace workspace;
    int apart = 0;
    for (const SweptPair& pair : sweptPairs(width)) {
        for (std::uint64_t seed = 100; seed < 112; ++seed) {
            BOOST_TEST_CONTEXT(pair.name << ", seed " << seed) {
                Random random(seed);
                const RigidMotion motion = randomMotion(random, pair);
                LeastDistanceOptions options;
                options.margin = random.below(2) * 1e-3 * pair.size;
                options.resolution = {1e-2, 0.1, 1e-4 * pair.size, 1e-6 * pair.size};
                const LeastDistance least = leastDistance(pair.part, pair.environment,
                                                          piecesOf(motion, pair.part), options, workspace);
                const auto clearanceAt = [&](double time) {
                    return distance(pair.part, pair.environment, poseAt(motion, time), {}, workspace).upper -
                           options.margin;
                };
                const double doubt = 1e-12 * (pair.size + pair.centre.norm());
                double sampled = HUGE_VAL;
                for (int i = 0; i <= 50; ++i) sampled = std::min(sampled, clearanceAt(i / 50.0));
                BOOST_TEST(least.lower <= sampled + doubt);
                BOOST_TEST(least.lower <= least.upper);
                const NearestAlong nearest = least.nearest.value();
                BOOST_TEST(clearanceAt(nearest.time) <= least.upper + doubt);
                BOOST_TEST(!least.isStopped);
                const double gap = (nearest.pointOnPart - nearest.pointOnEnvironment).norm();
                BOOST_TEST(std::abs(gap - options.margin - least.upper) <= doubt);
                if (least.upper <= options.resolution.least) continue;
                BOOST_TEST(least.upper - least.lower <= 1.001 * options.resolution.of(least.upper) + doubt);
                ++apart;
                options.cap = 0.5 * least.lower;
                const LeastDistance capped = leastDistance(pair.part, pair.environment,
                                                           piecesOf(motion, pair.part), options, workspace);
                BOOST_TEST(capped.lower == *options.cap);
                BOOST_TEST(std::isinf(capped.upper));
                BOOST_TEST(!capped.nearest);
            }
        }
    }
    BOOST_TEST(apart > 50);
}

BOOST_DATA_TEST_CASE(a_pipe_rolls_a_millionth_above_a_plate, eachWidth(), width) {
    const SweptPair pair("pipe over plate", tube(2, 3, 4, 200), box({40, 40, 1}, 4), width);
    SweepOptions options = optionsFor(pair, 0);
    options.leastInterval = 1e-6;
    BOOST_TEST(judge(pair, rolling(1e-6), options, 3000).certified == 1);
    BOOST_TEST(judge(pair, rolling(-1e-3), options, 3000).contact == 1);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
