#include "problem/start_remedies.h"

#include <boost/test/unit_test.hpp>

#include "clearway/planning/plan.h"
#include "support/door_scene.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(invalid_start_test)

/// The part of the door's scene, moved into the corner of floor and door; the scene was read from no file.
struct Corner {
    testing::DoorScene door = testing::doorScene();
    Scene scene{Model::build(door.part), Model::build(door.box)};

    Corner() { door.problem.start.position += Vector3(3, 0, -3); }
};

BOOST_AUTO_TEST_CASE(each_touched_obstacle_is_named_from_what_is_loaded) {
    Corner corner;
    const std::vector<std::string> names = touchedObstacles(corner.scene, poseOf(corner.door.problem.start));
    BOOST_TEST(names == (std::vector<std::string>{"floor", "door"}), boost::test_tools::per_element());
    BOOST_TEST(touchedObstacles(corner.scene, Pose()).empty());
    corner.scene.obstacles[0].margin = 2.5;  // each wall is 2 from the part in the middle
    BOOST_TEST(touchedObstacles(corner.scene, Pose()).size() == 6u);
    corner.scene.obstacles[0].isIgnoredAtStart = true;
    BOOST_TEST(touchedObstacles(corner.scene, Pose()).empty());
}

BOOST_AUTO_TEST_CASE(a_start_in_collision_is_refused_with_every_obstacle_and_the_length_of_its_contact) {
    const Corner corner;
    try {
        planning::plan(corner.door.problem, corner.scene, {});
        BOOST_ERROR("the start is accepted");
    } catch (const planning::InvalidStart& error) {
        BOOST_TEST(error.mayOverlap);
        for (const char* words : {"contact.start = floor, door, 0.139", "ignore = floor, door"})
            BOOST_TEST(std::string(error.what()).find(words) != std::string::npos, error.what());
        BOOST_TEST(std::string(error.what()).find("--lift") == std::string::npos, error.what());
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
