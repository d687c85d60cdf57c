#include "program/cli/window_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(render_test)

constexpr const char* kRender = "render window.cfg in.path --out out.png --size 160x90 --samples 1";

std::string added(const std::string& more) {
    return std::string(kRender) + " " + more;
}

BOOST_AUTO_TEST_CASE(a_picture_of_the_size_asked_for_is_written_and_each_pose_told) {
    const WindowFolder folder;
    const Outcome outcome = runIn(folder, added("--at 0,0.5,1 --json facts.json"));
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST((sizeOfPng(readText(folder.file("out.png"))) == std::pair(160, 90)));
    BOOST_TEST(holds(row(outcome, "pose at 0.5"), "NOT valid: in collision"), outcome.out);
    const auto poses = jsonIn(folder, "facts.json")["poses"];
    BOOST_TEST_REQUIRE(poses.size() == 3u);
    for (const int free : {0, 2}) {
        BOOST_TEST(poses[free]["valid"] == true);
        BOOST_TEST(poses[free]["clearance"].get<double>() == 28, boost::test_tools::tolerance(1e-6));
    }
    BOOST_TEST(poses[1]["valid"] == false);
    BOOST_TEST(poses[1]["pair"]["part"]["mesh"] == "plate");
}

BOOST_AUTO_TEST_CASE(the_same_bytes_are_written_twice_and_others_for_another_view) {
    const WindowFolder folder;
    BOOST_TEST(runIn(folder, kRender).code == 0);
    const std::string first = readText(folder.file("out.png"));
    BOOST_TEST(runIn(folder, kRender).code == 0);
    BOOST_TEST(readText(folder.file("out.png")) == first);
    for (const char* other : {"--view inside", "--view top --cut z=5", "--poses 2", "--eye 100,100,100",
                              "--eye 100,100,100 --look-at 0,50,0 --angle 60", "--close", "--scale 3",
                              "--cut 1,1,0,5", "--margin 3", "--axes"}) {
        const Outcome outcome = runIn(folder, added(other));
        BOOST_TEST(outcome.code == 0, outcome.err);
        BOOST_TEST(readText(folder.file("out.png")) != first, other);
    }
}

BOOST_AUTO_TEST_CASE(without_a_path_start_and_goal_are_drawn) {
    const WindowFolder folder;
    const auto facts = factsOf(folder, "render window.cfg --out out.png --size 64x64 --samples 1");
    BOOST_TEST(facts["poses"][0]["share"] == 0.0);
    BOOST_TEST(facts["poses"][1]["share"] == 1.0);
    BOOST_TEST((sizeOfPng(readText(folder.file("out.png"))) == std::pair(64, 64)));
}

BOOST_AUTO_TEST_CASE(warnings_about_the_problem_are_told) {
    const WindowFolder folder;
    folder.write("noted.cfg", readText(folder.file("window.cfg")) + "[planner]\nprm = 5\n");
    const Outcome outcome = runIn(folder, "render noted.cfg --out a.png --size 64x32 --samples 1");
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(holds(outcome.err, "prm is '5'", "no effect"), outcome.err);
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_refused_in_one_line) {
    const WindowFolder folder;
    folder.write("bad.path", "1 2 3\n");
    requireRefused(folder, "render window.cfg in.path", {"--out is missing"});
    requireRefused(folder, "render", {"PROBLEM.cfg is missing", "[IN.path]", "--video FILE"});
    requireRefused(folder, "render window.cfg in.path more --out out.png", {"'more'"});
    requireRefused(folder, "render window.cfg nowhere.path --out out.png", {"nowhere.path"});
    requireRefused(folder, "render window.cfg bad.path --out out.png",
                   {"bad.path:1", "3 numbers", "expected 7"});
    requireRefused(folder, "render window.cfg in.path --out nowhere/out.png", {"nowhere/out.png"});
    requireRefused(folder, added("--view askew"), {"'askew'", "inside, iso, front"});
    for (const char* size : {"0x0", "0", "160", "axb", "160x90x3", "160x-90", "99999x9", "''"}) {
        requireRefused(folder, std::string("render window.cfg in.path --out out.png --size ") + size,
                       {"--size"});
    }
    requireRefused(folder, added("--eye 1,2"), {"--eye is '1,2'", "X,Y,Z"});
    requireRefused(folder, added("--eye 1,2,3 --look-at 1,2,3"), {"stands at the point it looks at"});
    requireRefused(folder, added("--eye 1,2,3 --view top"), {"--view"});
    requireRefused(folder, added("--look-at 1,2,3"), {"--look-at", "--eye"});
    requireRefused(folder, added("--angle 180"), {"--angle is '180'"});
    requireRefused(folder, added("--poses 0"), {"--poses is '0'"});
    requireRefused(folder, added("--at 0,2"), {"--at is '0,2'", "from 0 to 1"});
    requireRefused(folder, added("--at 0 --poses 2"), {"--at"});
    requireRefused(folder, "render window.cfg --out out.png --poses 2", {"--poses", "path"});
    requireRefused(folder, added("--cut w=3"), {"--cut is 'w=3'", "x=D"});
    requireRefused(folder, added("--cut 0,0,0,1"), {"--cut", "not all 0"});
    requireRefused(folder, added("--scale 0"), {"--scale is '0'"});
    requireRefused(folder, added("--margin -1"), {"--margin is '-1'"});
    requireRefused(folder, "render window.cfg in.path --out out.png --samples 0", {"--samples is '0'"});
}

BOOST_AUTO_TEST_CASE(a_picture_never_replaces_a_file_that_is_read) {
    const WindowFolder folder;
    for (const std::string& input : folder.names()) {
        requireRefused(folder, "render window.cfg in.path --out ./" + input, {"--out is './" + input + "'"});
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
