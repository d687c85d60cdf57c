// Work is shared among threads, but not in a forked process.
#include "core/parallel.h"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <numeric>
#include <vector>

namespace clearway {
namespace {

/// The sum that the three ways of sharing work add up.
std::size_t sumOfWork() {
    std::vector<std::size_t> done(1000, 0);
    onThreads(2, [&] {
        forEachInParallel(done.size(), [&](std::size_t i) { done[i] += i; });
        std::size_t left = 0, right = 0;
        invokeBoth([&] { left = 7; }, [&] { right = 8; });
        done[0] = left + right;
        return 0;
    });
    return std::accumulate(done.begin(), done.end(), std::size_t(0));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(parallel_test)

BOOST_AUTO_TEST_CASE(a_process_forked_from_one_that_shared_work_works_alone) {
    BOOST_TEST_REQUIRE(mayShareWork());
    BOOST_TEST(sumOfWork() == 999 * 1000 / 2 + 15);
    const pid_t child = fork();
    if (child == 0) {
        const pid_t grandchild = fork();
        int status = -1;
        if (grandchild != 0 && (waitpid(grandchild, &status, 0) != grandchild || status != 0)) _exit(2);
        _exit(!mayShareWork() && sumOfWork() == 999 * 1000 / 2 + 15 ? 0 : 1);
    }
    int status = -1;
    BOOST_TEST_REQUIRE(waitpid(child, &status, 0) == child);
    BOOST_TEST(status == 0);
    BOOST_TEST(mayShareWork());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
