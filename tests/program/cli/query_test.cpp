#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

#include "program/cli/run_program.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(query_test)

/// Boxes: the part from -1 to 1, the environment from -2 to 2.
struct BoxesFolder : TemporaryFolder {
    BoxesFolder() {
        write("part.obj", boxObj(-1, 1));
        write("environment.obj", boxObj(-2, 2));
    }
};

constexpr const char* kQuery =
    "query --part part.obj --environment environment.obj --poses poses.txt --query ";

/// Beside, touching, crossing, and turned by a right angle at a distance along z.
constexpr const char* kPoses =
    "# x = 7.5, 3, 2.5 and z = 10\n"
    "1 0 0 0 1 0 0 0 1 7.5 0 0\n"
    "1 0 0 0 1 0 0 0 1 3 0 0\n"
    "\n"
    "2.5 0 0 0 0 0 1\n"
    "0 0 10 0 0 0.70710678118654757 0.70710678118654757\n";
const std::vector<double> kDistances = {4.5, 0, 0, 7};

using Table = std::vector<std::vector<std::string>>;

Table tableOf(const std::string& csv) {
    Table table;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        table.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) table.back().push_back(cell);
    }
    return table;
}

/// Runs the query with --csv and returns the rows below the header.
Table answers(const TemporaryFolder& folder, const std::string& query, const std::string& header) {
    const Outcome outcome = runIn(folder, kQuery + query + " --csv a.csv");
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    const std::string csv = readText(folder.file("a.csv"));
    BOOST_TEST_REQUIRE(csv.substr(0, csv.find('\n')) == header);
    Table table = tableOf(csv);
    table.erase(table.begin());
    return table;
}

constexpr const char* kDistanceHeader =
    "pose,distance,lower,upper,part_triangle,environment_triangle,nanoseconds,x,y,z,qx,qy,qz,qw,"
    "part_mesh,part_x,part_y,part_z,environment_mesh,environment_x,environment_y,environment_z";
constexpr const char* kVerdictHeader = "pose,verdict,nanoseconds,x,y,z,qx,qy,qz,qw";

BOOST_AUTO_TEST_CASE(distances_come_one_row_a_pose_with_their_interval_and_triangles) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    const Table table = answers(folder, "distance", kDistanceHeader);
    BOOST_TEST_REQUIRE(table.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        BOOST_TEST_REQUIRE(table[i].size() == 22);
        for (const int column : {14, 18}) BOOST_TEST(table[i][column] == "box");
        BOOST_TEST(table[i][0] == std::to_string(i));
        BOOST_TEST(std::abs(std::stod(table[i][1]) - kDistances[i]) <= 1e-12);
        BOOST_TEST(std::stod(table[i][2]) <= kDistances[i]);
        BOOST_TEST(std::stod(table[i][3]) >= kDistances[i]);
        for (const int column : {4, 5}) {
            BOOST_TEST(std::stoi(table[i][column]) >= 0);
            BOOST_TEST(std::stoi(table[i][column]) < 12);
        }
        BOOST_TEST(std::stol(table[i][6]) > 0);
    }
}

BOOST_AUTO_TEST_CASE(numbers_of_the_table_have_17_digits) {
    const BoxesFolder folder;
    folder.write("poses.txt", "3.1 0 0 0 0 0 1\n");
    const std::string distance = answers(folder, "distance", kDistanceHeader)[0][1];
    BOOST_TEST(std::abs(std::stod(distance) - 0.1) <= 1e-14);
    BOOST_TEST(distance.size() >= 18, distance);  // 0. and 16 or 17 digits
}

