// Welds vertices and finds duplicate triangles with one kind of hash table; decides zero areas exactly.
// Source of the area filter: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates, 1997.
#include "mesh/clean.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

#include "core/hash.h"
#include "mesh/check.h"

namespace clearway {

namespace {

constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

/// Finds the first of equal items, by open addressing with linear probing. The caller keeps the items and
/// numbers them 0, 1, 2, ...
class FirstOfEqual {
  public:
    explicit FirstOfEqual(std::size_t items) {
        std::size_t capacity = 16;
        while (capacity < 2 * items) capacity *= 2;
        slots_.assign(capacity, kNoNumber);
    }

    /// The number of an equal earlier item, or else newNumber, which the new item gets.
    template <typename IsEqual>
    std::uint32_t findOrInsert(std::uint64_t hash, std::uint32_t newNumber, IsEqual isEqual) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == kNoNumber) return slots_[slot] = newNumber;
            if (isEqual(slots_[slot])) return slots_[slot];
        }
    }

  private:
    std::vector<std::uint32_t> slots_;
};

std::uint64_t hashOf(const Vector3& vertex) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) {
        std::uint64_t word;
        std::memcpy(&word, vertex.data() + i, sizeof word);
        hash = mixed(hash ^ word);
    }
    return hash;
}

std::vector<bool> usedVertices(const Mesh& mesh) {
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const TriangleIndices& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) used[vertex] = true;
    }
    return used;
}

/// Fills clean.vertices and returns the new number of each given vertex; kNoNumber for unused vertices.
std::vector<std::uint32_t> weld(const Mesh& mesh, CleanMesh& clean) {
    const std::vector<bool> used = usedVertices(mesh);
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), kNoNumber);
    FirstOfEqual table(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (!used[i]) {
            ++clean.report.unusedVertices;
            continue;
        }
        const Vector3 vertex = mesh.vertices[i] + Vector3::Zero();  // turns -0.0 into 0.0
        const auto newNumber = static_cast<std::uint32_t>(clean.vertices.size());
        numbers[i] = table.findOrInsert(hashOf(vertex), newNumber, [&](std::uint32_t number) {
            return clean.vertices[number] == vertex;
        });
        if (numbers[i] == newNumber) {
            clean.vertices.push_back(vertex);
        } else {
            ++clean.report.weldedVertices;
        }
    }
    return numbers;
}

/// The triangle's vertices in rising order, equal for any order of the three.
TriangleIndices sorted(TriangleIndices triangle) {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
}

void keepFirstTriangles(const Mesh& mesh, const std::vector<std::uint32_t>& numbers, CleanMesh& clean) {
    clean.triangles.reserve(mesh.triangles.size());
    clean.triangleIds.reserve(mesh.triangles.size());
    FirstOfEqual table(mesh.triangles.size());
    for (std::size_t id = 0; id < mesh.triangles.size(); ++id) {
        TriangleIndices triangle;
        for (int i = 0; i < 3; ++i) triangle[i] = numbers[mesh.triangles[id][i]];
        const TriangleIndices key = sorted(triangle);
        const auto newNumber = static_cast<std::uint32_t>(clean.triangles.size());
        const std::uint64_t hash = mixed(mixed(mixed(key[0]) ^ key[1]) ^ key[2]);
        const std::uint32_t number = table.findOrInsert(
            hash, newNumber, [&](std::uint32_t kept) { return sorted(clean.triangles[kept]) == key; });
        if (number != newNumber) {
            ++clean.report.duplicateTriangles;
            continue;
        }
        clean.triangles.push_back(triangle);
        clean.triangleIds.push_back(static_cast<std::uint32_t>(id));
    }
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
    keepFirstTriangles(mesh, weld(mesh, clean), clean);
    for (const TriangleIndices& triangle : clean.triangles) {
        if (isDegenerate(clean.vertices[triangle[0]], clean.vertices[triangle[1]],
                         clean.vertices[triangle[2]])) {
            ++clean.report.degenerateTriangles;
        }
    }
    return clean;
}

}  // namespace clearway
