// Sweeps never certify a time at which the part is within the margin, and find contact only where it is: judged at many poses
// of random motions, on every instruction set and node width.
#include "clearway/sweep.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "clearway/model.h"
#include "support/each_target.h"
#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

Pose poseAt(const RigidMotion& motion, double time) {
    const double angle = motion.turn.norm();
    const Matrix3 turned = angle > 0 ? Eigen::AngleAxisd(time * angle, motion.turn / angle).toRotationMatrix()
                                     : Matrix3::Identity();
    return {motion.start.rotation * turned, motion.start.translation + time * motion.translation};
}

double sizeOf(const Mesh& mesh) {
    Box box;
    for (const Vector3& vertex : mesh.vertices) box.extend(vertex);
    return box.diagonal().norm();
}

struct SweptPair {
    std::string name;
    Model part, environment;
    double size;
};

std::vector<SweptPair> sweptPairs(int nodeWidth) {
    BuildOptions options;
    options.nodeWidth = nodeWidth;
    std::vector<SweptPair> pairs;
    for (const MeshPair& pair : meshPairs(7)) {
        pairs.push_back({pair.name, Model::build(pair.part, options), Model::build(pair.environment, options),
                         sizeOf(pair.part) + sizeOf(pair.environment)});
    }
    return pairs;
}

RigidMotion randomMotion(Random& random, double size) {
    RigidMotion motion;
    motion.start = random.pose(0.4 * size);
    motion.translation = random.direction() * size * std::pow(10, random.uniform(-3, 0)) * (random.below(4) > 0);
    motion.turn = random.direction() * std::pow(10, random.uniform(-4, 0.4)) * (random.below(4) > 0);
    return motion;
}

struct Tally {
    int certified = 0, contact = 0, undecided = 0;
};

void judge(const SweptPair& pair, Random& random, int samples, Workspace& workspace, Tally& tally) {
    const RigidMotion motion = randomMotion(random, pair.size);
    const MotionPieces pieces = piecesOf(motion, pair.part);
    SweepOptions options;
    options.margin = random.below(2) * pair.size * std::pow(10, random.uniform(-4, -1));
    options.leastInterval = 1e-5 * pair.size;
    options.poseError = 1e-12 * pair.size;
    const auto isWithinAt = [&](double time) {
        return isWithin(pair.part, pair.environment, poseAt(motion, time), options.margin, workspace);
    };
    const SweepResult whole = sweep(pair.part, pair.environment, pieces, options, workspace);
    options.isForward = true;
    const SweepResult forward = sweep(pair.part, pair.environment, pieces, options, workspace);
    const double certified = std::max(whole.certifiedUntil, forward.certifiedUntil);
    for (int i = 0; i <= samples && certified > 0; ++i) {
        BOOST_TEST(!isWithinAt(certified * i / samples), "within at " << certified * i / samples << " of " << certified);
    }
    for (const SweepResult& found : {whole, forward}) {
        if (found.verdict != SweepVerdict::kContact) continue;
        BOOST_TEST(isWithinAt(found.contactTime));
        BOOST_TEST(found.certifiedUntil <= found.contactTime);
    }
    ++(whole.verdict == SweepVerdict::kCertified ? tally.certified
       : whole.verdict == SweepVerdict::kContact ? tally.contact
                                                 : tally.undecided);
}

BOOST_DATA_TEST_CASE(no_certified_time_is_within_the_margin, eachTarget() * eachWidth(), target, width) {
    const UsingTarget using_(target);
    Workspace workspace;
    Tally tally;
    for (const SweptPair& pair : sweptPairs(width)) {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            BOOST_TEST_CONTEXT(pair.name << ", seed " << seed) {
                Random random(seed);
                judge(pair, random, 100, workspace, tally);
            }
        }
    }
    BOOST_TEST_MESSAGE(tally.certified << " certified, " << tally.contact << " in contact, " << tally.undecided
                                       << " undecided");
    BOOST_TEST(tally.certified > 50);
    BOOST_TEST(tally.contact > 50);
}

}  // namespace
}  // namespace clearway::testing
