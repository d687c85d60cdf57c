#include "clearway/planning/discrete_motion_validator.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <boost/test/unit_test.hpp>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "clearway/planning/state_to_pose.h"
#include "support/random_meshes.h"

namespace clearway::planning {

BOOST_AUTO_TEST_SUITE(discrete_motion_validator_test)

namespace {

namespace ob = ompl::base;

constexpr double kRadius = 450;

/// A checker that records the poses it is asked about, and answers as the test sets.
class SpyChecker : public ob::StateValidityChecker {
  public:
    SpyChecker(const ob::SpaceInformationPtr& si, std::function<bool(const Pose&)> answer)
        : StateValidityChecker(si), toPose_(stateToPose(*si->getStateSpace())), answer_(std::move(answer)) {}

    bool isValid(const ob::State* state) const override {
        const Pose pose = toPose_(state);
        const std::lock_guard<std::mutex> lock(mutex_);
        asked.push_back(pose);
        return answer_(pose);
    }
    using StateValidityChecker::isValid;

    mutable std::vector<Pose> asked;

  private:
    StateToPose toPose_;
    std::function<bool(const Pose&)> answer_;
    mutable std::mutex mutex_;
};

/// SE(3) without obstacles: the spy alone decides what is valid.
struct Fixture {
    explicit Fixture(
        double step, std::function<bool(const Pose&)> answer = [](const Pose&) { return true; }) {
        ob::RealVectorBounds bounds(3);
        bounds.setLow(-1000);
        bounds.setHigh(1000);
        space->setBounds(bounds);
        spy = std::make_shared<SpyChecker>(si, std::move(answer));
        validator = std::make_shared<DiscreteMotionValidator>(si, displacementBound(*space, kRadius), step);
        si->setStateValidityChecker(spy);
        si->setMotionValidator(validator);
        si->setup();
    }

    ob::ScopedState<ob::SE3StateSpace> state(const Vector3& p, const Vector3& axis = Vector3::UnitZ(),
                                             double angle = 0) {
        ob::ScopedState<ob::SE3StateSpace> result(space);
        result->setXYZ(p.x(), p.y(), p.z());
        result->rotation().setAxisAngle(axis.x(), axis.y(), axis.z(), angle);
        return result;
    }

