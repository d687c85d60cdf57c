// A query allocates nothing once a similar query has run before.
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cerrno>
#include <cstdlib>

#include "support/each_target.h"
#include "support/query_cases.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

// The declaration from <sanitizer/allocator_interface.h>, a header that g++ 12 lacks although it has the
// function.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, std::size_t),
                                                         void (*)(const volatile void*));

namespace {

const int hooksInstalled = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++allocations; }, [](const volatile void*) {});

}  // namespace

#else

// glibc lets a program put its own functions in front of the allocator's. operator new calls them too, if the
// program shows them to libraries.
#pragma GCC visibility push(default)
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
    ++allocations;
    return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    ++allocations;
    return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
    ++allocations;
    return __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    ++allocations;
    return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment,
                   std::size_t size) {  // g++ 14's aligned operator new calls it
    ++allocations;
    *memory = __libc_memalign(alignment, size);
    return *memory == nullptr ? ENOMEM : 0;
}

}  // extern "C"
#pragma GCC visibility pop

#endif

BOOST_AUTO_TEST_SUITE(allocation_test)

using namespace clearway;
using namespace clearway::testing;

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

BOOST_AUTO_TEST_CASE(the_count_sees_every_way_to_the_heap) {
    struct alignas(64) Aligned {
        double values[8];
    };
    const auto counts = [](auto&& allocate) {
        const long before = allocations;
        allocate();
        return allocations > before;
    };
    void* volatile memory = nullptr;  // volatile keeps the compiler from removing the allocation
    BOOST_TEST(counts([&] { memory = std::malloc(100); }));
    BOOST_TEST(counts([&] { memory = std::realloc(memory, 1000000); }));
    std::free(memory);
    int* volatile number = nullptr;
    BOOST_TEST(counts([&] { number = new int(3); }));
    delete number;
    Aligned* volatile aligned = nullptr;
    BOOST_TEST(counts([&] { aligned = new Aligned; }));
    delete aligned;
    BOOST_TEST(!counts([] {}));
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

BOOST_AUTO_TEST_SUITE_END()
