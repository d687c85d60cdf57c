// Sweeps that are stopped, that run out of memory, that begin in contact or are asked wrongly.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "model/model_data.h"
#include "query/sweep.h"
#include "support/each_target.h"
#include "support/swept_pairs.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(sweep_ends_test)

BOOST_AUTO_TEST_CASE(a_stop_is_asked_for_at_once_and_after_at_most_256_steps) {
    const SweptPair pair("pipe over plate", tube(2, 3, 4, 200), box({40, 40, 1}, 12), 8);
    SweepOptions options = optionsFor(pair, 0);
    options.leastInterval = 1e-9;
    const MotionPieces pieces = piecesOf(rolling(1e-6), pair.part);
    Workspace workspace;
    int asked = 0;
    options.isStopped = [&] { return ++asked == 40; };
    const SweepResult found = sweep(pair.part, pair.environment, pieces, options, workspace);
    BOOST_TEST((found.verdict == SweepVerdict::kUndecided));
    BOOST_TEST(asked == 40);
    // A step is a visit, a pair of leaves, an interval halved unlooked at, or a pair resolved in double.
    BOOST_TEST(found.counters.nodeVisits + found.counters.refinedPairs <= 256u * 40);
    options.isStopped = [] { return true; };
    BOOST_TEST(sweep(pair.part, pair.environment, pieces, options, workspace).counters.nodeVisits == 0u);
    options.isForward = true;
    BOOST_TEST(sweep(pair.part, pair.environment, pieces, options, workspace).certifiedUntil == 0);
}

/// Pairs of long triangles often need double, so that many stops come amid the pairs of two leaves.
BOOST_DATA_TEST_CASE(going_forward_a_stop_leaves_no_time_certified_that_is_open, eachWidth(), width) {
    Random shapes(5);
    const SweptPair pair("needles", stretchedSoup(shapes, 16), stretchedSoup(shapes, 16), width);
    Workspace workspace;
    int stopped = 0;
    for (std::uint64_t seed = 0; seed < 20000; ++seed) {
        Random random(seed);
        const RigidMotion motion = randomMotion(random, pair);
        SweepOptions options;
        options.isForward = true;
        options.leastInterval = options.contactTime = 1e-12;
        int asked = 0;
        options.isStopped = [&] { return ++asked == 2; };
        const SweepResult found =
            sweep(pair.part, pair.environment, piecesOf(motion, pair.part), options, workspace);
        if (asked < 2) continue;
        ++stopped;
        for (int i = 0; i <= 100; ++i) {
            const double time = found.certifiedUntil * (1 - 1e-4 * i * i);
            if (time > 0)
                BOOST_TEST(!collides(pair.part, pair.environment, poseAt(motion, time), workspace),
                           "seed " << seed << " at " << time);
        }
    }
    BOOST_TEST(stopped > 50);
}

BOOST_AUTO_TEST_CASE(a_motion_in_contact_from_its_start_is_certified_nowhere) {
    const SweptPair pair("boxes", box({1, 2, 3}, 2), box({1, 2, 3}, 2), 8);
    SweepOptions options;
    options.isForward = true;
    options.contactTime = 0;
    Workspace workspace;
    for (const double shift : {0.0, 1.0}) {
        const RigidMotion motion{{Matrix3::Identity(), {2 - shift, 0, 0}}, {9, 0, 0}, Vector3(0, 0, 1)};
        const SweepResult found =
            sweep(pair.part, pair.environment, piecesOf(motion, pair.part), options, workspace);
        // Boxes that part from touching are in contact at time 0 only, which no middle of an interval is.
        const SweepVerdict expected = shift > 0 ? SweepVerdict::kContact : SweepVerdict::kUndecided;
        BOOST_TEST((found.verdict == expected));
        BOOST_TEST(found.certifiedUntil == 0);
    }
}

BOOST_DATA_TEST_CASE(a_full_stack_is_undecided, eachWidth(), width) {
    const SweptPair pair("boxes", box({1, 2, 3}, 4), box({1, 2, 3}, 4), width);
    const RigidMotion motion{{Matrix3::Identity(), {2.01, 0, 0}}, {0, 1, 1}, Vector3(0.1, 0, 0)};
    SweepRequest request;
    request.leastInterval = 1e-6;
    Workspace workspace;
    const MotionPieces pieces = piecesOf(motion, pair.part);
    for (const SweepGoal goal : {SweepGoal::kCertify, SweepGoal::kForward}) {
        request.goal = goal;
        request.mostEntries = kMostSweepEntries;
        const auto answer = [&] {
            return sweepTrees(treeOf(pair.part), treeOf(pair.environment), pieces, request,
                              stateOf(workspace));
        };
        BOOST_TEST(!answer().isUndecided);
        request.mostEntries = 0;
        const SweepAnswer full = answer();
        BOOST_TEST(full.isUndecided);
        BOOST_TEST(full.certifiedUntil < 1);
    }
}

BOOST_AUTO_TEST_CASE(a_forbidden_pose_counts_as_contact_even_where_contact_does_not_count) {
    const SweptPair pair("boxes", box({1, 2, 3}), box({1, 2, 3}), 8);
    const RigidMotion motion{{Matrix3::Identity(), {9, 0, 0}}, {1, 0, 0}, Vector3::Zero()};
    const MotionPieces pieces = [steady = piecesOf(motion, pair.part)](double from, double to) {
        MotionPiece piece = steady(from, to);
        piece.counts = MotionPiece::Counts::kNowhere;
        piece.isForbidden = from + to > 0.5;
        return piece;
    };
    Workspace workspace;
    SweepOptions options;
    BOOST_TEST(
        (sweep(pair.part, pair.environment, pieces, options, workspace).verdict == SweepVerdict::kContact));
    options.until = 0.2;
    BOOST_TEST(
        (sweep(pair.part, pair.environment, pieces, options, workspace).verdict == SweepVerdict::kCertified));
}