    std::shared_ptr<ob::SE3StateSpace> space = std::make_shared<ob::SE3StateSpace>();
    ob::SpaceInformationPtr si = std::make_shared<ob::SpaceInformation>(space);
    std::shared_ptr<SpyChecker> spy;
    std::shared_ptr<DiscreteMotionValidator> validator;
};

double largestDisplacement(const Pose& a, const Pose& b, const std::vector<Vector3>& points) {
    double largest = 0;
    for (const Vector3& p : points) largest = std::max(largest, (a * p - b * p).norm());
    return largest;
}

/// Orders the recorded poses of a straight motion by their distance from its start, and returns the largest
/// gap.
double largestGap(std::vector<Pose> poses, const std::vector<Vector3>& points) {
    const Pose start = poses.front();
    std::sort(poses.begin(), poses.end(), [&](const Pose& a, const Pose& b) {
        return (a.translation - start.translation).norm() < (b.translation - start.translation).norm();
    });
    double largest = 0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        largest = std::max(largest, largestDisplacement(poses[i - 1], poses[i], points));
    }
    return largest;
}

BOOST_AUTO_TEST_CASE(no_point_of_the_part_moves_further_than_the_step_between_two_checks) {
    for (int seed = 1; seed <= 60; ++seed) {
        testing::Random random(seed);
        const double step = std::pow(10, random.uniform(0, 1.5));
        Fixture f(step);
        std::vector<Vector3> points;
        for (int i = 0; i < 30; ++i) points.push_back(random.direction() * kRadius);
        // Angles down to 1e-5 rad: OMPL's interpolation leaves those out until the very end.
        const double angle = M_PI * std::pow(10, -random.uniform(0, 5.5));
        const Vector3 p = random.inBox(500);
        const auto s1 = f.state(p, random.direction(), 1);
        const auto s2 = f.state(p + random.inBox(100), random.direction(), angle);
        ob::ScopedState<ob::SE3StateSpace> end(f.space);
        end = s2;
        if (seed % 2 == 0) {  // every other motion turns little
            const Eigen::Quaterniond q1(s1->rotation().w, s1->rotation().x, s1->rotation().y,
                                        s1->rotation().z);
            const Eigen::Quaterniond q2 = Eigen::AngleAxisd(angle, random.direction()) * q1;
            end->rotation().w = q2.w();
            end->rotation().x = q2.x();
            end->rotation().y = q2.y();
            end->rotation().z = q2.z();
        }
        BOOST_TEST_CONTEXT("seed " << seed << ", step " << step << ", angle " << angle) {
            BOOST_TEST(f.validator->checkMotion(s1.get(), end.get()));
            f.spy->asked.insert(f.spy->asked.begin(), stateToPose(*f.space)(s1.get()));
            BOOST_TEST(largestGap(f.spy->asked, points) <= step);
            std::pair<ob::State*, double> lastValid(nullptr, -1);
            f.spy->asked.clear();
            BOOST_TEST(f.validator->checkMotion(s1.get(), end.get(), lastValid));
            BOOST_TEST(largestGap(f.spy->asked, points) <= step);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_turn_that_ompl_leaves_out_until_the_end_stays_within_the_step) {
    for (int seed = 1; seed <= 50; ++seed) {
        testing::Random random(seed);
        Fixture f(1);
        std::vector<Vector3> points;
        for (int i = 0; i < 30; ++i) points.push_back(random.direction() * kRadius);
        const auto s1 = f.state({0, 0, 0});
        const auto s2 = f.state({100 + random.uniform(-0.05, 0), 0, 0}, random.direction(), 8e-5);
        f.spy->asked.push_back(stateToPose(*f.space)(s1.get()));
        BOOST_TEST_CONTEXT("seed " << seed) {
            BOOST_TEST(f.validator->checkMotion(s1.get(), s2.get()));
            BOOST_TEST(largestGap(f.spy->asked, points) <= 1);
        }
    }
}

BOOST_AUTO_TEST_CASE(both_ends_and_every_part_between_are_checked_once) {
    Fixture f(10);
    const auto s1 = f.state({0, 0, 0}), s2 = f.state({94.9, 0, 0});
    BOOST_TEST(f.validator->partsOf(s1.get(), s2.get()) == 10u);
    BOOST_TEST(f.validator->checkMotion(s1.get(), s2.get()));
    BOOST_TEST(f.spy->asked.size() == 11u);
    BOOST_TEST(f.spy->asked[0].translation.x() == 94.9);  // the far end comes first
    BOOST_TEST(f.spy->asked[1].translation.x() == 0.8 * 94.9);
    BOOST_TEST(f.spy->asked.back().translation.x() == 0);
    BOOST_TEST(f.validator->partsOf(s1.get(), s1.get()) == 1u);
}

BOOST_AUTO_TEST_CASE(a_wall_of_twice_the_step_is_never_jumped) {
    for (int seed = 1; seed <= 100; ++seed) {
        testing::Random random(seed);
        const double wall = random.uniform(-80, 80);
        Fixture f(1, [&](const Pose& pose) { return std::abs(pose.translation.x() - wall) > 1; });
        const auto s1 = f.state({-100, 0, 0}),
                   s2 = f.state({100, random.uniform(-100, 100), 0}, random.direction(), 2);
        BOOST_TEST_CONTEXT("seed " << seed) {
            BOOST_TEST(!f.validator->checkMotion(s1.get(), s2.get()));
        }
    }
}

BOOST_AUTO_TEST_CASE(last_valid_is_the_valid_state_before_the_first_invalid_one) {
    const auto answer = [](const Pose& pose) { return pose.translation.x() < 50; };
    Fixture f(1, answer);
    const auto s1 = f.state({0, 0, 0}), s2 = f.state({100, 30, 0}, Vector3::UnitX(), 1);
    ob::ScopedState<ob::SE3StateSpace> kept(f.space);
    std::pair<ob::State*, double> lastValid(kept.get(), -1);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), s2.get(), lastValid));
    const double n = static_cast<double>(f.validator->partsOf(s1.get(), s2.get()));
    BOOST_TEST(lastValid.second < 0.5);
    BOOST_TEST(lastValid.second + 1 / n >= 0.5);
    ob::ScopedState<ob::SE3StateSpace> expected(f.space);
    f.space->interpolate(s1.get(), s2.get(), lastValid.second, expected.get());
    BOOST_TEST((kept == expected));
    BOOST_TEST(answer(stateToPose(*f.space)(kept.get())));
}

