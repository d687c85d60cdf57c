#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "clearway/problem.h"
#include "support/temporary_folder.h"

namespace clearway {

BOOST_AUTO_TEST_SUITE(pose_file_test)

using testing::TemporaryFolder;

namespace {

PoseFile read(const std::string& text) {
    const TemporaryFolder folder;
    return readPoses(folder.write("poses.txt", text));
}

std::string refusalOf(const std::string& text) {
    const TemporaryFolder folder;
    const std::string file = folder.write("poses.txt", text);
    try {
        readPoses(file);
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        BOOST_TEST(message.compare(0, file.size(), file) == 0, message << " does not name " << file);
        return message.substr(file.size());
    }
    return "accepted";
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

BOOST_AUTO_TEST_CASE(rotations_that_are_none_are_refused_with_their_line) {
    BOOST_TEST(refusalOf(kIdentity + "2 0 0 0 1 0 0 0 1 0 0 0\n") ==
               ":2: the matrix is no rotation: max |R^T R - I| is 3 and det R 2, expected at most 1e-05 and "
               "above 0");
    BOOST_TEST(refusalOf("1 0 0 0 1 0 0 0 -1 0 0 0\n") ==
               ":1: the matrix is no rotation: max |R^T R - I| is inf and det R -1, expected at most 1e-05 "
               "and above 0");
    BOOST_TEST(refusalOf("0 0 0 0 0 0 0 0 0 0 0 0\n").find(":1: the matrix is no rotation") == 0);
    BOOST_TEST(refusalOf(kIdentity + "7 8 9 0 0 0 0\n") ==
               ":2: the quaternion is 0 0 0 0, expected one of length above 0");
}

BOOST_AUTO_TEST_CASE(short_long_and_wrong_lines_are_refused_with_their_line) {
    const std::string expected =
        ", expected 12 (rotation row-major, translation) or 7 (x y z qx qy qz qw, w last)";
    BOOST_TEST(refusalOf(kIdentity + "# c\n1 0 0 0 1 0 0 0 1 7 8\n") ==
               ":3: the line has 11 numbers" + expected);
    BOOST_TEST(refusalOf("5\n") == ":1: the line has 1 number" + expected);
    BOOST_TEST(refusalOf(kIdentity + "1 2 3 0 0 0 1 1\n") == ":2: the line has 8 numbers" + expected);
    BOOST_TEST(refusalOf(kIdentity + "1,0,0\n") == ":2: '1,0,0' is there, expected a finite number");
    BOOST_TEST(refusalOf("# none\n") == ": no line with numbers, expected a pose file with one pose a line");
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_named) {
    const TemporaryFolder folder;
    BOOST_CHECK_EXCEPTION(readPoses(folder.file("x")), std::runtime_error,
                          [&](const std::runtime_error& error) {
                              return std::string(error.what()).find(folder.file("x")) != std::string::npos;
                          });
}

}  // namespace
BOOST_AUTO_TEST_SUITE_END()

}  // namespace clearway
