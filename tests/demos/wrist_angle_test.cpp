// The demo wrist_angle tells clearway the truth about its space: its bounds bound what OMPL's interpolation does, and are not much
// too large. The demo's own source is tested.
#define main wrist_angle_main
#include "../../demos/wrist_angle.cpp"
#undef main

#include <boost/test/unit_test.hpp>
#include <sstream>

#include "support/oracle.h"
#include "support/random_meshes.h"
#include "support/temporary_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(wrist_angle_test)

struct CarriageFixture {
    ob::ScopedState<> state(double x, double y, double yaw, double wrist) const {
        ob::ScopedState<> made(carriage.space);
        made = std::vector<double>{x, y, yaw, wrist};
        return made;
    }

    /// Near the walls; one in four pairs of angles is more than half a turn apart.
    ob::ScopedState<> randomState(Random& random) const {
        return state(random.uniform(-60, 60), random.uniform(-40, 40), random.uniform(-M_PI, M_PI),
                     random.uniform(-M_PI, M_PI));
    }

    /// Where OMPL's interpolation puts the part.
    Pose poseAt(const ob::ScopedState<>& from, const ob::ScopedState<>& to, double t) const {
        ob::ScopedState<> between(carriage.space);
        carriage.space->interpolate(from.get(), to.get(), t, between.get());
        return carriage.pose(between.get());
    }

    Mesh part = plate();
    Carriage carriage{Model::build(part)};
};

constexpr double kRounding = 1e-11;  // lengths are up to 300

BOOST_AUTO_TEST_CASE(no_point_moves_further_than_the_displacement_bound) {
    const CarriageFixture f;
    Random random(1);
    double largestShare = 0;
    for (int motion = 0; motion < 120; ++motion) {
        auto from = f.randomState(random), to = f.randomState(random);
        if (motion % 3 == 1) to[0] = from[0], to[1] = from[1], to[3] = from[3];  // the yaw alone
        if (motion % 3 == 2) to[0] = from[0], to[1] = from[1], to[2] = from[2];  // the wrist alone
        const double bound = f.carriage.bound(from.get(), to.get());
        for (int k = 0; k < 30; ++k) {
            double a = random.uniform(0, 1), b = random.uniform(0, 1);
            if (k == 0) a = 0, b = 1;
            if (k > 20) b = std::min(1.0, a + 0.01);
            const Pose first = f.poseAt(from, to, a), second = f.poseAt(from, to, b);
            for (const Vector3& vertex : f.part.vertices) {
                const double moved = (second * vertex - first * vertex).norm();
                BOOST_TEST_REQUIRE(moved <= bound * std::abs(b - a) + kRounding);
                if (k > 20) largestShare = std::max(largestShare, moved / (bound * std::abs(b - a)));
            }
        }
    }
    BOOST_TEST(largestShare > 0.9);
}

BOOST_AUTO_TEST_CASE(points_leave_straight_lines_by_no_more_than_the_deviation) {
    const CarriageFixture f;
    Random random(2);
    double largestShare = 0;
    for (int motion = 0; motion < 120; ++motion) {
        auto from = f.randomState(random), to = f.randomState(random);
        if (motion % 3 == 1) to[3] = from[3];
        if (motion % 3 == 2) to[2] = from[2];
        const PartMotion told = f.carriage.motion(from.get(), to.get());
        BOOST_TEST(told.endJump == 0);
        for (int k = 0; k < 10; ++k) {
            const double begin = random.uniform(0, 1),
                         end = random.uniform(begin, k % 2 ? 1 : std::min(1.0, begin + 0.05));
            const double middle = (begin + end) / 2, half = (end - begin) / 2;
            const MotionPiece piece = told.pieces(begin, end);
            BOOST_TEST_REQUIRE(piece.deviationAcrossRotation == 0);
            for (const double share : {-1.0, -0.4, 0.0, 0.1, 0.7, 1.0}) {
                const Pose there = f.poseAt(from, to, std::min(1.0, middle + share * half));
                for (const Vector3& vertex : f.part.vertices) {
                    const Vector3 arm = piece.middle.rotation * vertex;
                    const Vector3 speed = piece.velocity + piece.angularVelocity.cross(arm);
                    const Vector3 straight = arm + piece.middle.translation + share * half * speed;
                    const double off = (there * vertex - straight).norm();
                    BOOST_TEST_REQUIRE(off <= std::abs(share) * piece.deviation + kRounding);
                    if (piece.deviation > 1e-3) largestShare = std::max(largestShare, off / piece.deviation);
                }
            }
        }
    }
    BOOST_TEST(largestShare > 0.8);
}

BOOST_AUTO_TEST_CASE(the_demos_path_keeps_the_clearance_that_it_states) {
    const TemporaryFolder folder;
    const std::string command = CLEARWAY_DEMOS "/demo_wrist_angle > '" + folder.file("out") + "'";
    BOOST_TEST_REQUIRE(std::system(command.c_str()) == 0);
    const std::string out = readText(folder.file("out"));
    std::vector<std::vector<double>> path;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        std::vector<double> values(4);
        std::istringstream numbers(line);
        if (numbers >> values[0] >> values[1] >> values[2] >> values[3]) path.push_back(values);
    }
    BOOST_TEST_REQUIRE(path.size() >= 3u);
    BOOST_TEST(path.front()[0] == -100);
    BOOST_TEST(path.back()[0] == 120);
    const std::size_t stated = out.find("certified clearance ");
    BOOST_TEST_REQUIRE(stated != std::string::npos, out);
    const double clearance = std::stod(out.substr(stated + std::string("certified clearance ").size()));
    BOOST_TEST(clearance > 0);
    const CarriageFixture f;
    const MeshOracle oracle(f.part, walls());
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        ob::ScopedState<> from(f.carriage.space), to(f.carriage.space);
        from = path[i], to = path[i + 1];
        for (int k = 0; k <= 40; ++k) {
            // Less the printed digits: 0.005 in x and y, 5e-5 rad at up to 60 from the carriage.
            BOOST_TEST(oracle.distance(f.poseAt(from, to, k / 40.0)).distance > 0.5 + clearance - 0.015);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
