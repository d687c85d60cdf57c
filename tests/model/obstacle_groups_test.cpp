// Obstacles by name: the meshes that rules stand for, how they are grouped, and the refusals.
#include "clearway/obstacle_groups.h"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "clearway/errors.h"
#include "support/random_meshes.h"
#include "support/winding.h"
#include "support/words.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(obstacle_groups_test)

Mesh file(const std::string& name, const std::vector<std::string>& components) {
    std::vector<Mesh> boxes;
    for (const std::string& component : components) {
        const Vector3 place(10.0 * static_cast<double>(boxes.size()), 0, 0);
        boxes.push_back(named(translated(box({1, 1, 1}), place), component));
    }
    Mesh all = assembled(boxes);
    all.origin.file = "/somewhere/" + name;
    return all;
}

std::string refusal(const std::vector<Mesh>& files, const ObstacleRules& rules) {
    return refusalBy([&] { groupObstacles(files, 1, rules); });
}

std::vector<std::string> namesOf(const ObstacleGroup& group) {
    std::vector<std::string> names;
    for (const Component& component : group.mesh.components) names.push_back(component.name);
    return names;
}

/// The group that holds the component.
const ObstacleGroup& groupOf(const ObstacleGroups& groups, const std::string& name) {
    for (const ObstacleGroup& group : groups.groups) {
        for (const std::string& member : namesOf(group)) {
            if (member == name) return group;
        }
    }
    throw std::out_of_range(name);
}

using Names = std::vector<std::string>;

BOOST_AUTO_TEST_CASE(without_rules_the_environment_is_one_group_as_it_is) {
    const Mesh mesh = file("car.glb", {"door", "floor/steel", "floor/rubber"});
    const ObstacleGroups groups = groupObstacles({mesh}, 1.5, {});
    BOOST_REQUIRE(groups.groups.size() == 1u);
    BOOST_TEST(groups.groups[0].margin == 1.5);
    BOOST_TEST(groups.groups[0].solids == nullptr);
    BOOST_TEST((groups.groups[0].mesh.triangles == mesh.triangles));
    BOOST_TEST((groups.groups[0].mesh.vertices == mesh.vertices));
    BOOST_TEST(groups.ignoredBox.isEmpty());
}

BOOST_AUTO_TEST_CASE(wildcards_stand_for_all_names_that_match_but_not_for_a_component_of_that_very_name) {
    const std::vector<Mesh> files = {file("car.glb", {"door_1", "door_2", "seat", "a*"}),
                                     file("lot.obj", {"door_3", "ab"})};
    const auto named = [&](const std::string& name) {
        ObstacleRules rules;
        rules.ignored = {name};
        return groupObstacles(files, 1, rules).ignored;
    };
    BOOST_TEST(named("door*") == (Names{"car/door_1", "car/door_2", "lot/door_3"}),
               boost::test_tools::per_element());
    BOOST_TEST(named("car/*_?") == (Names{"car/door_1", "car/door_2"}), boost::test_tools::per_element());
    BOOST_TEST(named("car/a*") == Names{"car/a*"}, boost::test_tools::per_element());
    ObstacleRules rules;
    rules.ignored = {"roof*"};
    BOOST_TEST(refusal(files, rules).find("ignore names 'roof*', which is no obstacle") == 0u);
}

