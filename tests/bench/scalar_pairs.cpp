// The tests of pairs in scalar double: our own, and PQP's functions if the build has a checkout of PQP.
#include <cmath>
#include <limits>

#include "bench/pair_kernels.h"

#ifdef CLEARWAY_BENCH_WITH_PQP
#include <TriDist.h>

// PQP's test of a pair, which no header of PQP declares.
int TriContact(PQP_REAL* p1, PQP_REAL* p2, PQP_REAL* p3, PQP_REAL* q1, PQP_REAL* q2, PQP_REAL* q3);
#endif

namespace clearway::testing {
namespace {

// The names that pqp_tests-inl.h needs of a number.
double smaller(double a, double b) {
    return a < b ? a : b;
}
double larger(double a, double b) {
    return a < b ? b : a;
}
double least(double a, double b, double c) {
    return smaller(smaller(a, b), c);
}
double greatest(double a, double b, double c) {
    return larger(larger(a, b), c);
}
double select(bool isFirst, double first, double second) {
    return isFirst ? first : second;
}
/// 0 for NaN.
double clampedShare(double s) {
    return s > 0 ? smaller(s, 1) : 0;
}
double root(double square) {
    return std::sqrt(square);
}
bool both(bool a, bool b) {
    return a && b;
}
bool either(bool a, bool b) {
    return a || b;
}
bool all(bool is) {
    return is;
}
bool none(bool is) {
    return !is;
}

}  // namespace
}  // namespace clearway::testing

#include "bench/pqp_tests-inl.h"

namespace clearway::testing {
namespace {

TriangleOf<double> triangleFrom(const double* x) {
    return {{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}}};
}

void collidesInDouble(const PairsOfCall& pairs, const PairAnswers& answers) {
    const TriangleOf<double> a = triangleFrom(pairs.a);
    for (int i = 0; i < pairs.count; ++i) {
        answers.touches[i] = !areApart(a, triangleFrom(pairs.b + 9 * i));
    }
}

void distanceInDouble(const PairsOfCall& pairs, const PairAnswers& answers) {
    const TriangleOf<double> a = triangleFrom(pairs.a);
    for (int i = 0; i < pairs.count; ++i) {
        answers.distancesInDouble[i] =
            distanceOf(a, triangleFrom(pairs.b + 9 * i), std::numeric_limits<double>::max());
    }
}

#ifdef CLEARWAY_BENCH_WITH_PQP
void collidesByPqp(const PairsOfCall& pairs, const PairAnswers& answers) {
    double* a = const_cast<double*>(pairs.a);  // PQP writes to none of these
    for (int i = 0; i < pairs.count; ++i) {
        double* b = const_cast<double*>(pairs.b) + 9 * i;
        answers.touches[i] = TriContact(a, a + 3, a + 6, b, b + 3, b + 6);
    }
}

void distanceByPqp(const PairsOfCall& pairs, const PairAnswers& answers) {
    const auto corners = [](const double* x) { return reinterpret_cast<const double(*)[3]>(x); };
    double p[3], q[3];
    for (int i = 0; i < pairs.count; ++i) {
        answers.distancesInDouble[i] = TriDist(p, q, corners(pairs.a), corners(pairs.b + 9 * i));
    }
}
#endif

}  // namespace

void collidesOfOpenPairs(const PairsOfCall& pairs, const PairAnswers& answers) {
    const TriangleOf<double> a = triangleFrom(pairs.a);
    for (int i = 0; i < pairs.count; ++i) {
        if (answers.touches[i] != 0) answers.touches[i] = !areApart(a, triangleFrom(pairs.b + 9 * i));
    }
}

void distanceOfOpenPairs(const PairsOfCall& pairs, const PairAnswers& answers) {
    const TriangleOf<double> a = triangleFrom(pairs.a);
    for (int i = 0; i < pairs.count; ++i) {
        if (answers.distances[i] != 0) continue;
        answers.distances[i] = static_cast<float>(
            distanceOf(a, triangleFrom(pairs.b + 9 * i), std::numeric_limits<double>::max()));
    }
}

std::vector<PairContender> scalarContenders() {
    PairContender pqp = {"PQP itself", "PQP", "scalar", "not built", nullptr, nullptr, true};
#ifdef CLEARWAY_BENCH_WITH_PQP
    pqp.missing = "";
    pqp.collides = collidesByPqp;
    pqp.distance = distanceByPqp;
#endif
    return {{"scalar double", "PQP", "scalar", "", collidesInDouble, distanceInDouble, true}, pqp};
}

}  // namespace clearway::testing
