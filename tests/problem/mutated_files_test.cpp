#include <boost/test/unit_test.hpp>
#include <functional>
#include <random>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/byu_mesh.h"
#include "support/full_run.h"
#include "support/temporary_folder.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(mutated_files_test)

using testing::TemporaryFolder;

constexpr unsigned kSeed = 17;
const int kMutations = testing::isFullRun() ? 3000 : 600;

const std::string kProblem =
    "[problem]\nname = a\nrobot = p.stl\nworld = w.stl\nstart.x = 1\nstart.y = 2\nstart.z = 3\n"
    "start.axis.x = 0\nstart.axis.y = 0\nstart.axis.z = 1\nstart.theta = 1.5\ngoal.x = 1\ngoal.y = 2\ngoal.z "
    "= 3\n"
    "goal.axis.x = 0\ngoal.axis.y = 0\ngoal.axis.z = 1\ngoal.theta = -1e-3\nvolume.min.x = -9\nvolume.min.y "
    "= -9\n"
    "volume.min.z = -9\nvolume.max.x = 9\nvolume.max.y = 9\nvolume.max.z = 9\n[benchmark]\nrun_count = 5\n"
    "[planner]\nrrt=\nrrt.range = 5\n[clearway]\nmargin = 0.1\nstep = 2\nreading = stored\n";
const std::string kOwnKeys =
    "[problem]\nrobot = p.stl\nworld = w.stl\nstart.x = 1\nstart.y = 2\ngoal.x = 4\ngoal.y = 5\n[clearway]\n"
    "start.degrees = 30\ngoal.degrees = -400\nunit = mm\nrobot.scale = 25.4\nworld.scale = 1e-3\n"
    "fineness = 0.5\noverlap = 0.1\noverlap.w = 0.2\n";
const std::string kStates = "1 2.5 -3e2 0.1 0.2 0.3 0.9\n# x\n1 2 3 0 0 0 1\n";
const std::string kPoses = "1 0 0 0 1 0 0 0 1 7 8 9\n1 2 3 0 0 0 1\n0 -1 0 1 0 0 0 0 1 1e3 0 0\n";

const std::string kByu = "2 4 2 7\n1 1\n2 2\n0 0 0 1 0 0\n0 1 0 0 0 1.5\n1 2 -3\n1 2 3 -4\n";

/// Applies one to four edits: changes, removes or inserts a byte, or cuts off the tail.
std::string mutated(std::string text, std::mt19937_64& random) {
    const std::string likely = "0123456789.eE+-=[]# \n\r\t\0nxinf\xFF";
    for (std::uint64_t edits = 1 + random() % 4; edits > 0 && !text.empty(); --edits) {
        const std::size_t at = random() % text.size();
        const char byte = random() % 4 == 0 ? static_cast<char>(random()) : likely[random() % likely.size()];
        switch (random() % 8) {
            case 0:
                text.resize(at);
                break;
            case 1:
            case 2:
                text.erase(at, 1 + random() % 5);
                break;
            case 3:
            case 4:
                text.insert(at, 1, byte);
                break;
            default:
                text[at] = byte;
        }
    }
    return text;
}

/// Checks that the reader accepts the file or throws one of its two errors with the name of the file.
void requireTakenOrRefused(const std::string& original, const std::function<void(const std::string&)>& read) {
    BOOST_TEST_MESSAGE("seed " << kSeed);
    std::mt19937_64 random(kSeed);
    const TemporaryFolder folder;
    int taken = 0;
    int refused = 0;
    const auto judge = [&](const std::exception& error, const std::string& file) {
        ++refused;
        BOOST_TEST_REQUIRE(std::string(error.what()).find(file) != std::string::npos, error.what());
    };
    for (int i = 0; i < kMutations; ++i) {
        const std::string file = folder.write(std::to_string(i), mutated(original, random));
        try {
            read(file);
            ++taken;
        } catch (const std::invalid_argument& error) {
            judge(error, file);
        } catch (const std::runtime_error& error) {
            judge(error, file);
        }
    }
    BOOST_TEST(taken > 0);
    BOOST_TEST(refused > 0);
}

void requireFinite(const PartState& state) {
    BOOST_TEST_REQUIRE(state.position.allFinite());
    BOOST_TEST_REQUIRE(rotationDefect(poseOf(state)) <= 1e-15);
}

BOOST_AUTO_TEST_CASE(mutated_problems_are_taken_with_sound_states_or_refused) {
    for (const std::string& original : {kProblem, kOwnKeys}) {
        requireTakenOrRefused(original, [](const std::string& file) {
            const Problem problem = readProblem(file);
            requireFinite(problem.start);
            requireFinite(problem.goal);
            BOOST_TEST_REQUIRE(problem.margin >= 0);
            BOOST_TEST_REQUIRE((!problem.fineness || *problem.fineness > 0));
            BOOST_TEST_REQUIRE((!problem.volume || !problem.volume->isEmpty()));
            BOOST_TEST_REQUIRE((problem.meshes.partScale > 0 && problem.meshes.worldScale > 0));
            BOOST_TEST_REQUIRE((problem.unit.empty() || metresPerUnit(problem).has_value()));
        });
    }
}

BOOST_AUTO_TEST_CASE(mutated_paths_are_taken_with_sound_states_or_refused) {
    requireTakenOrRefused(kStates, [](const std::string& file) {
        for (const PartState& state : readPath(file, Space::kSe3)) requireFinite(state);
    });
}

BOOST_AUTO_TEST_CASE(mutated_poses_are_taken_when_queries_accept_them_or_refused) {
    requireTakenOrRefused(kPoses, [](const std::string& file) {
        for (const Pose& pose : readPoses(file).poses) requirePose(pose);
    });
}

BOOST_AUTO_TEST_CASE(mutated_byu_meshes_are_taken_with_sound_triangles_or_refused) {
    requireTakenOrRefused(kByu, [](const std::string& file) {
        const Mesh mesh = testing::readByuMesh(file);
        BOOST_TEST_REQUIRE(!mesh.triangles.empty());
        for (const TriangleIndices& triangle : mesh.triangles) {
            for (const std::uint32_t vertex : triangle) {
                BOOST_TEST_REQUIRE(vertex < mesh.vertices.size());
                BOOST_TEST_REQUIRE(mesh.vertices[vertex].allFinite());
            }
        }
    });
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
