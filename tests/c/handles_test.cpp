// The library for C refuses handles that stand for nothing, and threads may share what they may share.
#include <algorithm>
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <string>
#include <thread>
#include <vector>

#include "c/c_models.h"

BOOST_AUTO_TEST_SUITE(handles_test)

using namespace clearway;
using namespace clearway::testing;
using namespace clearway::testing::c;

/// Every function with one handle that is none, in each place that takes a handle.
void expectNoHandle(Boxes& boxes, clearway_handle none, const std::string& word) {
    const double* const rows = boxes.rows.data();
    const clearway_handle part = boxes.part;
    const auto expect = [&](clearway_status status, const std::string& name) {
        expectRefusal(status, CLEARWAY_INVALID_ARGUMENT, {name + " is " + word, "expected a "});
    };
    expect(clearway_distance(none, part, rows, nullptr, 0, &boxes.result), "part");
    expect(clearway_distance(part, none, rows, nullptr, 0, &boxes.result), "environment");
    expect(clearway_collides(none, part, rows, 0, &boxes.flag), "part");
    expect(clearway_collides(part, none, rows, 0, &boxes.flag), "environment");
    expect(clearway_within(none, part, rows, 1, 0, &boxes.flag), "part");
    expect(clearway_within(part, none, rows, 1, 0, &boxes.flag), "environment");
    expect(clearway_save(none, "never_written"), "model");
}

BOOST_AUTO_TEST_CASE(handles_that_are_stale_of_the_other_kind_or_zero_are_refused) {
    Boxes boxes;
    const clearway_handle workspace = newWorkspace(), stale = built(boxes.mesh), staleSpace = newWorkspace();
    BOOST_TEST(clearway_free(stale) == CLEARWAY_OK);
    BOOST_TEST(clearway_free(staleSpace) == CLEARWAY_OK);
    expectNoHandle(boxes, workspace, "a workspace");
    expectNoHandle(boxes, 0, "0");
    for (const clearway_handle none : {stale, staleSpace}) {
        expectNoHandle(boxes, none, std::to_string(none));
        expectRefusal(boxes.distance(boxes.rows.data(), nullptr, none), CLEARWAY_INVALID_ARGUMENT,
                      {"workspace is " + std::to_string(none)});
        expectRefusal(clearway_free(none), CLEARWAY_INVALID_ARGUMENT, {std::to_string(none), "freed"});
    }
    expectRefusal(boxes.collides(boxes.rows.data(), boxes.part), CLEARWAY_INVALID_ARGUMENT,
                  {"workspace is a model"});
    BOOST_TEST(clearway_free(0) == CLEARWAY_OK);
    BOOST_TEST(clearway_free(workspace) == CLEARWAY_OK);
}

BOOST_AUTO_TEST_CASE(ten_thousand_invented_handles_are_refused) {
    Boxes boxes;
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        // All bits, and small numbers as of a user who counts.
        const clearway_handle none = i % 2 ? random.bits() : clearway_handle(i / 2);
        if (none == boxes.part || none == boxes.environment) continue;
        BOOST_TEST_REQUIRE(clearway_distance(none, boxes.environment, boxes.rows.data(), nullptr, 0,
                                             &boxes.result) == CLEARWAY_INVALID_ARGUMENT);
        BOOST_TEST_REQUIRE(clearway_collides(boxes.part, none, boxes.rows.data(), 0, &boxes.flag) ==
                           CLEARWAY_INVALID_ARGUMENT);
        if (none == 0) continue;
        BOOST_TEST_REQUIRE(boxes.collides(boxes.rows.data(), none) == CLEARWAY_INVALID_ARGUMENT);
        BOOST_TEST_REQUIRE(clearway_free(none) == CLEARWAY_INVALID_ARGUMENT);
    }
    BOOST_TEST(boxes.distance(boxes.rows.data()) == CLEARWAY_OK);
}

