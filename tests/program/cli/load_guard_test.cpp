#include "program/options/load_guard.h"

#include <fcntl.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <iostream>

#include "program/cli/run_program.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(load_guard_test)

using namespace cli;

/// Runs a guarded load of the file "a\nb.ply" in a process of its own. Returns its exit code and stderr.
Outcome guarded(const std::function<void()>& load) {
    const TemporaryFolder folder;
    std::cout.flush();  // otherwise the child prints it again
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(::open(folder.file("err").c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
        const LoadGuard guard("a\nb.ply", 1);
        load();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", readText(folder.file("err"))};
}

void requireSaid(const Outcome& outcome, const std::string& fault) {
    BOOST_TEST(outcome.code == 2);
    BOOST_TEST(holds(outcome.err, "'a b.ply'", fault, "expected"), outcome.err);
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1, outcome.err);
}

// Must not be optimised into a loop, because the stack must run out.
__attribute__((noinline)) int deeper(int level) {
    const volatile int depth = level;
    volatile char frame[256] = {};
    frame[0] = static_cast<char>(depth);
    return depth < 0 ? frame[0] : deeper(depth + 1) + frame[0];
}

BOOST_AUTO_TEST_CASE(every_crash_ends_with_code_2_and_one_line_that_names_the_file) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        BOOST_TEST_CONTEXT("signal " << signal) requireSaid(guarded([&] { std::raise(signal); }), "crashed");
    }
}

BOOST_AUTO_TEST_CASE(a_stack_that_overflows_is_a_crash_like_any_other) {
    requireSaid(guarded([] { deeper(0); }), "crashed");
}

BOOST_AUTO_TEST_CASE(reading_without_end_is_ended) {
    requireSaid(guarded([] {
                    for (volatile int i = 0;;) i = i ^ 1;
                }),
                "1 s of computing");
}

BOOST_AUTO_TEST_CASE(what_the_reader_prints_is_dropped) {
    const Outcome outcome = guarded([] { std::cerr << "note of a library\n"; });
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(outcome.err == "");
}

BOOST_AUTO_TEST_CASE(after_it_signals_streams_and_timer_are_as_before) {
    const auto handlerOf = [](int signal) {
        struct sigaction action = {};
        ::sigaction(signal, nullptr, &action);
        return action.sa_handler;
    };
    const auto before = handlerOf(SIGSEGV);
    std::streambuf* const out = std::cout.rdbuf();
    std::streambuf* const err = std::cerr.rdbuf();
    stack_t stackBefore = {}, stackAfter = {};
    ::sigaltstack(nullptr, &stackBefore);
    {
        const LoadGuard guard("a.stl", 20);
        BOOST_TEST((handlerOf(SIGSEGV) != before));
    }
    ::sigaltstack(nullptr, &stackAfter);
    BOOST_TEST((handlerOf(SIGSEGV) == before));
    BOOST_TEST((std::cout.rdbuf() == out));
    BOOST_TEST((std::cerr.rdbuf() == err));
    BOOST_TEST((stackAfter.ss_sp == stackBefore.ss_sp));
    itimerval timer = {};
    ::getitimer(ITIMER_PROF, &timer);
    BOOST_TEST(timer.it_value.tv_sec == 0);
}

BOOST_AUTO_TEST_CASE(a_file_that_makes_assimp_run_out_of_stack_is_refused_in_one_line) {
    // Brackets so deep that a parser that calls itself for each one crashes; one that counts them refuses
    // them.
    const TemporaryFolder folder;
    folder.write("deep.gltf", std::string(200000, '['));
    folder.write("a.obj", boxObj(0, 1));
    folder.write("poses", "0 0 0 0 0 0 1\n");
    requireRefused(folder, "info deep.gltf", {"cannot read mesh 'deep.gltf': ", "expected"});
    requireRefused(folder, "query --part a.obj --environment deep.gltf --poses poses --query collide",
                   {"deep.gltf': ", "expected"});
    folder.write("a.cfg",
                 "[problem]\nrobot = deep.gltf\nworld = a.obj\nstart.x = 5\nstart.y = 0\nstart.theta = 0\n"
                 "goal.x = 9\ngoal.y = 1\ngoal.theta = 3\n");
    for (const char* command : {"info a.cfg", "plan a.cfg --path a.path"}) {
        requireRefused(folder, command, {"deep.gltf': ", "expected"});
    }
}

BOOST_AUTO_TEST_CASE(large_files_are_given_more_time) {
    const TemporaryFolder folder;
    BOOST_TEST(secondsToLoad(folder.file("none")) == 20);
    BOOST_TEST(secondsToLoad(folder.write("a", std::string(1000000, ' '))) == 30);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
