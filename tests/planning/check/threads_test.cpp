// Checkers, validators and objectives shared by threads.
#include <ompl/base/samplers/UniformValidStateSampler.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "clearway/obstacle_groups.h"
#include "clearway/planning/check_path.h"
#include "clearway/planning/clearance_objectives.h"
#include "clearway/planning/explain.h"
#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/plan.h"
#include "clearway/planning/planners.h"
#include "planning/space/ompl_states.h"
#include "support/door_scene.h"
#include "support/motion_window.h"
#include "support/planar_scenes.h"
#include "support/random_meshes.h"

namespace clearway::planning {
BOOST_AUTO_TEST_SUITE(threads_test)

constexpr int kThreads = 8;

void inThreads(const std::function<void(int thread)>& work) {
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) threads.emplace_back(work, t);
    for (std::thread& thread : threads) thread.join();
}

/// Every kind of question about a scene, for one pair of states.
struct Asked {
    explicit Asked(const ob::SpaceInformationPtr& theSi, const Scene& scene)
        : si(theSi),
          checker(si, scene),
          validator(si, scene),
          least(si, scene),
          integral(si, scene),
          wanted(si, scene) {}

    std::array<double, 9> of(const ob::State* s1, const ob::State* s2) const {
        std::pair<ob::State*, double> lastValid(nullptr, 0);
        return {static_cast<double>(checker.isValid(s1)),
                static_cast<double>(checker.clearance(s1) > 0),
                static_cast<double>(validator.checkMotion(s1, s2)),
                static_cast<double>(validator.checkMotion(s1, s2, lastValid)),
                least.motionCost(s1, s2).value(),
                integral.motionCost(s1, s2).value(),
                wanted.motionCost(s1, s2).value(),
                least.motionCostHeuristic(s1, s2).value(),
                wanted.motionCostHeuristic(s1, s2).value()};
    }

    ob::SpaceInformationPtr si;
    ValidityChecker checker;
    MotionValidator validator;
    MinClearanceObjective least;
    ClearanceIntegralObjective integral;
    LengthWithClearanceObjective wanted;
};

/// The scene has solids, and a second obstacle that is ignored near the start.
BOOST_AUTO_TEST_CASE(eight_threads_are_told_what_one_is) {
    const testing::MotionWindow f(0.5);
    const Mesh block = testing::translated(testing::box({20, 10, 10}), {-60, 30, 0});
    Scene scene = f.window.scene;
    scene.partSolids = makeSolids(f.window.partMesh).solids;
    scene.obstacles[0].solids = makeSolids(f.window.wallMesh).solids;
    scene.obstacles.push_back({Model::build(block), 2});
    scene.obstacles[1].solids = makeSolids(block).solids;
    scene.obstacles[1].isIgnoredAtStart = true;
    scene.startContact = ContactZone{{Matrix3::Identity(), {-50, 10, 0}}, 30};
    const Asked asked(f.si, scene);
    testing::Random random(41);
    std::vector<ob::ScopedState<>> states;
    for (int i = 0; i < 32; ++i) {
        states.push_back(
            f.at(Vector3(-45, 0, 0) + random.inBox(25), random.uniform(0, 3), random.direction()));
    }
    using Answers = std::vector<std::array<double, 9>>;
    Answers alone;
    for (std::size_t i = 1; i < states.size(); ++i)
        alone.push_back(asked.of(states[i - 1].get(), states[i].get()));
    std::vector<Answers> found(kThreads, Answers(alone.size()));
    inThreads([&](int t) {
        for (std::size_t k = 0; k < alone.size(); ++k) {
            // 31 is prime: each thread in an order of its own.
            const std::size_t i = (k * static_cast<std::size_t>(t + 1)) % alone.size();
            found[static_cast<std::size_t>(t)][i] = asked.of(states[i].get(), states[i + 1].get());
        }
    });
    for (const Answers& answers : found) BOOST_TEST((answers == alone));
    const std::size_t calls = (kThreads + 1) * alone.size();
    BOOST_TEST(asked.least.counters().motions == calls);
    BOOST_TEST(asked.checker.counters().checks == 2 * calls);
    BOOST_TEST(asked.validator.counters().valid + asked.validator.counters().invalid == 2 * calls);
    BOOST_TEST(std::any_of(alone.begin(), alone.end(), [](const auto& a) { return a[2] == 1; }));
    BOOST_TEST(std::any_of(alone.begin(), alone.end(), [](const auto& a) { return a[2] == 0; }));
}