/// Boxes that do not move, 1 apart.
BOOST_AUTO_TEST_CASE(a_least_distance_leaves_room_for_the_error_of_poses) {
    const SweptPair pair("boxes", box({1, 2, 3}, 2), box({1, 2, 3}, 2), 8);
    const RigidMotion motion{{Matrix3::Identity(), {3, 0, 0}}, Vector3::Zero(), Vector3::Zero()};
    Workspace workspace;
    for (const double error : {0.0, 1e-3, 0.1, 0.5, 5.0}) {
        LeastDistanceOptions options;
        options.poseError = error;
        const LeastDistance found =
            leastDistance(pair.part, pair.environment, piecesOf(motion, pair.part), options, workspace);
        BOOST_TEST(found.lower <= std::max(0.0, 1 - error) + 1e-12, "error " << error);
        BOOST_TEST(found.lower >= std::max(0.0, 1 - error - 0.011), "error " << error);
    }
}

/// A box slides past another one, at the cap exactly. To prove that it keeps it would take as many steps as there are least
/// intervals.
BOOST_AUTO_TEST_CASE(a_motion_that_keeps_the_cap_exactly_takes_no_longer_than_others) {
    const SweptPair pair("boxes", box({1, 2, 3}, 2), box({40, 2, 3}, 2), 8);
    const RigidMotion motion{{Matrix3::Identity(), {-30, 0, 8}}, {60, 0, 0}, Vector3::Zero()};
    Workspace workspace;
    for (const double cap : {1.9, 1.99, 2.0, 2.0 + 1e-7, 2.02, 2.1}) {
        LeastDistanceOptions options;
        options.cap = cap;
        options.resolution.least = 1e-9;
        long asked = 0;
        options.isStopped = [&] { return ++asked > 100; };
        const LeastDistance found =
            leastDistance(pair.part, pair.environment, piecesOf(motion, pair.part), options, workspace);
        BOOST_TEST(!found.isStopped, "cap " << cap);
        BOOST_TEST(found.lower <= 2, "cap " << cap);
        BOOST_TEST(found.lower >= std::min(cap, 2.0) - options.resolution.of(2), "cap " << cap);
        BOOST_TEST((cap < 2.01 || std::abs(found.upper - 2) < 1e-6), "cap " << cap);
    }
}

BOOST_AUTO_TEST_CASE(wrong_arguments_are_refused_by_name) {
    const SweptPair pair("boxes", box({1, 2, 3}), box({1, 2, 3}), 8);
    const RigidMotion motion{{Matrix3::Identity(), {9, 0, 0}}, {1, 0, 0}, Vector3::Zero()};
    Workspace workspace;
    const auto ask = [&](const RigidMotion& asked, const SweepOptions& options) {
        return sweep(pair.part, pair.environment, piecesOf(asked, pair.part), options, workspace);
    };
    const double nan = std::nan("");
    for (const double wrong : {-1.0, nan, HUGE_VAL}) {
        SweepOptions options;
        options.margin = wrong;
        requireRefusedBy([&] { ask(motion, options); }, {"margin is "});
        options = {};
        options.poseError = wrong;
        requireRefusedBy([&] { ask(motion, options); }, {"poseError is "});
        options = {};
        options.leastInterval = wrong < 0 ? wrong : nan;
        requireRefusedBy([&] { ask(motion, options); }, {"leastInterval is "});
        options = {};
        options.contactTime = wrong;
        requireRefusedBy([&] { ask(motion, options); }, {"contactTime is "});
        options = {};
        options.from = wrong;
        requireRefusedBy([&] { ask(motion, options); }, {"from is "});
        options = {};
        options.until = wrong;
        requireRefusedBy([&] { ask(motion, options); }, {"until is "});
        for (const char* name : {"share", "largestShare", "length", "least"}) {
            LeastDistanceOptions asked;
            ClearanceResolution& resolution = asked.resolution;
            (name == std::string("share")          ? resolution.share
             : name == std::string("largestShare") ? resolution.largestShare
             : name == std::string("length")       ? resolution.length
                                                   : resolution.least) = wrong == HUGE_VAL ? nan : wrong;
            requireRefusedBy(
                [&] {
                    leastDistance(pair.part, pair.environment, piecesOf(motion, pair.part), asked, workspace);
                },
                {"resolution." + std::string(name) + " is "});
        }
    }
    requireRefusedBy([&] { sweep(pair.part, pair.environment, {}, {}, workspace); }, {"empty"});
    RigidMotion wrong = motion;
    wrong.translation.x() = nan;
    requireRefusedBy([&] { ask(wrong, {}); }, {"expected"});
    wrong.translation.x() = HUGE_VAL;
    requireRefusedBy([&] { ask(wrong, {}); }, {"expected"});
    wrong.translation.x() = 1e30;
    requireRefusedBy([&] { ask(wrong, {}); }, {"expected"});
    wrong = motion;
    wrong.rotation.x() = 1e30;
    requireRefusedBy([&] { ask(wrong, {}); }, {"expected"});
    wrong = motion;
    wrong.start.rotation *= 2;
    requireRefusedBy([&] { ask(wrong, {}); }, {"rotation"});
    BOOST_TEST((ask(motion, {}).verdict == SweepVerdict::kCertified));
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
