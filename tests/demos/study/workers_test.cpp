#include "demos/study/workers.h"

#include <sched.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(workers_test)

using namespace study;

void ignore(const std::string& /*text*/) {}

/// Shares jobs out and returns what they kept.
struct Shared {
    std::multiset<std::string> kept;
    int ended = 0;
    bool isComplete = false;
};

Shared share(Workers& workers, const std::vector<std::string>& jobs) {
    Shared shared;
    shared.isComplete = workers.share(
        jobs, [&](const std::string& text) { shared.kept.insert(text); }, ignore, [&] { ++shared.ended; },
        {});
    return shared;
}

BOOST_AUTO_TEST_CASE(each_job_is_done_once_by_a_process_with_a_processor_of_its_own) {
    Workers workers(0, [](const Job& job) {
        cpu_set_t set;
        sched_getaffinity(0, sizeof set, &set);
        job.keep(job.text + " on " + std::to_string(CPU_COUNT(&set)));
        job.keep("line\nwith an end");
        return true;
    });
    BOOST_TEST(workers.count() >= 1u);
    std::vector<std::string> jobs;
    for (int i = 0; i < 50; ++i) jobs.push_back("job " + std::to_string(i));
    for (int round = 0; round < 2; ++round) {
        const Shared shared = share(workers, jobs);
        BOOST_TEST(shared.isComplete);
        BOOST_TEST(shared.ended == 50);
        BOOST_TEST(shared.kept.count("line with an end") == 50u);
        for (const std::string& job : jobs) BOOST_TEST(shared.kept.count(job + " on 1") == 1u);
    }
    BOOST_TEST(share(workers, {}).isComplete);
}

BOOST_AUTO_TEST_CASE(a_job_that_throws_or_kills_its_process_is_told) {
    const auto jobs = [](const Job& job) -> bool {
        if (job.text == "throw") throw std::runtime_error("no such tree");
        if (job.text == "die") _exit(3);
        job.keep(job.text);
        return true;
    };
    Workers workers(2, jobs);
    requireRefusedBy<std::runtime_error>([&] { share(workers, {"a", "throw"}); }, {"no such tree"});
    BOOST_TEST(share(workers, {"a", "b"}).kept.size() == 2u);
    requireRefusedBy<std::runtime_error>(
        [&] {
            share(workers, {"a", "die"});
        },
        {"died during the job 'die'"});
}

BOOST_AUTO_TEST_CASE(what_was_kept_before_a_stop_is_taken) {
    Workers workers(1, [](const Job& job) {
        job.keep("begun");
        while (!job.isStopped()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        job.keep("ending");
        return false;
    });
    std::multiset<std::string> kept;
    const bool isComplete = workers.share(
        {"first", "second"}, [&](const std::string& text) { kept.insert(text); }, ignore, [] {},
        [&] { return kept.count("begun") == 1; });
    BOOST_TEST(!isComplete);
    BOOST_TEST(kept.size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