BOOST_AUTO_TEST_CASE(handles_are_never_given_out_again) {
    Boxes boxes;
    std::vector<clearway_handle> given;
    for (int i = 0; i < 2000; ++i) {
        given.push_back(newWorkspace());
        if (i % 3) clearway_free(given.back());
    }
    std::vector<clearway_handle> sorted = given;
    std::sort(sorted.begin(), sorted.end());
    BOOST_TEST((std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()));
    for (std::size_t i = 0; i < given.size(); ++i) {
        BOOST_TEST(clearway_free(given[i]) == (i % 3 ? CLEARWAY_INVALID_ARGUMENT : CLEARWAY_OK));
    }
}

BOOST_AUTO_TEST_CASE(a_workspace_is_refused_to_other_threads) {
    Boxes boxes;
    const clearway_handle mine = newWorkspace();
    std::thread([&] {
        int flag = -1;
        BOOST_TEST(clearway_collides(boxes.part, boxes.environment, boxes.rows.data(), mine, &flag) ==
                   CLEARWAY_INVALID_ARGUMENT);
        BOOST_TEST(clearway_last_error() ==
                   std::string("the workspace belongs to another thread, expected one for each thread"));
        BOOST_TEST(flag == -1);
    }).join();
    BOOST_TEST(boxes.collides(boxes.rows.data(), mine) == CLEARWAY_OK);
    std::thread([&] { clearway_free(mine); }).join();  // giving up is not using
    BOOST_TEST(boxes.collides(boxes.rows.data(), mine) == CLEARWAY_INVALID_ARGUMENT);
}

BOOST_AUTO_TEST_CASE(each_thread_has_its_own_last_error) {
    std::thread([] {
        BOOST_TEST(clearway_last_error() == std::string());
        clearway_free(12345);
        BOOST_TEST(clearway_last_error() != std::string());
    }).join();
    clearway_load(nullptr, 1, nullptr);
    const std::string mine = clearway_last_error();
    std::thread([] { clearway_free(54321); }).join();
    BOOST_TEST(clearway_last_error() == mine);
    BOOST_TEST(clearway_free(0) == CLEARWAY_OK);
    BOOST_TEST(clearway_last_error() == mine);  // what succeeds leaves it
}

/// Threads query models and workspaces that another thread frees: an answer is right or refused.
BOOST_AUTO_TEST_CASE(freeing_what_other_threads_use_is_safe) {
    Random random(3);
    const Mesh mesh = randomSoup(random, 300, 5, 1);
    const Rows pose = rowsOf({Matrix3::Identity(), {14, 0, 0}});
    const clearway_handle environment = built(mesh);
    clearway_distance_result expected{};
    BOOST_TEST_REQUIRE(clearway_distance(environment, environment, pose.data(), nullptr, newWorkspace(),
                                         &expected) == CLEARWAY_OK);
    std::atomic<clearway_handle> part{built(mesh)};
    std::atomic<bool> isOver{false};
    std::atomic<int> answered{0}, wrong{0};
    std::vector<std::thread> threads;
    for (int k = 0; k < 3; ++k) {
        threads.emplace_back([&] {
            clearway_handle mine = 0;
            clearway_new_workspace(&mine);
            while (!isOver) {
                clearway_distance_result found{};
                const clearway_status status =
                    clearway_distance(part, environment, pose.data(), nullptr, mine, &found);
                if (status == CLEARWAY_OK) {
                    ++answered;
                    if (!(found.lower <= expected.upper && expected.lower <= found.upper)) ++wrong;
                } else if (status != CLEARWAY_INVALID_ARGUMENT) {
                    ++wrong;
                }
            }
            clearway_free(mine);
        });
    }
    for (int i = 0; i < 50 || answered < 100; ++i) {
        const clearway_handle old = part.exchange(built(mesh));
        BOOST_TEST(clearway_free(old) == CLEARWAY_OK);
    }
    isOver = true;
    for (std::thread& thread : threads) thread.join();
    BOOST_TEST(wrong == 0);
    clearway_free(part), clearway_free(environment);
}

BOOST_AUTO_TEST_SUITE_END()
