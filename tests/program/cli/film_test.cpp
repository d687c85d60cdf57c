#include <algorithm>
#include <filesystem>
#include <set>

#include "program/cli/window_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(film_test)

constexpr const char* kFrames =
    "render window.cfg in.path --frames film --seconds 0.5 --fps 8 --size 64x40 --samples 1";

std::vector<std::string> framesIn(const TemporaryFolder& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.file("film")))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

BOOST_AUTO_TEST_CASE(frames_are_numbered_pictures_of_the_whole_motion) {
    const WindowFolder folder;
    const Outcome outcome = runIn(folder, kFrames);
    BOOST_TEST(outcome.code == 0, outcome.err);
    BOOST_TEST(holds(row(outcome, "in contact"), "2 pictures of 4: IN COLLISION"), outcome.out);
    const std::vector<std::string> expected = {"frame-0001.png", "frame-0002.png", "frame-0003.png",
                                               "frame-0004.png"};
    BOOST_TEST(framesIn(folder) == expected, boost::test_tools::per_element());
    std::set<std::string> different;
    for (const std::string& name : expected) {
        const std::string png = readText(folder.file("film/" + name));
        BOOST_TEST((sizeOfPng(png) == std::pair(64, 40)));
        different.insert(png);
    }
    BOOST_TEST(different.size() == 4);
}

BOOST_AUTO_TEST_CASE(frames_replace_those_of_an_earlier_film_and_nothing_else) {
    const WindowFolder folder;
    BOOST_TEST(runIn(folder, kFrames).code == 0);
    const std::vector<std::string> before = folder.names();
    const Outcome shorter = runIn(
        folder, "render window.cfg in.path --frames film/ --seconds 1 --fps 3 --size 32x32 --samples 1");
    BOOST_TEST(shorter.code == 0, shorter.err);
    BOOST_TEST(framesIn(folder).size() == 3);
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
    folder.write("film/notes.txt", "mine");
    requireRefused(folder, kFrames, {"'notes.txt'", "expected a new name"});
    BOOST_TEST(framesIn(folder).size() == 4);
}

BOOST_AUTO_TEST_CASE(a_film_that_cannot_be_made_is_refused_before_long_work) {
    const WindowFolder folder;
    const std::string film = "render window.cfg in.path ";
    WindowScene window = windowScene();
    writePath({window.problem.start}, Space::kSe3, folder.file("one.path"));
    requireRefused(folder, "render window.cfg one.path --frames film", {"1 state", "at least 2"});
    requireRefused(folder, "render window.cfg --frames film", {"--frames", "path"});
    requireRefused(folder, film + "--frames nowhere/film", {"nowhere/film"});
    requireRefused(folder, film + "--frames in.path", {"in.path", "not a folder"});
    requireRefused(folder, film + "--frames .", {"current folder"});
    requireRefused(folder, film + "--frames -", {"--frames is '-'"});
    requireRefused(folder, film + "--frames film --out film/out.png", {"film/out.png"});
    requireRefused(folder, film + "--video film.avi", {"'film.avi'", ".mp4 or .gif"});
    requireRefused(folder, film + "--video in.path", {"'in.path'"});
    requireRefused(folder, film + "--video film.mp4 --size 8000x40", {"8000 x 40", "at most 4096"});
    requireRefused(folder, film + "--video film.gif --size 4000x4000", {"too much for a GIF", ".mp4"});
    requireRefused(folder, film + "--video film.gif --fps 60", {"--fps is 60", "at most 50"});
    for (const char* option :
         {"--seconds 0", "--seconds -1", "--seconds long", "--fps 0", "--fps 1.5", "--size 0x0"})
        requireRefused(folder, film + "--frames film " + option, {std::string(option).substr(0, 5)});
    requireRefused(folder, film + "--out out.png --seconds 3",
                   {"--seconds", "only with --frames or --video"});
    requireRefused(folder, film + "--frames film --poses 3", {"--poses", "only with --out"});
}

BOOST_AUTO_TEST_CASE(without_ffmpeg_a_video_is_refused_with_what_to_install) {
    const WindowFolder folder;
    const TemporaryFolder caught;
    const std::string command = "cd '" + folder.path() +
                                "' && PATH=/nowhere " CLEARWAY_PROGRAM
                                " render window.cfg in.path --video film.mp4 2> '" +
                                caught.file("err") + "'";
    const std::vector<std::string> before = folder.names();
    BOOST_TEST(WEXITSTATUS(std::system(command.c_str())) == 2);
    BOOST_TEST(holds(readText(caught.file("err")), "apt-get install ffmpeg"));
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_interrupt_leaves_no_picture_and_no_frames) {
    const WindowFolder folder;
    const std::vector<std::string> before = folder.names();
    for (const std::string output : {"--out out.png", "--frames film", "--out out.png --frames film"}) {
        const Outcome outcome =
            interruptIn(folder, "render window.cfg in.path --size 1280x720 --samples 512 " + output);
        BOOST_TEST(outcome.code == 1, outcome.err);
        BOOST_TEST(outcome.err == "");
        BOOST_TEST(row(outcome, output == "--frames film" ? "frames" : "picture") == "none, interrupted");
        BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