/// Threads that live through several rounds of work, one task each a round.
class Rounds {
  public:
    Rounds() {
        for (int t = 0; t < kThreads; ++t) threads_.emplace_back([this, t] { live(t); });
    }
    ~Rounds() {
        run(nullptr);
        for (std::thread& thread : threads_) thread.join();
    }

    /// Returns when every thread has done its task.
    void run(const std::function<void(int thread)>& work) {
        std::unique_lock<std::mutex> lock(mutex_);
        work_ = work;
        left_ = kThreads;
        ++round_;
        changed_.notify_all();
        changed_.wait(lock, [this] { return left_ == 0; });
    }

  private:
    void live(int thread) {
        for (int seen = 0;; ++seen) {
            std::function<void(int)> work;
            {
                std::unique_lock<std::mutex> lock(mutex_);
                changed_.wait(lock, [&] { return round_ > seen; });
                work = work_;
            }
            if (work) work(thread);
            const std::lock_guard<std::mutex> lock(mutex_);
            if (--left_ == 0) changed_.notify_all();
            if (!work) return;
        }
    }

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void(int)> work_;
    int round_ = 0, left_ = 0;
};

/// Walls at different places have different closest pairs, so that the warm start of one is wrong for
/// another.
BOOST_AUTO_TEST_CASE(threads_that_live_on_never_meet_the_scratch_of_a_scene_that_is_gone) {
    const testing::MotionWindow f;
    const auto s1 = f.at({-70, 0, 30}), s2 = f.at({-50, 10, 20}, 0.5);
    Rounds rounds;
    for (int round = 0; round < 12; ++round) {
        const double shift = 2 * (round % 4);
        const Mesh wall = testing::translated(f.window.wallMesh, {shift, 0, 0});
        const Scene scene(f.window.scene.part, Model::build(wall));
        const auto asked = std::make_unique<Asked>(f.si, scene);
        const double clearance = 70 + shift - 30 - 2;
        const std::array<double, 9> expected = Asked(f.si, scene).of(s1.get(), s2.get());
        std::array<char, kThreads> isRight{};
        rounds.run([&](int t) {
            const auto mine = static_cast<std::size_t>(t);
            isRight[mine] = std::abs(asked->checker.clearance(s1.get()) - clearance) < 1e-9 &&
                            asked->of(s1.get(), s2.get()) == expected;
        });
        for (int t = 0; t < kThreads; ++t) {
            BOOST_TEST(isRight[static_cast<std::size_t>(t)], "round " << round << ", thread " << t);
        }
    }
}

/// Setting one up frees the texts of the space's parameters, which making one reads.
BOOST_AUTO_TEST_CASE(space_informations_of_one_space_are_made_and_set_up_at_once) {
    const testing::MotionWindow f;
    const ob::StateSpacePtr space = f.si->getStateSpace();
    std::array<bool, kThreads> areSetUp{};
    inThreads([&](int t) {
        bool all = true;
        for (int round = 0; round < 5000; ++round) {
            const ob::SpaceInformationPtr si = makeOnSharedSpace(space);
            si->setStateValidityChecker(f.si->getStateValidityChecker());
            setUpOnSharedSpace(*si);
            all = all && si->isSetup();
        }
        areSetUp[static_cast<std::size_t>(t)] = all;
    });
    for (const bool each : areSetUp) BOOST_TEST(each);
}

using Parameters = std::vector<std::pair<std::string, std::string>>;

/// The planner's path, each motion of it certified.
void planWith(const std::string& name, const Parameters& parameters, bool hasObjective) {
    const auto gates = testing::gatesScene();
    const OmplMessages unobserved;
    const auto space = makeSpace(Space::kSe2, *gates.problem.volume, gates.scene.part.radiusAboutOrigin());
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker(std::make_shared<ValidityChecker>(si, gates.scene));
    const auto validator = std::make_shared<MotionValidator>(si, gates.scene);
    si->setMotionValidator(validator);
    // Samplers of valid states give up at once. OMPL's pSBL then keeps a lock for good; makePlanner's does not notice.
    si->setValidStateSamplerAllocator([](const ob::SpaceInformation* of) {
        const auto sampler = std::make_shared<ob::UniformValidStateSampler>(of);
        sampler->setNrAttempts(1);
        return sampler;
    });
    si->setup();
    const auto definition = std::make_shared<ob::ProblemDefinition>(si);
    definition->setStartAndGoalStates(toOmpl(space, Space::kSe2, gates.problem.start),
                                      toOmpl(space, Space::kSe2, gates.problem.goal));
    const auto objective = std::make_shared<MinClearanceObjective>(si, gates.scene);
    objective->setCostThreshold(ob::Cost(1));
    if (hasObjective) definition->setOptimizationObjective(objective);
    const ob::PlannerPtr planner = makePlanner(si, name);
    for (const auto& [parameter, value] : parameters) setParameter(*planner, parameter, value);
    planner->setProblemDefinition(definition);
    planner->setup();
    planner->solve(ob::timedPlannerTerminationCondition(20));
    BOOST_TEST_REQUIRE(definition->hasExactSolution(), name);
    auto& states = definition->getSolutionPath()->as<og::PathGeometric>()->getStates();
    for (std::size_t i = 1; i < states.size(); ++i) {
        BOOST_TEST((validator->report(states[i - 1], states[i]).verdict == MotionVerdict::kValid), name);
    }
    const MotionCounters counters = validator->counters();
    BOOST_TEST(counters.valid == validator->getValidMotionCount());
    BOOST_TEST(counters.invalid == validator->getInvalidMotionCount());
    BOOST_TEST(counters.unusable == 0u);
    if (hasObjective) BOOST_TEST(objective->counters().unusable == 0u);
}

