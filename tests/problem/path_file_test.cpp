#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(path_file_test)

using testing::readText;
using testing::TemporaryFolder;

BOOST_AUTO_TEST_CASE(a_written_path_reads_back_to_rounding_and_says_17_digits) {
    constexpr unsigned kSeed = 3;
    BOOST_TEST_MESSAGE("seed " << kSeed);
    std::mt19937_64 random(kSeed);
    std::normal_distribution<double> normal;
    std::vector<PartState> path;
    for (int i = 0; i < 200; ++i) {
        PartState state{Vector3(normal(random), 1e3 * normal(random), normal(random)), {}};
        state.rotation.coeffs() << normal(random), normal(random), normal(random), normal(random);
        state.rotation.normalize();
        path.push_back(state);
    }
    const TemporaryFolder folder;
    writePath(path, Space::kSe3, folder.file("a.path"));
    const std::vector<PartState> back = readPath(folder.file("a.path"), Space::kSe3);
    BOOST_TEST_REQUIRE(back.size() == path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        BOOST_TEST(back[i].position == path[i].position);
        BOOST_TEST((back[i].rotation.coeffs() - path[i].rotation.coeffs()).norm() <= 4e-16);
    }
    writePath({{Vector3(0.1, 0, 0), {1, 0, 0, 0}}}, Space::kSe3, folder.file("a.path"));
    BOOST_TEST(readText(folder.file("a.path")) == "0.10000000000000001 0 0 0 0 0 1\n");
    BOOST_TEST(folder.names().size() == 1);
}

BOOST_AUTO_TEST_CASE(planar_paths_hold_x_y_and_yaw) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.path", "34.81 -75.0 0.0\n\n41 -81 3.14159265358979\n");
    const std::vector<PartState> path = readPath(file, Space::kSe2);
    BOOST_TEST_REQUIRE(path.size() == 2);
    BOOST_TEST(path[1].position == Vector3(41, -81, 0));
    BOOST_TEST((poseOf(path[1]).rotation * Vector3::UnitX() + Vector3::UnitX()).norm() < 1e-14);
    writePath(path, Space::kSe2, file);
    BOOST_TEST(readText(file).compare(0, 24, "34.810000000000002 -75 0") == 0);
    BOOST_TEST((readPath(file, Space::kSe2)[1].rotation.coeffs() - path[1].rotation.coeffs()).norm() < 1e-15);
}

BOOST_AUTO_TEST_CASE(quaternions_of_six_digits_are_normalised) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("a.path", "268.039 160.556 -206.867 -0.028388 0.0453411 0.0497153 0.99733\n");
    const PartState state = readPath(file, Space::kSe3)[0];
    BOOST_TEST(std::abs(state.rotation.norm() - 1) <= 3e-16);
    BOOST_TEST(rotationDefect(poseOf(state)) <= 1e-15);
}

BOOST_AUTO_TEST_CASE(wrong_lines_are_named) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& text, Space space, const std::vector<std::string>& words) {
        const std::string file = folder.write("a.path", text);
        testing::requireRefusedBy([&] { readPath(file, space); }, words);
    };
    const std::string good = "1 2 3 0 0 0 1\n";
    refused(good + "# comment\n1 2 3 0 0 0\n", Space::kSe3,
            {"a.path:3:", "6 numbers", "7: x y z qx qy qz qw"});
    refused(good, Space::kSe2, {"a.path:1:", "7 numbers", "3: x y yaw"});
    refused(good + "1 2 3 0 0 0 0\n", Space::kSe3, {"a.path:2:", "0 0 0 0", "length above 0"});
    for (const std::string word : {"x", "nan"})
        refused(good + "1 2 " + word + " 0 0 0 1\n", Space::kSe3, {"a.path:2:", "'" + word + "'", "finite"});
    refused("\n# nothing\n", Space::kSe3, {"a.path:", "no line with numbers"});
}

BOOST_AUTO_TEST_CASE(a_path_that_cannot_be_written_leaves_nothing) {
    const TemporaryFolder folder;
    BOOST_CHECK_THROW(writePath({PartState{}}, Space::kSe3, folder.file("none/a.path")), std::runtime_error);
    BOOST_TEST(folder.names().empty());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
