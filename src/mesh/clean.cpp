// Welds vertices by a hash table, finds duplicate triangles by their least vertices, and decides zero areas exactly.
// Source of the area filter: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates, 1997.
#include "mesh/clean.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

#include "core/hash.h"
#include "core/parallel.h"
#include "mesh/check.h"
#include "mesh/components.h"
#include "mesh/renumber.h"

namespace clearway {

namespace {

constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

constexpr std::size_t kItemsAtATime = 32768;

/// Equal vertices have equal hashes: adding 0 turns -0.0 into 0.0.
std::uint32_t hashOf(const Vector3& vertex) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) {
        const double coordinate = vertex[i] + 0.0;
        std::uint64_t word;
        std::memcpy(&word, &coordinate, sizeof word);
        hash = mixed(hash ^ word);
    }
    return static_cast<std::uint32_t>(hash);
}

std::vector<std::uint8_t> usedVertices(const Mesh& mesh) {
    std::vector<std::uint8_t> isUsed(mesh.vertices.size(), 0);
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) isUsed[vertex] = 1;
    }
    return isUsed;
}

/// Fills clean.vertices and returns the new number of each given vertex; kNoNumber for unused vertices.
std::vector<std::uint32_t> weld(const Mesh& mesh, CleanMesh& clean) {
    const std::size_t count = mesh.vertices.size();
    const std::vector<std::uint8_t> isUsed = usedVertices(mesh);
    // The table is addressed openly, with linear probing. A slot holds hash and number, so that a vertex is read only where the
    // hashes agree; slots to come are fetched ahead, since most of the time would be spent waiting for them.
    struct Slot {
        std::uint32_t hash;
        std::uint32_t number;
    };
    constexpr std::size_t kAhead = 24;
    std::size_t capacity = 16;
    while (capacity < 2 * count) capacity *= 2;
    const std::size_t mask = capacity - 1;
    std::vector<Slot> slots(capacity, {0, kNoNumber});
    std::vector<std::uint32_t> hashes(count), numbers(count, kNoNumber);
    forEachRun(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) hashes[i] = hashOf(mesh.vertices[i]);
    });
    clean.vertices.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
#ifdef __GNUC__
        if (i + kAhead < count) __builtin_prefetch(&slots[hashes[i + kAhead] & mask], 1);
#endif
        if (!isUsed[i]) {
            ++clean.report.unusedVertices;
            continue;
        }
        const Vector3 vertex = mesh.vertices[i] + Vector3::Zero();
        std::size_t at = hashes[i] & mask;
        const auto isOther = [&](const Slot& slot) {
            return slot.number != kNoNumber &&
                   !(slot.hash == hashes[i] && clean.vertices[slot.number] == vertex);
        };
        while (isOther(slots[at])) at = (at + 1) & mask;
        if (slots[at].number == kNoNumber) {
            slots[at] = {hashes[i], static_cast<std::uint32_t>(clean.vertices.size())};
            clean.vertices.push_back(vertex);
        } else {
            ++clean.report.weldedVertices;
        }
        numbers[i] = slots[at].number;
    }
    return numbers;
}

/// The triangle's vertices in rising order, equal for any order of the three.
TriangleIndices sorted(TriangleIndices triangle) {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
}

