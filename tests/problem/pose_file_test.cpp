#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(pose_file_test)

using testing::TemporaryFolder;

PoseFile read(const std::string& text) {
    const TemporaryFolder folder;
    return readPoses(folder.write("poses.txt", text));
}

void requireRefused(const std::string& text, std::vector<std::string> words) {
    const TemporaryFolder folder;
    const std::string file = folder.write("poses.txt", text);
    words.front().insert(0, file + ":");
    testing::requireRefusedBy([&] { readPoses(file); }, words);
}

const std::string kIdentity = "1 0 0 0 1 0 0 0 1 7 8 9\n";

BOOST_AUTO_TEST_CASE(written_poses_read_back_to_the_same_numbers) {
    const TemporaryFolder folder;
    const Eigen::AngleAxisd turn(0.3, Vector3(1, -2, 3).normalized());
    const std::vector<Pose> poses{{Matrix3::Identity(), Vector3(0, -1e-17, 1e300)},
                                  {turn.toRotationMatrix(), Vector3(1.0 / 3, 2, -7)}};
    writePoses(poses, folder.file("out.poses"));
    const PoseFile back = readPoses(folder.file("out.poses"));
    BOOST_TEST_REQUIRE(back.poses.size() == poses.size());
    BOOST_TEST(back.projected == 0);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        BOOST_TEST((back.poses[i].rotation == poses[i].rotation));
        BOOST_TEST((back.poses[i].translation == poses[i].translation));
    }
}

BOOST_AUTO_TEST_CASE(twelve_numbers_are_a_rotation_by_rows_and_a_translation) {
    const PoseFile file = read("# poses\n\n0 -1 0  1 0 0  0 0 1   7.5 8 9\r\n");
    BOOST_TEST_REQUIRE(file.poses.size() == 1);
    BOOST_TEST(file.projected == 0);
    BOOST_TEST((file.poses[0] * Vector3(1, 0, 0) == Vector3(7.5, 9, 9)));
}

BOOST_AUTO_TEST_CASE(seven_numbers_are_a_position_and_a_quaternion_of_any_length) {
    const PoseFile file = read("7 8 9 0 0 3 3\n7 8 9 0 0 1e-200 1e-200\n");
    BOOST_TEST_REQUIRE(file.poses.size() == 2);
    BOOST_TEST(file.projected == 0);
    for (const Pose& pose : file.poses) {
        BOOST_TEST((pose * Vector3(1, 0, 0) - Vector3(7, 9, 9)).norm() <= 2e-15);
        BOOST_TEST(rotationDefect(pose) <= 1e-15);
    }
}

BOOST_AUTO_TEST_CASE(a_rotation_of_few_digits_is_projected_and_counted) {
    const PoseFile file = read(kIdentity + "0.866025 -0.5 0 0.5 0.866025 0 0 0 1 1 2 3\n");
    BOOST_TEST_REQUIRE(file.poses.size() == 2);
    BOOST_TEST(file.projected == 1);
    BOOST_TEST(rotationDefect(file.poses[1]) <= 1e-15);
    BOOST_TEST(file.poses[1].translation == Vector3(1, 2, 3));
    BOOST_TEST((file.poses[0].rotation == Matrix3::Identity()));
}

BOOST_AUTO_TEST_CASE(a_rotation_within_what_queries_accept_is_kept_to_the_bit) {
    const PoseFile file = read("1 0 0 0 1.0000000000001 0 0 0 1 0 0 0\n");
    BOOST_TEST(file.projected == 0);
    BOOST_TEST(file.poses[0].rotation(1, 1) == 1.0000000000001);
}

BOOST_AUTO_TEST_CASE(wrong_lines_are_refused_with_their_number) {
    requireRefused(kIdentity + "2 0 0 0 1 0 0 0 1 0 0 0\n", {"2:", "no rotation", "det R 2", "1e-05"});
    requireRefused("1 0 0 0 1 0 0 0 -1 0 0 0\n", {"1:", "no rotation", "det R -1", "above 0"});
    requireRefused("0 0 0 0 0 0 0 0 0 0 0 0\n", {"1:", "no rotation"});
    requireRefused(kIdentity + "7 8 9 0 0 0 0\n", {"2:", "quaternion is 0 0 0 0", "length above 0"});
    requireRefused(kIdentity + "# c\n1 0 0 0 1 0 0 0 1 7 8\n", {"3:", "11 numbers", "expected 12", "or 7"});
    requireRefused("5\n", {"1:", "1 number,", "expected 12"});
    requireRefused(kIdentity + "1 2 3 0 0 0 1 1\n", {"2:", "8 numbers", "expected 12"});
    requireRefused(kIdentity + "1,0,0\n", {"2:", "'1,0,0'", "a finite number"});
    requireRefused(kIdentity + "1 2 3 0 0 0 inf\n", {"2:", "'inf'", "a finite number"});
    requireRefused("# none\n", {" no line with numbers", "one pose a line"});
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_named) {
    const TemporaryFolder folder;
    testing::requireRefusedBy<std::runtime_error>([&] { readPoses(folder.file("x")); }, {folder.file("x")});
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
