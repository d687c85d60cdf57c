// Kernels that test pairs of triangles: one triangle against the next few of a set, in one call. Every
// contender of `benchmarks kernels` answers both questions through this interface.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clearway::testing {

/// The pairs of one call. Both forms of a set hold equal numbers: every coordinate is a float.
struct PairsOfCall {
    const double* a = nullptr;        ///< 9 numbers: x, y, z of each corner
    const float* aInFloat = nullptr;  ///< these in float
    const double* b = nullptr;        ///< 9 numbers a triangle
    const float* rows = nullptr;      ///< 9 rows of floats, a row a coordinate of all triangles
    int stride = 0;   ///< from row to row; kPadding floats behind a row's last triangle are readable
    int count = 0;    ///< of triangles b
    float slack = 0;  ///< rounding of clearway's bounds for triangles of these sets
};

constexpr int kPadding = 16;  ///< a kernel may read and write that many entries past its last pair

/// A kernel writes what its question asks for. Distances of kernels in double are in double.
struct PairAnswers {
    std::int32_t* touches = nullptr;  ///< 1 if the pair is not found to be apart, else 0
    float* distances = nullptr;       ///< 0 if the pair is not found to be apart
    double* distancesInDouble = nullptr;
};

using PairKernel = void (*)(const PairsOfCall& pairs, const PairAnswers& answers);

/// One row of the table: a kernel for each question, or the reason why there is none.
struct PairContender {
    std::string name;            ///< "SSE4 by hand", "ISPC", ...
    std::string test;            ///< whose test of a pair: "PQP" or "clearway"
    std::string instructionSet;  ///< "scalar", "SSE4", "AVX2" or "AVX-512"
    std::string missing;         ///< why the kernels do not run here; empty if they do
    PairKernel collides = nullptr;
    PairKernel distance = nullptr;
    bool isInDouble = false;
    /// Pairs that are not found to be apart may still be so: double is to decide them.
    bool leavesOpen = false;
};

/// Decides in scalar double the pairs that other kernels did not find to be apart.
void collidesOfOpenPairs(const PairsOfCall& pairs, const PairAnswers& answers);
void distanceOfOpenPairs(const PairsOfCall& pairs, const PairAnswers& answers);

/// Our own scalar double, and PQP's functions if the build knows PQP.
std::vector<PairContender> scalarContenders();
std::vector<PairContender> handWrittenContenders();
std::vector<PairContender> clearwayContenders();
std::vector<PairContender> ispcContenders();

/// Whether this processor runs an instruction set of PairContender.
bool runsHere(const std::string& instructionSet);

}  // namespace clearway::testing