BOOST_AUTO_TEST_CASE(planners_of_eight_threads_find_valid_paths) {
    planWith("pRRT", {{"thread_count", "8"}, {"range", "60"}}, false);
    planWith("pSBL", {{"thread_count", "8"}, {"range", "60"}}, false);
    planWith("CForest", {{"num_threads", "8"}}, true);
    const std::string inner = "RRTConnect[range=60]";
    std::string eight = inner;
    for (int i = 1; i < kThreads; ++i) eight += "," + inner;
    planWith("AnytimePathShortening", {{"planners", eight}}, true);
}

BOOST_AUTO_TEST_CASE(messages_come_to_those_who_live_in_whatever_order_they_end) {
    ompl::msg::OutputHandler* const before = ompl::msg::getOutputHandler();
    auto first = std::make_unique<OmplMessages>(), second = std::make_unique<OmplMessages>();
    const auto warn = [](const char* text) { std::thread([=] { OMPL_WARN("%s", text); }).join(); };
    warn("to the second, of the same thread");
    first.reset();
    std::unique_ptr<OmplMessages> other;
    std::promise<void> isMade, isOver;
    std::thread holder([&] {
        other = std::make_unique<OmplMessages>();
        isMade.set_value();
        isOver.get_future().wait();
    });
    isMade.get_future().wait();
    warn("to both threads");
    OMPL_WARN("to the own thread");
    BOOST_TEST(second->warnings().size() == 3u);
    BOOST_TEST(other->warnings() == std::vector<std::string>{"to both threads"},
               boost::test_tools::per_element());
    second.reset();
    warn("to what is left");
    BOOST_TEST(other->warnings().size() == 2u);
    other.reset();
    isOver.set_value();
    holder.join();
    BOOST_TEST(ompl::msg::getOutputHandler() == before);
}

/// Each thread begins before the one before it ends, and ends after it.
BOOST_AUTO_TEST_CASE(plans_checks_and_explanations_may_overlap_in_time) {
    const testing::PlanarScene gates = testing::gatesScene();
    const testing::DoorScene door = testing::doorScene();
    const auto load = [&](const Problem& problem) {
        const ObstacleGroups obstacles = groupObstacles({door.box}, 0, problem.rules);
        return makeScene(Model::build(door.part), nullptr, obstacles, problem.rules, poseOf(problem.start),
                         poseOf(problem.goal), [](const Mesh& mesh) { return Model::build(mesh); });
    };
    constexpr int kPlanners = 4;
    std::vector<std::thread> threads;
    std::vector<int> found(kPlanners, 0);
    for (int i = 0; i < kPlanners; ++i) {
        threads.emplace_back([&, i] {
            for (int round = 0; round < 2; ++round) {
                PlanOptions options;
                options.iterations = 20000;
                options.quick = true;
                options.seed = static_cast<std::uint32_t>(i + 1);
                const PlanReport report = plan(gates.problem, gates.scene, options);
                found[i] += report.outcome == PlanReport::Outcome::kFound &&
                            checkPath(gates.problem, gates.scene, report.path).audit.isValid();
                options.iterations = 300;
                const PlanReport none = plan(door.problem, load(door.problem), options);
                found[i] += none.whyNoPath &&
                            explain(door.problem, *none.whyNoPath, {options, 0.2, load}).path.empty();
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (int i = 0; i < kPlanners; ++i) BOOST_TEST(found[i] == 4, "thread " << i);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::planning