BOOST_AUTO_TEST_CASE(json_has_the_facts_that_the_screen_shows) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    const Outcome outcome = runIn(folder, kQuery + std::string("distance --json a.json"));
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "least distance") == "0 at pose 1");
    BOOST_TEST(std::stod(row(outcome, "bytes per triangle")) > 0);
    const auto facts = jsonIn(folder, "a.json");
    BOOST_TEST(facts["poses"].size() == 4u);
    BOOST_TEST(facts["poses"][0]["position"][0] == 7.5);
    BOOST_TEST(facts["answers"][0]["part"]["mesh"] == "box");
    BOOST_TEST(facts["answers"][0]["environment"]["mesh"] == "box");
    const auto& all = facts["statistics"];
    BOOST_TEST(all["colliding"] == 2);
    BOOST_TEST(all["least"]["pose"] == 1);
    BOOST_TEST(all["most"]["pose"] == 3);
    BOOST_TEST(all["most"]["distance"] == 7.0);
    BOOST_TEST(all["widest_interval"].get<double>() > 0);
    BOOST_TEST(all["widest_interval"].get<double>() < 1e-10);
    BOOST_TEST(all["queries_per_second"].get<double>() > 0);
    BOOST_TEST(!holds(readText(folder.file("a.json")), "-0.0"));
    for (const auto& [distance, count] : {std::pair("5", 3), std::pair("4.6", 3), std::pair("0", 2)})
        BOOST_TEST(factsOf(folder, kQuery + std::string("within=") + distance)["statistics"]["within"] ==
                   count);
}

BOOST_AUTO_TEST_CASE(verdicts_are_1_or_0) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    const std::vector<std::pair<std::string, std::vector<std::string>>> expected = {
        {"collide", {"0", "1", "1", "0"}},
        {"within=0", {"0", "1", "1", "0"}},
        {"within=4.4", {"0", "1", "1", "0"}},
        {"within=4.6", {"1", "1", "1", "0"}},
        {"within=7.1", {"1", "1", "1", "1"}}};
    for (const auto& [query, verdicts] : expected) {
        const Table table = answers(folder, query, kVerdictHeader);
        BOOST_TEST_REQUIRE(table.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            BOOST_TEST_REQUIRE(table[i].size() == 10);
            BOOST_TEST(table[i][0] == std::to_string(i));
            BOOST_TEST(table[i][1] == verdicts[i], query << " at pose " << i);
            BOOST_TEST(std::stol(table[i][2]) > 0);
        }
    }
    BOOST_TEST(factsOf(folder, kQuery + std::string("collide"))["statistics"]["colliding"] == 2);
}

BOOST_AUTO_TEST_CASE(order_warmth_strategy_and_instruction_set_change_no_answer) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    for (const char* options :
         {"--shuffle 0", "--shuffle 123", "--cold", "--cold --shuffle 1", "--target scalar", "--target best",
          "--node-width 2", "--general-split mean --leaf-split chain --leaf-size 8"}) {
        const Table table = answers(folder, std::string("distance ") + options, kDistanceHeader);
        BOOST_TEST_REQUIRE(table.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            BOOST_TEST(table[i][0] == std::to_string(i));
            BOOST_TEST(std::abs(std::stod(table[i][1]) - kDistances[i]) <= 1e-12,
                       options << " at pose " << i);
        }
    }
}

BOOST_AUTO_TEST_CASE(beyond_the_cap_are_inf_and_no_triangle) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    const Table table = answers(folder, "distance --cap 5", kDistanceHeader);
    BOOST_TEST(std::abs(std::stod(table[0][1]) - 4.5) <= 1e-12);
    BOOST_TEST(table[3][1] == "inf");
    BOOST_TEST(std::stod(table[3][2]) >= 5);
    BOOST_TEST(std::stod(table[3][2]) <= 7);
    BOOST_TEST(table[3][3] == "inf");
    BOOST_TEST(table[3][4] == "-1");
    BOOST_TEST(table[3][5] == "-1");
    const auto all = factsOf(folder, kQuery + std::string("distance --cap 5"))["statistics"];
    BOOST_TEST(all["beyond_cap"] == 1);
    BOOST_TEST(all["most"]["pose"] == 0);
}