BOOST_AUTO_TEST_CASE(components_that_are_apart_have_groups_of_their_own_and_count_as_before) {
    const Mesh mesh = file("car.glb", {"door", "roof", "floor/steel", "seat"});
    ObstacleRules rules;
    rules.margins = {{"roof", 3}};
    rules.apart = {"door", "roof"};
    const ObstacleGroups groups = groupObstacles({mesh}, 1.5, rules);
    BOOST_REQUIRE(groups.groups.size() == 3u);
    BOOST_TEST(namesOf(groupOf(groups, "door")) == Names{"door"}, boost::test_tools::per_element());
    BOOST_TEST(namesOf(groupOf(groups, "roof")) == Names{"roof"}, boost::test_tools::per_element());
    const Names others = {"floor/steel", "seat"};
    BOOST_TEST(namesOf(groupOf(groups, "seat")) == others, boost::test_tools::per_element());
    BOOST_TEST(groupOf(groups, "door").margin == 1.5);
    BOOST_TEST(groupOf(groups, "roof").margin == 3);
    rules.apart = {"window"};
    BOOST_TEST(refusal({mesh}, rules).find("'window'") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(components_that_count_alike_are_one_group_and_keep_their_places_in_the_file) {
    const Mesh mesh = file("car.glb", {"door", "floor/steel", "floor/rubber", "left pillar", "seat"});
    ObstacleRules rules;
    rules.margins = {{"floor", 3}, {"floor/steel", 4}, {"left pillar", 3}};
    rules.ignored = {"seat"};
    rules.startContact = ContactRule{{"door"}, 5};
    const ObstacleGroups groups = groupObstacles({mesh}, 1, rules);
    BOOST_TEST(groups.groups.size() == 3u);
    BOOST_TEST(namesOf(groupOf(groups, "left pillar")) == (Names{"floor/rubber", "left pillar"}),
               boost::test_tools::per_element());
    BOOST_TEST(groupOf(groups, "left pillar").margin == 3);
    BOOST_TEST(groupOf(groups, "left pillar").fileTriangles == (std::vector<std::uint32_t>{24, 36}),
               boost::test_tools::per_element());
    BOOST_TEST(groupOf(groups, "floor/steel").margin == 4);  // the rule that stands for fewer
    BOOST_TEST(groupOf(groups, "door").margin == 1);
    BOOST_TEST(groupOf(groups, "door").isIgnoredAtStart);
    BOOST_TEST(!groupOf(groups, "left pillar").isIgnoredAtStart);
    BOOST_TEST(groups.ignored == Names{"seat"}, boost::test_tools::per_element());
    BOOST_TEST(groups.ignoredBox.max().x() == 41);
    BOOST_TEST(groups.largestMargin() == 4);
    BOOST_TEST(boundingBox(groupOf(groups, "left pillar").mesh).max().x() == 31);
}

BOOST_AUTO_TEST_CASE(equal_names_of_several_files_stay_apart) {
    const std::vector<Mesh> files = {file("tray.obj", {"rail", "bolt"}), file("shelf.obj", {"rail"}),
                                     file("wall.stl", {"wall"})};
    const Mesh all = joinedEnvironment(files);
    BOOST_TEST(all.triangles.size() == 48u);
    BOOST_REQUIRE(all.components.size() == 4u);
    BOOST_TEST(all.components[2].name == "shelf/rail");
    BOOST_TEST(all.components[2].firstTriangle == 24u);
    BOOST_TEST(all.components[3].name == "wall");
    ObstacleRules rules;
    rules.margins = {{"tray", 2}, {"shelf.obj", 3}, {"bolt", 4}};
    const ObstacleGroups groups = groupObstacles(files, 1, rules);
    BOOST_TEST(groupOf(groups, "tray/rail").margin == 2);
    BOOST_TEST(groupOf(groups, "shelf/rail").margin == 3);
    BOOST_TEST(groupOf(groups, "shelf/rail").fileTriangles[0] == 0u);  // in its own file
    BOOST_TEST(groupOf(groups, "tray/bolt").margin == 4);
    BOOST_TEST(groupOf(groups, "tray/bolt").fileTriangles[0] == 12u);
    rules.margins = {{"rail", 2}};
    BOOST_TEST(
        refusal(files, rules) ==
        "margin.rail names 'rail', which is in several files, expected one of 'tray/rail', 'shelf/rail'");
}

BOOST_AUTO_TEST_CASE(unknown_names_are_refused_with_the_known_ones) {
    const std::vector<Mesh> files = {file("car.glb", {"door", "floor"})};
    const std::string known = ", which is no obstacle, expected one of 'door', 'floor'";
    const std::string near = ", which is no obstacle (did you mean 'door'?), expected one of 'door', 'floor'";
    ObstacleRules rules;
    rules.ignored = {"doo"};
    BOOST_TEST(refusal(files, rules) == "ignore names 'doo'" + near);
    rules = {};
    rules.solid = {"floor", "Door"};
    BOOST_TEST(refusal(files, rules) == "solid names 'Door'" + near);
    rules.solid = {"oo"};
    BOOST_TEST(holds(refusal(files, rules), "no obstacle (did you mean 'door', 'floor'?)"));
    rules = {};
    rules.goalContact = ContactRule{{"roof"}, 1};
    BOOST_TEST(refusal(files, rules) == "contact.goal names 'roof'" + known);
    rules = {};
    rules.margins = {{"roof", 1}};
    BOOST_TEST(refusal(files, rules) == "margin.roof names 'roof'" + known);
    rules.margins = {{"door", -1}};
    BOOST_TEST(refusal(files, rules) == "margin.door is -1, expected a finite number >= 0");
    rules.margins = {{"car", 1}, {"car.glb", 2}};
    BOOST_TEST(refusal(files, rules).find("is 1 by margin.car and 2 by margin.car.glb") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(solids_that_are_open_are_refused_and_those_inside_out_told) {
    Mesh mesh = file("car.glb", {"door", "sheet"});
    mesh.triangles.pop_back();
    mesh.components[1].triangleCount = 11;
    ObstacleRules rules;
    rules.isAllSolid = true;
    BOOST_TEST(refusal({mesh}, rules).find("solid: 'sheet' encloses nothing: 3 open edges") == 0u);
    rules.isAllSolid = false;
    rules.solid = {"door"};
    const ObstacleGroups groups = groupObstacles({mesh}, 0, rules);
    BOOST_TEST(groups.hasSolids());
    BOOST_TEST((groupOf(groups, "door").solids != nullptr));
    BOOST_TEST((groupOf(groups, "sheet").solids == nullptr));
    BOOST_TEST(groups.notes.empty());
    const Mesh inward = reversed(file("car.glb", {"door"}));
    BOOST_TEST(groupObstacles({inward}, 0, rules).notes ==
                   Names{"the solid 'door' faces inwards: it is turned over"},
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_scene_has_the_groups_as_obstacles_and_its_zones_at_both_ends) {
    const Mesh part = box({1, 1, 1});
    ObstacleRules rules;
    rules.startContact = ContactRule{{"door"}, 5};
    rules.goalContact = ContactRule{{"floor"}, 7};
    rules.isAllSolid = true;
    const ObstacleGroups groups = groupObstacles({file("car.glb", {"door", "floor", "seat"})}, 1, rules);
    const Pose start{Matrix3::Identity(), {1, 2, 3}}, goal{Matrix3::Identity(), {4, 5, 6}};
    const Scene scene = makeScene(Model::build(part), makeSolids(part).solids, groups, rules, start, goal,
                                  [](const Mesh& mesh) { return Model::build(mesh); });
    BOOST_TEST(scene.obstacles.size() == 3u);
    BOOST_TEST(scene.startContact->distance == 5);
    BOOST_TEST(scene.startContact->X_environmentPart.translation == start.translation);
    BOOST_TEST(scene.goalContact->distance == 7);
    BOOST_TEST(scene.goalContact->X_environmentPart.translation == goal.translation);
    for (const Obstacle& obstacle : scene.obstacles) BOOST_TEST((obstacle.solids != nullptr));
    BOOST_TEST((scene.partSolids != nullptr));
}

BOOST_AUTO_TEST_CASE(
    files_of_one_name_are_told_apart_by_their_folders_and_a_rule_that_may_mean_either_refused) {
    const std::vector<Mesh> files = {file("wall.obj", {"left", "right"}), file("sub/wall.obj", {"left"})};
    ObstacleRules rules;
    rules.margins = {{"somewhere/wall/left", 2}, {"sub/wall", 3}};
    const ObstacleGroups groups = groupObstacles(files, 1, rules);
    BOOST_TEST(groupOf(groups, "somewhere/wall/left").margin == 2);
    BOOST_TEST(groupOf(groups, "somewhere/wall/right").margin == 1);
    BOOST_TEST(groupOf(groups, "sub/wall/left").margin == 3);
    for (const std::string name : {"wall", "wall.obj"}) {
        rules.margins = {{name, 2}};
        BOOST_TEST(refusal(files, rules) == "margin." + name + " names '" + name +
                                                "', which is the name of several files, expected one of "
                                                "'somewhere/wall', 'sub/wall'");
    }
    rules.margins = {{"left", 2}};
    BOOST_TEST(refusal(files, rules).find("which is in several files") != std::string::npos);
    rules.margins = {{"sub", 2}};
    BOOST_TEST(refusal(files, rules).find("which is no obstacle") != std::string::npos);

    const ObstacleGroups endings =
        groupObstacles({file("wall.obj", {"wall"}), file("wall.stl", {""})}, 1, {});
    BOOST_TEST(namesOf(endings.groups.at(0)) == (Names{"wall.obj", "wall.stl"}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_window_of_data_is_made_of_closed_boxes_that_face_outwards) {
    ObstacleRules rules;
    rules.isAllSolid = true;
    for (const char* name : {"wall.obj", "plate.obj"}) {
        const ObstacleGroups groups =
            groupObstacles({loadMesh(std::string(CLEARWAY_DATA_DIR "/window/") + name)}, 0, rules);
        BOOST_TEST(groups.hasSolids(), name);
        BOOST_TEST(groups.notes.empty(), name);
    }
}

BOOST_AUTO_TEST_CASE(no_triangle_of_a_file_is_lost) {
    Mesh mesh = file("car.glb", {"door", "floor"});
    mesh.components[1].triangleCount = 0;
    BOOST_CHECK_THROW(groupObstacles({mesh}, 0, {}), ArgumentError);
    mesh.components[1].firstTriangle = 0;
    BOOST_CHECK_THROW(groupObstacles({mesh}, 0, {}), ArgumentError);
}

BOOST_AUTO_TEST_CASE(obstacles_are_grouped_by_overlap_and_made_solid) {
    const Mesh mesh = file("car.glb", {"door", "floor/steel", "floor/rubber"});
    ObstacleRules rules;
    rules.overlap.common = 0.5;
    rules.overlap.byName = {{"floor", 0.25}, {"floor/rubber", 0}};
    const ObstacleGroups groups = groupObstacles({mesh}, 0, rules);
    BOOST_TEST(groups.groups.size() == 3u);
    BOOST_TEST(groupOf(groups, "door").overlap == 0.5);
    BOOST_TEST(groupOf(groups, "floor/steel").overlap == 0.25);
    BOOST_TEST(groupOf(groups, "floor/rubber").overlap == 0);
    BOOST_TEST((groupOf(groups, "door").solids != nullptr));
    BOOST_TEST((groupOf(groups, "floor/rubber").solids == nullptr));
    BOOST_TEST(groups.overlaps() == (std::vector<double>{0.25, 0.5}), boost::test_tools::per_element());
    rules.margins = {{"floor/steel", 2}};
    BOOST_TEST(refusal({mesh}, rules) ==
               "the obstacle 'door' has the margin 1 and the overlap 0.5, expected at "
               "least one of them to be 0");
    BOOST_CHECK_THROW(makeScene(Model::build(mesh), makeSolids(mesh).solids, groups, rules, {}, {},
                                [](const Mesh& each) { return Model::build(each); }),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