/// The triangles that equal an earlier one, in any order of their vertices. They are looked for among those that have the same
/// least vertex, which are few.
std::vector<std::uint32_t> findDuplicates(const std::vector<TriangleIndices>& triangles,
                                          std::size_t vertices) {
    const auto leastOf = [&](std::size_t i) {
        return std::min({triangles[i][0], triangles[i][1], triangles[i][2]});
    };
    std::vector<std::uint32_t> end(vertices + 1, 0);  // of the triangles of each least vertex, in byLeast
    for (std::size_t i = 0; i < triangles.size(); ++i) ++end[leastOf(i) + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<std::uint32_t> byLeast(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        byLeast[end[leastOf(i)]++] = static_cast<std::uint32_t>(i);

    std::vector<std::uint32_t> duplicates;
    constexpr std::size_t kFew = 32;  // beyond, comparing each with each would take long
    std::vector<std::pair<TriangleIndices, std::uint32_t>> many;
    for (std::size_t vertex = 0, first = 0; vertex < vertices; first = end[vertex++]) {
        const std::uint32_t* group = byLeast.data() + first;
        const std::size_t count = end[vertex] - first;
        if (count > kFew) {
            many.clear();
            for (std::size_t i = 0; i < count; ++i) many.emplace_back(sorted(triangles[group[i]]), group[i]);
            std::sort(many.begin(), many.end());
            for (std::size_t i = 1; i < count; ++i) {
                if (many[i].first == many[i - 1].first) duplicates.push_back(many[i].second);
            }
            continue;
        }
        std::array<TriangleIndices, kFew> keys;
        for (std::size_t i = 0; i < count; ++i) {
            keys[i] = sorted(triangles[group[i]]);
            if (std::find(keys.begin(), keys.begin() + std::ptrdiff_t(i), keys[i]) !=
                keys.begin() + std::ptrdiff_t(i))
                duplicates.push_back(group[i]);
        }
    }
    std::sort(duplicates.begin(), duplicates.end());
    return duplicates;
}

/// Keeps the first of equal triangles. Fills clean.triangleIds.
void dropDuplicates(CleanMesh& clean) {
    clean.triangleIds.resize(clean.triangles.size());
    std::iota(clean.triangleIds.begin(), clean.triangleIds.end(), 0u);
    const std::vector<std::uint32_t> duplicates = findDuplicates(clean.triangles, clean.vertices.size());
    clean.report.duplicateTriangles = duplicates.size();
    if (duplicates.empty()) return;
    std::size_t kept = 0;
    auto duplicate = duplicates.begin();
    for (std::uint32_t i = 0; i < clean.triangles.size(); ++i) {
        if (duplicate != duplicates.end() && *duplicate == i) {
            ++duplicate;
            continue;
        }
        clean.triangles[kept] = clean.triangles[i];
        clean.triangleIds[kept++] = i;
    }
    clean.triangles.resize(kept);
    clean.triangleIds.resize(kept);
}

using Rational = boost::multiprecision::cpp_rational;

/// Bound of the relative error of a difference of two products of rounded differences: (3 + 16 u64) u64 < 4 *
/// 2^-53.
constexpr double kRelativeError = 4.5e-16;

/// Whether double arithmetic proves that the projection onto the plane of axes i and j has an area. Terms
/// below the smallest normal number prove nothing.
bool hasProjectedArea(const Vector3& u, const Vector3& v, int i, int j) {
    const double left = u[i] * v[j];
    const double right = u[j] * v[i];
    const double error =
        kRelativeError * (std::fabs(left) + std::fabs(right)) + std::numeric_limits<double>::min();
    return std::fabs(left - right) > error;
}

bool isExactlyDegenerate(const Vector3& a, const Vector3& b, const Vector3& c) {
    Rational u[3];
    Rational v[3];
    for (int i = 0; i < 3; ++i) {
        u[i] = Rational(b[i]) - Rational(a[i]);
        v[i] = Rational(c[i]) - Rational(a[i]);
    }
    return u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2];
}

}  // namespace

bool isDegenerate(const Vector3& a, const Vector3& b, const Vector3& c) {
    if (a == b || b == c || c == a) return true;
    const Vector3 u = b - a;
    const Vector3 v = c - a;
    // An overflow makes the difference NaN or the error infinite; then nothing is proven.
    if (hasProjectedArea(u, v, 0, 1) || hasProjectedArea(u, v, 1, 2) || hasProjectedArea(u, v, 2, 0))
        return false;
    return isExactlyDegenerate(a, b, c);
}

CleanMesh clean(const Mesh& mesh) {
    requireSoundMesh(mesh);
    CleanMesh clean;
    const std::vector<std::uint32_t> numbers = weld(mesh, clean);
    clean.triangles.resize(mesh.triangles.size());
    forEachRun(mesh.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            for (std::size_t k = 0; k < 3; ++k) clean.triangles[i][k] = numbers[mesh.triangles[i][k]];
        }
    });
    dropDuplicates(clean);
    std::atomic<std::size_t> degenerate{0};
    forEachRun(clean.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
        degenerate += static_cast<std::size_t>(std::count_if(
            clean.triangles.begin() + std::ptrdiff_t(first), clean.triangles.begin() + std::ptrdiff_t(last),
            [&](const TriangleIndices& triangle) {
                return isDegenerate(clean.vertices[triangle[0]], clean.vertices[triangle[1]],
                                    clean.vertices[triangle[2]]);
            }));
    });
    clean.report.degenerateTriangles = degenerate;
    return clean;
}

std::vector<CleanMesh> cleanComponents(const Mesh& mesh) {
    requireSoundMesh(mesh);
    CleanMesh whole;
    const std::vector<std::uint32_t> numbers = weld(mesh, whole);
    FirstUseOrder numberInComponent(whole.vertices.size());
    std::vector<CleanMesh> cleaned;
    for (const Component& component : componentsOf(mesh)) {
        CleanMesh& clean = cleaned.emplace_back();
        clean.triangles.resize(component.triangleCount);
        numberInComponent.restart();
        for (std::size_t i = 0; i < clean.triangles.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t number = numbers[mesh.triangles[component.firstTriangle + i][k]];
                clean.triangles[i][k] = numberInComponent(
                    number, [&](std::uint32_t vertex) { clean.vertices.push_back(whole.vertices[vertex]); });
            }
        }
        dropDuplicates(clean);
    }
    return cleaned;
}

}  // namespace clearway