BOOST_AUTO_TEST_CASE(the_scale_is_for_both_meshes_not_for_poses_and_nothing_is_moved_to_its_centre) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    const Table table = answers(folder, "distance --scale 0.5", kDistanceHeader);
    BOOST_TEST(std::abs(std::stod(table[0][1]) - 6) <= 1e-12);
    BOOST_TEST(std::abs(std::stod(table[1][1]) - 1.5) <= 1e-12);
    folder.write("part.obj", boxObj(10, 12));
    folder.write("poses.txt", "0 -11 -11 0 0 0 1\n");
    BOOST_TEST(std::abs(std::stod(answers(folder, "distance", kDistanceHeader)[0][1]) - 8) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(what_a_file_declares_and_is_not_applied_is_said) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    folder.write("part.dae", R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimetre" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">-1 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)");
    const std::string tail = "--environment environment.obj --poses poses.txt --query distance";
    const Outcome outcome = runIn(folder, "query --part part.dae --json a.json " + tail);
    BOOST_TEST_REQUIRE(outcome.code == 0, outcome.err);
    BOOST_TEST(row(outcome, "  unit stated") == "cm, not applied");
    BOOST_TEST(row(outcome, "  up axis stated") == "z, not applied");
    // 10 less 2: neither scaled nor turned
    BOOST_TEST(jsonIn(folder, "a.json")["statistics"]["most"]["distance"] == 8.0);
}

BOOST_AUTO_TEST_CASE(projected_rotations_are_counted_in_words) {
    const BoxesFolder folder;
    folder.write("poses.txt", "0.866025 -0.5 0 0.5 0.866025 0 0 0 1 9 0 0\n1 0 0 0 1 0 0 0 1 9 0 0\n");
    const Outcome outcome = runIn(folder, kQuery + std::string("distance"));
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(holds(row(outcome, "poses"), "2, 1 of them projected"));
}

/// Other defects are refused by readPoses(), whose test has them.
BOOST_AUTO_TEST_CASE(pose_files_that_are_wrong_are_refused_with_the_line) {
    const BoxesFolder folder;
    folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 7.5 0 0\n1 0 0 0 1 0 0 0 1 7.5 0\n");
    requireRefused(folder, kQuery + std::string("distance"), {"poses.txt:2", "11 numbers", "expected 12"});
    std::filesystem::remove(folder.file("poses.txt"));
    requireRefused(folder, kQuery + std::string("distance"), {"'poses.txt'", "expected a pose file"});
}

BOOST_AUTO_TEST_CASE(a_pose_too_far_away_is_refused_with_its_number) {
    const BoxesFolder folder;
    folder.write("poses.txt", "0 0 9 0 0 0 1\n0 0 1e30 0 0 0 1\n");
    for (const char* query : {"distance", "collide", "within=1"}) {
        requireRefused(folder, kQuery + std::string(query) + " --csv a.csv", {"pose 1", "expected"});
    }
}

BOOST_AUTO_TEST_CASE(meshes_that_are_none_are_refused) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    folder.write("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n");
    for (const char* file : {"none.stl", "nan.obj"}) {
        const std::string tail = " --poses poses.txt --query collide --csv a.csv";
        requireRefused(folder, std::string("query --environment environment.obj --part ") + file + tail,
                       {file});
        requireRefused(folder, std::string("query --part part.obj --environment ") + file + tail, {file});
    }
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    const auto requireQueryRefused = [&](const std::string& tail, const std::vector<std::string>& words) {
        requireRefused(folder, kQuery + tail + " --csv a.csv", words);
    };
    for (const char* query :
         {"near", "within", "within=", "within=abc", "within=-1", "within=nan", "Distance"}) {
        requireQueryRefused(query,
                            {"--query is '" + std::string(query) + "'", "distance, collide or within=D"});
    }
    for (const std::string option : {"--cap", "--relative-error", "--absolute-error"})
        requireQueryRefused("distance " + option + " nan", {option + " is 'nan'", "a number of at least 0"});
    requireQueryRefused("distance --cap -1", {"--cap is '-1'", "a number of at least 0"});
    requireQueryRefused("collide --cap 3", {"--cap is '3'", "distance"});
    requireQueryRefused("within=2 --absolute-error 1", {"--absolute-error is '1'", "distance"});
    requireQueryRefused("distance --target foo", {"target is 'foo'", "scalar"});
    requireQueryRefused("distance --shuffle x", {"--shuffle is 'x'", "an integer from 0"});
    const std::vector<std::string> needed = {"--part part.obj", "--environment environment.obj",
                                             "--poses poses.txt", "--query collide"};
    for (const std::string& missing : needed) {
        std::string words = "query";
        for (const std::string& option : needed) words += option == missing ? "" : " " + option;
        requireRefused(folder, words, {missing.substr(0, missing.find(' ')) + " is missing"});
    }
}

