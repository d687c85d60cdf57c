// Shapes like those in CAD files: flat faces of a few long triangles beside finely tessellated roundings.
#include <array>
#include <cmath>

#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

// Joins a grid of points p(i, j), i in 0..rows, j in 0..columns, into triangles.
Mesh gridMesh(int rows, int columns, const std::function<Vector3(int, int)>& point) {
    Mesh mesh;
    for (int i = 0; i <= rows; ++i) {
        for (int j = 0; j <= columns; ++j) mesh.vertices.push_back(point(i, j));
    }
    const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(i * (columns + 1) + j); };
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
            mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    }
    return mesh;
}

Vector3 onCircle(double radius, double turns, double z) {
    return {radius * std::cos(2 * M_PI * turns), radius * std::sin(2 * M_PI * turns), z};
}

// Turns the profile's points (distance from the axis, z) about z in n steps. The profile is a closed loop.
Mesh turned(const std::vector<std::array<double, 2>>& profile, int n) {
    const int corners = static_cast<int>(profile.size());
    return gridMesh(corners, n, [&](int i, int j) {
        const std::array<double, 2>& corner = profile[i % corners];
        return onCircle(corner[0], static_cast<double>(j % n) / n, corner[1]);
    });
}

}  // namespace

Mesh randomTerrain(Random& random, int n, double size, double amplitude) {
    return gridMesh(n, n, [&](int i, int j) {
        return Vector3(size * (static_cast<double>(i) / n - 0.5), size * (static_cast<double>(j) / n - 0.5),
                       amplitude * random.uniform(-1, 1));
    });
}

Mesh box(const Vector3& halfSides, int n) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            Mesh face = gridMesh(n, n, [&](int i, int j) {
                Vector3 p;
                p[axis] = side * halfSides[axis];
                p[(axis + 1) % 3] = halfSides[(axis + 1) % 3] * (2.0 * i / n - 1);
                p[(axis + 2) % 3] = halfSides[(axis + 2) % 3] * (2.0 * j / n - 1);
                return p;
            });
            if (side < 0) {  // all faces look outwards
                for (TriangleIndices& t : face.triangles) std::swap(t[1], t[2]);
            }
            mesh = joined(mesh, face);
        }
    }
    return mesh;
}

Mesh plateWithHole(double side, double thickness, double holeRadius, int n) {
    // One skin is a fan of strips from the hole's rim to the square's border, along common rays.
    const auto skin = [&](double z) {
        return gridMesh(1, n, [&](int i, int j) -> Vector3 {
            const Vector3 onHole = onCircle(holeRadius, static_cast<double>(j % n) / n, z);
            if (i == 0) return onHole;
            const double reach = side / 2 / std::max(std::abs(onHole.x()), std::abs(onHole.y()));
            return {onHole.x() * reach, onHole.y() * reach, z};
        });
    };
    const Mesh hole = gridMesh(1, n, [&](int i, int j) {
        return onCircle(holeRadius, static_cast<double>(j % n) / n, (i - 0.5) * thickness);
    });
    return joined(joined(skin(-thickness / 2), skin(thickness / 2)), hole);
}

Mesh tube(double innerRadius, double outerRadius, double length, int n) {
    return turned({{innerRadius, -length / 2},
                   {outerRadius, -length / 2},
                   {outerRadius, length / 2},
                   {innerRadius, length / 2}},
                  n);
}

Mesh sphere(double radius, int n) {
    return gridMesh(n, 2 * n, [&](int i, int j) -> Vector3 {
        if (i == 0 || i == n) return {0, 0, i == 0 ? -radius : radius};  // the poles' triangles have no area
        const double height = M_PI * (static_cast<double>(i) / n - 0.5);
        return onCircle(radius * std::cos(height), static_cast<double>(j % (2 * n)) / (2 * n),
                        radius * std::sin(height));
    });
}

Mesh torus(double ringRadius, double pipeRadius, int n) {
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i < n; ++i) {
        const Vector3 p = onCircle(pipeRadius, static_cast<double>(i) / n, 0);
        profile.push_back({ringRadius + p.x(), p.y()});
    }
    return turned(profile, 2 * n);
}

Mesh bracket(double side, double thickness, double roundingRadius, int n) {
    const double inner = roundingRadius, outer = roundingRadius + thickness;
    // Both skins go from one plate's far edge around the rounding to the other's far edge. Each plate is one
    // quad.
    const auto skin = [&](double radius) {
        return gridMesh(n + 2, 1, [&](int i, int j) -> Vector3 {
            const double y = (j - 0.5) * side;
            if (i == 0) return {side, y, -radius};
            if (i == n + 2) return {-radius, y, side};
            const Vector3 p = onCircle(radius, 0.25 * (i - 1) / n, 0);
            return {-p.y(), y, -p.x()};
        });
    };
    return joined(skin(inner), skin(outer));
}

Mesh cadAssembly(Random& random, double size) {
    const std::array<Mesh, 6> shapes = {box({0.3 * size, 0.2 * size, 0.05 * size}, 3),
                                        plateWithHole(0.8 * size, 0.02 * size, 0.2 * size, 24),
                                        tube(0.1 * size, 0.12 * size, 0.7 * size, 24),
                                        sphere(0.2 * size, 7),
                                        torus(0.2 * size, 0.05 * size, 8),
                                        bracket(0.4 * size, 0.01 * size, 0.05 * size, 12)};
    Mesh assembly;
    for (const Mesh& shape : shapes) assembly = joined(assembly, transformed(shape, random.pose(0.8 * size)));
    return assembly;
}

std::vector<MeshPair> meshPairs(std::uint64_t seed) {
    Random random(seed);
    std::vector<MeshPair> pairs;
    const Mesh soupPart = randomSoup(random, 150, 30, 12);
    pairs.push_back({"soups", soupPart, randomSoup(random, 400, 100, 20)});
    pairs.push_back({"torus_and_terrain", torus(40, 12, 10), randomTerrain(random, 16, 300, 8)});
    pairs.push_back({"bracket_and_assembly", bracket(60, 3, 8, 16), cadAssembly(random, 200)});
    pairs.push_back({"sphere_and_plate", sphere(30, 8), plateWithHole(250, 2, 40, 48)});
    pairs.push_back({"box_and_boxes", box({40, 25, 5}, 2),
                     joined(box({100, 100, 4}, 6), translated(box({5, 90, 60}, 4), {60, 0, 64}))});
    pairs.push_back({"assemblies", cadAssembly(random, 60), cadAssembly(random, 150)});
    return pairs;
}

}  // namespace clearway::testing