BOOST_AUTO_TEST_CASE(last_valid_may_be_null_or_one_of_the_two_states) {
    Fixture f(1, [](const Pose& pose) { return pose.translation.x() < 50; });
    auto s1 = f.state({0, 0, 0}), s2 = f.state({100, 0, 0});
    std::pair<ob::State*, double> none(nullptr, -1);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), s2.get(), none));
    BOOST_TEST(none.second > 0.4);

    std::pair<ob::State*, double> second(s2.get(), -1);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), s2.get(), second));
    BOOST_TEST(s2->getX() == 100 * second.second);

    auto far = f.state({100, 0, 0});
    std::pair<ob::State*, double> first(s1.get(), -1);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), far.get(), first));
    BOOST_TEST(s1->getX() == 100 * first.second);
}

BOOST_AUTO_TEST_CASE(a_valid_motion_leaves_last_valid_alone) {
    Fixture f(1);
    const auto s1 = f.state({0, 0, 0}), s2 = f.state({100, 0, 0});
    auto kept = f.state({7, 7, 7});
    const auto before = kept;
    std::pair<ob::State*, double> lastValid(kept.get(), -1);
    BOOST_TEST(f.validator->checkMotion(s1.get(), s2.get(), lastValid));
    BOOST_TEST(lastValid.second == -1);
    BOOST_TEST((kept == before));
}

BOOST_AUTO_TEST_CASE(an_invalid_start_is_answered_at_time_0_and_counted) {
    Fixture f(1, [](const Pose& pose) { return pose.translation.x() > 50; });
    const auto s1 = f.state({0, 0, 0}), s2 = f.state({100, 0, 0});
    auto kept = f.state({7, 7, 7});
    std::pair<ob::State*, double> lastValid(kept.get(), -1);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), s2.get(), lastValid));
    BOOST_TEST(lastValid.second == 0);
    BOOST_TEST((kept == s1));
    BOOST_TEST(f.validator->invalidStarts() == 1u);

    Fixture g(1, [](const Pose& pose) { return pose.translation.x() != 0; });
    BOOST_TEST(!g.validator->checkMotion(s1.get(), s2.get()));
    BOOST_TEST(g.validator->invalidStarts() == 1u);
}

BOOST_AUTO_TEST_CASE(a_turn_that_ompl_leaves_out_is_refused_when_the_step_is_finer) {
    Fixture f(1e-3);
    const auto s1 = f.state({0, 0, 0});
    const auto turned = f.state({0, 0, 0}, Vector3::UnitZ(), 8e-5);  // 450 * 8e-5 = 36 steps in one jump
    BOOST_TEST(f.validator->partsOf(s1.get(), turned.get()) == 0u);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), turned.get()));
    std::pair<ob::State*, double> lastValid(nullptr, -1);
    BOOST_TEST(!f.validator->checkMotion(s1.get(), turned.get(), lastValid));
    BOOST_TEST(lastValid.second == 0);
}

BOOST_AUTO_TEST_CASE(a_motion_to_a_state_that_is_not_finite_is_invalid) {
    Fixture f(1);
    const auto s1 = f.state({0, 0, 0}), s2 = f.state({std::nan(""), 0, 0});
    BOOST_TEST(!f.validator->checkMotion(s1.get(), s2.get()));
}

