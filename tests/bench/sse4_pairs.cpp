// PQP's tests of pairs written by hand for SSE4: four pairs in a register of floats, through a class for the
// register and one for its mask, as the thesis did with those of Embree.
#include "bench/pair_kernels.h"

#ifdef __SSE4_1__
#include <smmintrin.h>

#include <limits>

namespace clearway::testing {
namespace {

struct Mask4 {
    __m128 bits;
};
struct Float4 {
    Float4() = default;
    explicit Float4(float x) : lanes(_mm_set1_ps(x)) {}
    explicit Float4(__m128 x) : lanes(x) {}
    __m128 lanes;
};

Float4 operator+(Float4 a, Float4 b) {
    return Float4(_mm_add_ps(a.lanes, b.lanes));
}
Float4 operator-(Float4 a, Float4 b) {
    return Float4(_mm_sub_ps(a.lanes, b.lanes));
}
Float4 operator*(Float4 a, Float4 b) {
    return Float4(_mm_mul_ps(a.lanes, b.lanes));
}
Float4 operator/(Float4 a, Float4 b) {
    return Float4(_mm_div_ps(a.lanes, b.lanes));
}
Mask4 operator<(Float4 a, Float4 b) {
    return {_mm_cmplt_ps(a.lanes, b.lanes)};
}
Mask4 operator<=(Float4 a, Float4 b) {
    return {_mm_cmple_ps(a.lanes, b.lanes)};
}
Mask4 operator==(Float4 a, Float4 b) {
    return {_mm_cmpeq_ps(a.lanes, b.lanes)};
}
Mask4 both(Mask4 a, Mask4 b) {
    return {_mm_and_ps(a.bits, b.bits)};
}
Mask4 either(Mask4 a, Mask4 b) {
    return {_mm_or_ps(a.bits, b.bits)};
}
bool all(Mask4 mask) {
    return _mm_movemask_ps(mask.bits) == 15;
}
bool none(Mask4 mask) {
    return _mm_movemask_ps(mask.bits) == 0;
}
Float4 select(Mask4 isFirst, Float4 first, Float4 second) {
    return Float4(_mm_blendv_ps(second.lanes, first.lanes, isFirst.bits));
}
Float4 smaller(Float4 a, Float4 b) {
    return Float4(_mm_min_ps(a.lanes, b.lanes));
}
Float4 larger(Float4 a, Float4 b) {
    return Float4(_mm_max_ps(a.lanes, b.lanes));
}
Float4 least(Float4 a, Float4 b, Float4 c) {
    return smaller(smaller(a, b), c);
}
Float4 greatest(Float4 a, Float4 b, Float4 c) {
    return larger(larger(a, b), c);
}
/// 0 for NaN: of a number and NaN, max returns the second operand.
Float4 clampedShare(Float4 s) {
    return smaller(larger(s, Float4(0)), Float4(1));
}
Float4 root(Float4 square) {
    return Float4(_mm_sqrt_ps(square.lanes));
}

}  // namespace
}  // namespace clearway::testing

#include "bench/pqp_tests-inl.h"

namespace clearway::testing {
namespace {

constexpr int kLanes = 4;

TriangleOf<Float4> fourOf(const float* x) {
    TriangleOf<Float4> t;
    for (int k = 0; k < 3; ++k) t.corner[k] = {Float4(x[3 * k]), Float4(x[3 * k + 1]), Float4(x[3 * k + 2])};
    return t;
}

TriangleOf<Float4> fourFrom(const PairsOfCall& pairs, int first) {
    TriangleOf<Float4> t;
    const auto row = [&](int k) { return Float4(_mm_loadu_ps(pairs.rows + k * pairs.stride + first)); };
    for (int k = 0; k < 3; ++k) t.corner[k] = {row(3 * k), row(3 * k + 1), row(3 * k + 2)};
    return t;
}

void collidesInFours(const PairsOfCall& pairs, const PairAnswers& answers) {
    const TriangleOf<Float4> a = fourOf(pairs.aInFloat);
    for (int i = 0; i < pairs.count; i += kLanes) {
        const Mask4 apart = areApart(a, fourFrom(pairs, i));
        const __m128i touches = _mm_andnot_si128(_mm_castps_si128(apart.bits), _mm_set1_epi32(1));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(answers.touches + i), touches);
    }
}

void distanceInFours(const PairsOfCall& pairs, const PairAnswers& answers) {
    const TriangleOf<Float4> a = fourOf(pairs.aInFloat);
    const Float4 far(std::numeric_limits<float>::max());
    for (int i = 0; i < pairs.count; i += kLanes) {
        _mm_storeu_ps(answers.distances + i, distanceOf(a, fourFrom(pairs, i), far).lanes);
    }
}

}  // namespace

std::vector<PairContender> handWrittenContenders() {
    return {{"by hand", "PQP", "SSE4", "", collidesInFours, distanceInFours}};
}

}  // namespace clearway::testing

#else

namespace clearway::testing {

std::vector<PairContender> handWrittenContenders() {
    return {{"by hand", "PQP", "SSE4", "not built"}};
}

}  // namespace clearway::testing

#endif