BOOST_AUTO_TEST_CASE(a_table_never_replaces_a_file_that_is_read) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    for (const char* input : {"part.obj", "environment.obj", "poses.txt"}) {
        const std::string before = readText(folder.file(input));
        requireRefused(folder, kQuery + std::string("distance --csv ./") + input,
                       {"--csv is './" + std::string(input) + "'", "input file", "expected another"});
        BOOST_TEST(readText(folder.file(input)) == before);
    }
}

BOOST_AUTO_TEST_CASE(a_table_or_output_that_cannot_be_written_leaves_nothing) {
    const BoxesFolder folder;
    folder.write("poses.txt", kPoses);
    requireRefused(folder, kQuery + std::string("distance --csv none/a.csv"),
                   {"'none/a.csv'", "expected a folder that exists"});
    requireRefused(folder, kQuery + std::string("distance --csv ."), {"'.'", "folder"});
    requireRefused(folder, kQuery + std::string("distance --csv ''"), {"--csv is ''"});
    requireRefused(folder, kQuery + std::string("distance --csv a.csv > /dev/full"), {"standard output"});
    folder.write("a.csv", "old");
    folder.write("poses.txt", "1 2 3\n");
    requireRefused(folder, kQuery + std::string("distance --csv a.csv"), {"poses.txt:1"});
    BOOST_TEST(readText(folder.file("a.csv")) == "old");
}

BOOST_FIXTURE_TEST_CASE(a_cache_holds_the_trees_and_changes_no_answer, BoxesFolder) {
    write("poses.txt", kPoses);
    const Table plain = answers(*this, "distance", kDistanceHeader);
    for (int run = 0; run < 2; ++run) {
        const Table cached = answers(*this, "distance --cache trees", kDistanceHeader);
        for (std::size_t row = 0; row < plain.size(); ++row) {
            for (std::size_t column = 0; column < 6; ++column)
                BOOST_TEST(cached[row][column] == plain[row][column]);
        }
    }
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file("trees"))) {
        BOOST_TEST(entry.path().extension() == ".clearway");
        write("trees/" + entry.path().filename().string(), "damaged");
        ++files;
    }
    BOOST_TEST(files == 2);
    const Outcome outcome = runIn(*this, kQuery + std::string("distance --cache trees"));
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(holds(outcome.err, "built again"));
    requireRefused(*this, kQuery + std::string("distance --cache part.obj"),
                   {"--cache", "part.obj", "folder"});
}

BOOST_FIXTURE_TEST_CASE(a_cache_that_cannot_be_written_is_one_warning, BoxesFolder) {
    write("poses.txt", kPoses);
    BOOST_TEST(answers(*this, "distance --cache /proc", kDistanceHeader).size() ==
               answers(*this, "distance", kDistanceHeader).size());
    const Outcome outcome = runIn(*this, kQuery + std::string("distance --cache /proc"));
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(holds(outcome.err, "warning: cannot write '/proc/"), outcome.err);
    BOOST_TEST(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1, outcome.err);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
