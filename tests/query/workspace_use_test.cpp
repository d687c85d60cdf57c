// Builds with assertions notice two threads that use one workspace at once, whatever they ask; one thread may ask within its own
// question, and threads may take turns.
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "clearway/model.h"
#include "clearway/query.h"
#include "clearway/sweep.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"

BOOST_AUTO_TEST_SUITE(workspace_use_test)

using namespace clearway;
using namespace clearway::testing;

struct Scenery {
    Scenery() {
        Random random(1);
        const Mesh mesh = randomSoup(random, 2000, 5, 1);
        part = std::make_unique<Model>(Model::build(mesh));
        motion = piecesOf({apart, {0, 3, 0}, {0, 0, 0.3}}, *part);
    }

    /// The motion; the function is called when a query first looks at it.
    MotionPieces motionThatCalls(const std::function<void()>& interrupt) const {
        return [interrupt, motion = motion, called = std::make_shared<bool>(false)](double from, double to) {
            if (!*called) *called = true, interrupt();
            return motion(from, to);
        };
    }

    Pose apart{Matrix3::Identity(), {14, 0, 0}};
    std::unique_ptr<Model> part;
    MotionPieces motion;
};

using Ask = std::function<void(Workspace&)>;

std::vector<std::pair<std::string, Ask>> everyQuestion(const Scenery& scenery) {
    const Model& part = *scenery.part;
    return {{"distance", [&](Workspace& w) { distance(part, part, scenery.apart, {}, w); }},
            {"collides", [&](Workspace& w) { collides(part, part, scenery.apart, w); }},
            {"isWithin", [&](Workspace& w) { isWithin(part, part, scenery.apart, 4, w); }},
            {"sweep", [&](Workspace& w) { sweep(part, part, scenery.motion, {}, w); }},
            {"leastDistance", [&](Workspace& w) { leastDistance(part, part, scenery.motion, {}, w); }},
            {"forgetWarmStart", [&](Workspace& w) { w.forgetWarmStart(); }}};
}

struct Ending {
    int status = 0;
    std::string err;
};

/// How a child process ends that does the work.
Ending endOfChild(const std::function<void()>& work) {
    const TemporaryFolder folder;
    const std::string err = folder.file("err");
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        std::signal(SIGALRM, SIG_DFL);
        alarm(120);  // should the assertion not fail, the work does not end
        if (std::freopen(err.c_str(), "w", stderr) == nullptr) _exit(3);
        work();
        _exit(0);
    }
    Ending ending;
    BOOST_TEST_REQUIRE(waitpid(child, &ending.status, 0) == child);
    ending.err = readText(err);
    return ending;
}

[[maybe_unused]] void expectAssertion(const Ending& ending) {
    BOOST_TEST((WIFSIGNALED(ending.status) && WTERMSIG(ending.status) == SIGABRT));
    BOOST_TEST(ending.err.find("two threads use a workspace at once, expected one for each thread") !=
                   std::string::npos,
               ending.err);
}

void expectNone(const Ending& ending) {
    BOOST_TEST((WIFEXITED(ending.status) && WEXITSTATUS(ending.status) == 0));
    BOOST_TEST(ending.err.empty(), ending.err);
}

#ifndef NDEBUG
BOOST_AUTO_TEST_CASE(a_question_of_another_thread_during_a_sweep_fails_an_assertion) {
    const Scenery scenery;
    for (const auto& [name, ask] : everyQuestion(scenery)) {
        BOOST_TEST_CONTEXT(name) {
            for (const bool isSweep : {true, false}) {
                const Ending ending = endOfChild([&] {
                    Workspace shared;
                    const MotionPieces motion =
                        scenery.motionThatCalls([&] { std::thread([&] { ask(shared); }).join(); });
                    if (isSweep) {
                        sweep(*scenery.part, *scenery.part, motion, {}, shared);
                    } else {
                        leastDistance(*scenery.part, *scenery.part, motion, {}, shared);
                    }
                });
                expectAssertion(ending);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(two_threads_that_ask_again_and_again_fail_an_assertion) {
    const Scenery scenery;
    for (const auto& [name, ask] : everyQuestion(scenery)) {
        if (name == "forgetWarmStart") continue;  // takes no time
        BOOST_TEST_CONTEXT(name) {
            expectAssertion(endOfChild([&, ask = ask] {
                Workspace shared;
                const auto again = [&] {
                    for (;;) ask(shared);
                };
                std::thread other(again);
                again();
            }));
        }
    }
}
#endif

BOOST_AUTO_TEST_CASE(a_thread_may_ask_within_its_question_and_threads_may_take_turns) {
    const Scenery scenery;
    for (const auto& [name, ask] : everyQuestion(scenery)) {
        BOOST_TEST_CONTEXT(name) {
            expectNone(endOfChild([&, ask = ask] {
                Workspace workspace;
                for (int turn = 0; turn < 3; ++turn) std::thread([&] { ask(workspace); }).join();
                const MotionPieces motion = scenery.motionThatCalls([&] {
                    if (name == "distance") ask(workspace);
                });
                leastDistance(*scenery.part, *scenery.part, motion, {}, workspace);
                std::thread([&] { ask(workspace); }).join();
            }));
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
