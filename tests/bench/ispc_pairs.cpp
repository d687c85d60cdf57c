// The kernels that ispc compiled, if the build found an ispc.
#include "bench/pair_kernels.h"
#include "kernels/rounding.h"

namespace clearway::testing {

bool runsHere(const std::string& instructionSet) {
#if defined(__x86_64__)
    if (instructionSet == "SSE4") return __builtin_cpu_supports("sse4.1");
    if (instructionSet == "AVX2") return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (instructionSet == "AVX-512") {
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512vl");
    }
#endif
    return instructionSet == "scalar";
}

}  // namespace clearway::testing

#ifdef CLEARWAY_BENCH_WITH_ISPC
namespace clearway::testing {
namespace {

/// That of kernels/certificate-inl.h.
float needSquared(float apart) {
    return apart * apart * (1 + kNeedRoundoffs * float(kUnitRoundoffFloat));
}

}  // namespace
}  // namespace clearway::testing

// ispc appends an instruction set to a function's name when it compiles for several.
#define CLEARWAY_BENCH_ISPC(set)                                                                            \
    extern "C" {                                                                                            \
    void pqpCollides_##set(const float* a, const float* rows, std::int32_t stride, std::int32_t count,      \
                           std::int32_t* touches);                                                          \
    void pqpDistance_##set(const float* a, const float* rows, std::int32_t stride, std::int32_t count,      \
                           float* distances);                                                               \
    void clearwayCollides_##set(const float* a, const float* rows, std::int32_t stride, std::int32_t count, \
                                float slack, float needSquared, std::int32_t* touches);                     \
    void clearwayDistance_##set(const float* a, const float* rows, std::int32_t stride, std::int32_t count, \
                                float slack, float* distances);                                             \
    }                                                                                                       \
    namespace clearway::testing {                                                                           \
    namespace {                                                                                             \
    void pqpCollidesBy_##set(const PairsOfCall& pairs, const PairAnswers& answers) {                        \
        pqpCollides_##set(pairs.aInFloat, pairs.rows, pairs.stride, pairs.count, answers.touches);          \
    }                                                                                                       \
    void pqpDistanceBy_##set(const PairsOfCall& pairs, const PairAnswers& answers) {                        \
        pqpDistance_##set(pairs.aInFloat, pairs.rows, pairs.stride, pairs.count, answers.distances);        \
    }                                                                                                       \
    void clearwayCollidesBy_##set(const PairsOfCall& pairs, const PairAnswers& answers) {                   \
        clearwayCollides_##set(pairs.aInFloat, pairs.rows, pairs.stride, pairs.count, pairs.slack,          \
                               needSquared(pairs.slack), answers.touches);                                  \
    }                                                                                                       \
    void clearwayDistanceBy_##set(const PairsOfCall& pairs, const PairAnswers& answers) {                   \
        clearwayDistance_##set(pairs.aInFloat, pairs.rows, pairs.stride, pairs.count, pairs.slack,          \
                               answers.distances);                                                          \
    }                                                                                                       \
    }                                                                                                       \
    }

CLEARWAY_BENCH_ISPC(sse4)
CLEARWAY_BENCH_ISPC(avx2)
CLEARWAY_BENCH_ISPC(avx512skx)
#endif

namespace clearway::testing {

std::vector<PairContender> ispcContenders() {
    std::vector<PairContender> contenders;
#ifdef CLEARWAY_BENCH_WITH_ISPC
    contenders = {
        {"ISPC", "PQP", "SSE4", "", pqpCollidesBy_sse4, pqpDistanceBy_sse4},
        {"ISPC", "PQP", "AVX2", "", pqpCollidesBy_avx2, pqpDistanceBy_avx2},
        {"ISPC", "PQP", "AVX-512", "", pqpCollidesBy_avx512skx, pqpDistanceBy_avx512skx},
        {"ISPC", "clearway", "SSE4", "", clearwayCollidesBy_sse4, clearwayDistanceBy_sse4},
        {"ISPC", "clearway", "AVX2", "", clearwayCollidesBy_avx2, clearwayDistanceBy_avx2},
        {"ISPC", "clearway", "AVX-512", "", clearwayCollidesBy_avx512skx, clearwayDistanceBy_avx512skx},
    };
    for (PairContender& contender : contenders) {
        contender.leavesOpen = contender.test == "clearway";
        if (!runsHere(contender.instructionSet)) contender.missing = "not on this processor";
    }
#else
    for (const char* test : {"PQP", "clearway"}) {
        for (const char* set : {"SSE4", "AVX2", "AVX-512"}) {
            contenders.push_back({"ISPC", test, set, "not installed"});
        }
    }
#endif
    return contenders;
}

}  // namespace clearway::testing
