// A query that has met its like before takes nothing from the heap.
#define BOOST_TEST_MODULE query_allocation
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <new>

#include "support/each_target.h"
#include "support/query_cases.h"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
    ++allocations;
    size = (size + alignment - 1) / alignment * alignment;
    if (void* memory = std::aligned_alloc(alignment, size == 0 ? alignment : size)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size) {
    return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

using namespace clearway;
using namespace clearway::testing;

namespace {

void askAll(const ModelPair& models, const QueryCase& queryCase, Workspace& workspace) {
    DistanceOptions loose;
    loose.relativeError = 0.05;
    for (std::size_t i = 0; i < queryCase.poses.size(); ++i) {
        const Pose& pose = queryCase.poses[i];
        workspace.forgetWarmStart();
        distance(models.part, models.environment, pose, {}, workspace);
        distance(models.part, models.environment, pose, loose, workspace);
        collides(models.part, models.environment, pose, workspace);
        isWithin(models.part, models.environment, pose, 0.9 * queryCase.answers[i].distance, workspace);
        isWithin(models.part, models.environment, pose, 1.1 * queryCase.answers[i].distance, workspace);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_count_counts) {
    const long before = allocations;
    delete new int(3);
    std::vector<double> values(100, 1.0);
    BOOST_TEST(values.back() == 1.0);
    BOOST_TEST(allocations - before >= 1);
}

BOOST_DATA_TEST_CASE(a_warmed_query_allocates_nothing, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    BuildOptions options;
    options.nodeWidth = width;
    for (const QueryCase& queryCase : queryCases()) {
        const ModelPair models = buildPair(queryCase, options);
        Workspace workspace;
        askAll(models, queryCase, workspace);
        const long before = allocations;
        askAll(models, queryCase, workspace);
        const long made = allocations - before;
        BOOST_TEST(made == 0, queryCase.name << ": " << made << " allocations");
    }
}