BOOST_AUTO_TEST_CASE(a_motion_from_or_to_a_quaternion_that_is_no_rotation_is_invalid) {
    Fixture f(1);
    const auto good = f.state({0, 0, 0});
    for (const double w : {0.0, 2.0, 1 + 1e-8, 1e200, std::nan(""), HUGE_VAL}) {
        auto bad = f.state({10, 0, 0});
        bad->rotation().w = w;
        const ob::State *one = good.get(), *other = bad.get();
        for (int turn = 0; turn < 2; ++turn, std::swap(one, other)) {
            std::pair<ob::State*, double> lastValid(nullptr, -1);
            BOOST_TEST(f.validator->partsOf(one, other) == 0u);
            BOOST_TEST(!f.validator->checkMotion(one, other));
            BOOST_TEST(!f.validator->checkMotion(one, other, lastValid));
            BOOST_TEST(lastValid.second == 0);
        }
    }
}

BOOST_AUTO_TEST_CASE(motions_are_counted_from_any_thread) {
    Fixture f(10, [](const Pose& pose) { return pose.translation.x() < 50; });
    const auto s1 = f.state({0, 0, 0}), near = f.state({40, 0, 0}), far = f.state({90, 0, 0});
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&] {
            for (int i = 0; i < 500; ++i) {
                f.validator->checkMotion(s1.get(), near.get());
                f.validator->checkMotion(s1.get(), far.get());
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    BOOST_TEST(f.validator->getValidMotionCount() == 2000u);
    BOOST_TEST(f.validator->getInvalidMotionCount() == 2000u);
}

BOOST_AUTO_TEST_CASE(another_space_needs_a_bound_of_its_own) {
    const auto space = std::make_shared<ob::RealVectorStateSpace>(1);
    space->setBounds(0, 10);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    int asked = 0;
    si->setStateValidityChecker([&](const ob::State*) { return ++asked > 0; });
    const auto bound = [](const ob::State* a, const ob::State* b) {
        return std::abs(a->as<ob::RealVectorStateSpace::StateType>()->values[0] -
                        b->as<ob::RealVectorStateSpace::StateType>()->values[0]);
    };
    const DiscreteMotionValidator validator(si, bound, 0.5);
    ob::ScopedState<ob::RealVectorStateSpace> a(space), b(space);
    a[0] = 0;
    b[0] = 10;
    BOOST_TEST(validator.checkMotion(a.get(), b.get()));
    BOOST_TEST(asked == 21);
}

BOOST_AUTO_TEST_CASE(a_step_that_is_no_length_is_refused) {
    Fixture f(1);
    const DisplacementBound bound = displacementBound(*f.space, 1);
    for (const double step : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        BOOST_CHECK_THROW(DiscreteMotionValidator(f.si, bound, step), std::invalid_argument);
    }
}

BOOST_AUTO_TEST_CASE(an_empty_bound_is_refused) {
    Fixture f(1);
    BOOST_CHECK_THROW(DiscreteMotionValidator(f.si, DisplacementBound(), 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_motion_that_is_stopped_counts_as_invalid) {
    Fixture f(1e-5);
    int left = 100;
    const DiscreteMotionValidator stopped(f.si, displacementBound(*f.space, kRadius), 1e-5,
                                          [&] { return --left < 0; });
    const auto s1 = f.state({-900, 0, 0}), s2 = f.state({900, 0, 0});
    BOOST_TEST(!stopped.checkMotion(s1.get(), s2.get()));
    BOOST_TEST(f.spy->asked.size() <= 102u);
    left = 100;
    std::pair<ob::State*, double> lastValid(nullptr, 1);
    BOOST_TEST(!stopped.checkMotion(s1.get(), s2.get(), lastValid));
    BOOST_TEST(lastValid.second > 0);
    BOOST_TEST(lastValid.second < 1e-3);
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway::planning
