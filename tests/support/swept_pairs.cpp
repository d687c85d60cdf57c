#include "support/swept_pairs.h"

#include <cmath>
#include <utility>

namespace clearway::testing {
namespace {

Model built(const Mesh& mesh, int nodeWidth) {
    BuildOptions options;
    options.nodeWidth = nodeWidth;
    return Model::build(mesh, options);
}

Mesh moved(const Mesh& mesh, const Vector3& by) {
    return translated(mesh, by);
}

}  // namespace

SweptPair::SweptPair(std::string theName, const Mesh& partMesh, const Mesh& environmentMesh, int nodeWidth)
    : name(std::move(theName)),
      part(built(partMesh, nodeWidth)),
      environment(built(environmentMesh, nodeWidth)),
      size(part.box().diagonal().norm() + environment.box().diagonal().norm()) {}

Pose poseAt(const RigidMotion& motion, double time) {
    const double angle = motion.rotation.norm();
    const Matrix3 turned = angle > 0
                               ? Eigen::AngleAxisd(time * angle, motion.rotation / angle).toRotationMatrix()
                               : Matrix3::Identity();
    return {motion.start.rotation * turned, motion.start.translation + time * motion.translation};
}

Mesh stretchedSoup(Random& random, int count) {
    Mesh mesh = randomSoup(random, count, 1, 1);
    for (Vector3& vertex : mesh.vertices) vertex.x() *= 1e3;
    return mesh;
}

std::vector<SweptPair> sweptPairs(int nodeWidth) {
    std::vector<SweptPair> pairs;
    for (const MeshPair& pair : meshPairs(7))
        pairs.emplace_back(pair.name, pair.part, pair.environment, nodeWidth);
    Random random(3);
    pairs.emplace_back("needles", stretchedSoup(random, 40), stretchedSoup(random, 60), nodeWidth);
    const Vector3 far(3e5, -2e5, 1e5);
    pairs.emplace_back("far from the origin", box({1, 2, 3}, 3), moved(plateWithHole(20, 1, 6, 24), far),
                       nodeWidth);
    pairs.back().centre = far;
    pairs.emplace_back("part far from its origin", moved(box({1, 2, 3}, 3), far), plateWithHole(20, 1, 6, 24),
                       nodeWidth);
    pairs.back().centre = -far;
    return pairs;
}

RigidMotion randomMotion(Random& random, const SweptPair& pair) {
    RigidMotion motion;
    motion.start = random.pose(0.4 * pair.size);
    if (pair.centre.x() < 0) motion.start.rotation.setIdentity();  // any other would swing the part away
    motion.start.translation += pair.centre;
    motion.translation =
        random.direction() * pair.size * std::pow(10, random.uniform(-3, 0)) * (random.below(4) > 0);
    motion.rotation = random.direction() * std::pow(10, random.uniform(-4, 0.49)) * (random.below(4) > 0);
    return motion;
}

SweepOptions optionsFor(const SweptPair& pair, double margin) {
    SweepOptions options;
    options.margin = margin;
    options.leastInterval = 1e-5 * pair.size;
    options.poseError = 1e-13 * (pair.size + pair.centre.norm());
    return options;
}

RigidMotion rolling(double gap) {
    const Matrix3 lying =
        Eigen::AngleAxisd(M_PI / 2, Vector3::UnitX()).toRotationMatrix();  // its z points to -y
    return {{lying, {-15, 0, 1 + 3 + gap}}, {3 * 8.0, 0, 0}, Vector3(0, 0, -8)};
}

}  // namespace clearway::testing
