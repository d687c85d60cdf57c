#include "support/random_meshes.h"

#include <cmath>
#include <utility>

#include "clearway/obstacle_groups.h"

namespace clearway::testing {

std::uint64_t Random::bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double Random::uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

int Random::below(int end) {
    return static_cast<int>(bits() % static_cast<std::uint64_t>(end));
}

double Random::normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform(0, 1)));
    return radius * std::cos(2 * M_PI * uniform(0, 1));
}

Vector3 Random::inBox(double halfSide) {
    const double x = uniform(-halfSide, halfSide), y = uniform(-halfSide, halfSide);
    return {x, y, uniform(-halfSide, halfSide)};
}

Vector3 Random::direction() {
    const double x = normal(), y = normal();
    return Vector3(x, y, normal()).normalized();
}

Matrix3 Random::rotation() {
    const double w = normal(), x = normal(), y = normal();
    return Eigen::Quaterniond(w, x, y, normal()).normalized().toRotationMatrix();
}

Pose Random::pose(double halfSide) {
    const Matrix3 turn = rotation();
    return {turn, inBox(halfSide)};
}

Mesh randomSoup(Random& random, int triangles, double halfSide, double size) {
    Mesh mesh;
    for (int i = 0; i < triangles; ++i) {
        const Vector3 centre = random.inBox(halfSide);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int corner = 0; corner < 3; ++corner) mesh.vertices.push_back(centre + random.inBox(size));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    mesh.components.clear();
    const auto offset = static_cast<std::uint32_t>(a.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const TriangleIndices& t : b.triangles)
        mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return mesh;
}

Mesh transformed(const Mesh& mesh, const Pose& X_ab) {
    Mesh result = mesh;
    for (Vector3& vertex : result.vertices) vertex = X_ab * vertex;
    return result;
}

Mesh translated(const Mesh& mesh, const Vector3& by) {
    return transformed(mesh, {Matrix3::Identity(), by});
}

Mesh named(Mesh mesh, const std::string& name) {
    mesh.components = {{name, 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

Mesh assembled(const std::vector<Mesh>& parts) {
    Mesh all = joinedEnvironment(parts);
    for (std::size_t i = 0; i < parts.size(); ++i) all.components[i].name = parts[i].components[0].name;
    return all;
}

Mesh scaledBy(const Mesh& mesh, double factor) {
    Mesh result = mesh;
    for (Vector3& vertex : result.vertices) vertex *= factor;
    return result;
}

namespace {

// Fisher-Yates; order[i] is the item that comes to place i.
std::vector<std::uint32_t> randomOrder(Random& random, std::size_t n) {
    std::vector<std::uint32_t> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::uint32_t>(i);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<int>(i))]);
    return order;
}

}  // namespace

Mesh shuffled(Random& random, const Mesh& mesh) {
    Mesh result;
    result.vertices.resize(mesh.vertices.size());
    const std::vector<std::uint32_t> placeOf = randomOrder(random, mesh.vertices.size());
    for (std::size_t i = 0; i < placeOf.size(); ++i) result.vertices[placeOf[i]] = mesh.vertices[i];
    for (const std::uint32_t from : randomOrder(random, mesh.triangles.size())) {
        const TriangleIndices& t = mesh.triangles[from];
        const int turn = random.below(3);
        result.triangles.push_back(
            {placeOf[t[turn]], placeOf[t[(turn + 1) % 3]], placeOf[t[(turn + 2) % 3]]});
        if (random.below(2) == 1) std::swap(result.triangles.back()[0], result.triangles.back()[1]);
    }
    return result;
}

Pose poseAtGap(const Pose& X_environmentPart, const Vector3& direction, double reach, double gap,
               const std::function<double(const Pose&)>& distanceAt) {
    const auto at = [&](double way) {
        return Pose{X_environmentPart.rotation, X_environmentPart.translation + way * direction};
    };
    double near = 0, far = reach;
    for (int step = 0; step < 60; ++step) {
        const double middle = (near + far) / 2;
        (distanceAt(at(middle)) > gap ? far : near) = middle;
    }
    return at(far);
}

}  // namespace clearway::testing
