// Films that ffmpeg writes. Without ffmpeg these tests are skipped, and CTest says so.
#include <filesystem>
#include <iostream>

#include "program/cli/window_folder.h"

namespace clearway::testing {
BOOST_AUTO_TEST_SUITE(video_test)

constexpr const char* kFilm = "render window.cfg in.path --seconds 0.5 --fps 10 --size 65x41 --samples 1";

bool hasFfmpeg() {
    const bool isThere = std::system("command -v ffmpeg > /dev/null 2>&1") == 0;
    if (!isThere) std::cout << "not run: program/cli/video needs ffmpeg\n";
    return isThere;
}

/// Asks ffprobe about the pictures of a film: width, height, rate and number, as in "66,42,10/1,5".
std::string probed(const std::string& file) {
    const TemporaryFolder caught;
    const std::string command =
        "ffprobe -v error -count_frames -select_streams v -of csv=p=0 -show_entries "
        "stream=width,height,r_frame_rate,nb_read_frames '" +
        file + "' > '" + caught.file("out") + "'";
    BOOST_TEST(std::system(command.c_str()) == 0);
    const std::string said = readText(caught.file("out"));
    return said.substr(0, said.find('\n'));
}

BOOST_AUTO_TEST_CASE(a_film_has_its_pictures_its_size_and_its_pace) {
    if (!hasFfmpeg()) return;
    const WindowFolder folder;
    folder.write("film.gif", "an old file");
    const std::vector<std::string> before = folder.names();
    const Outcome gif = runIn(folder, std::string(kFilm) + " --video film.gif");
    BOOST_TEST(gif.code == 0, gif.err);
    BOOST_TEST(gif.err == "");
    BOOST_TEST(readText(folder.file("film.gif")).substr(0, 6) == "GIF89a");
    BOOST_TEST(probed(folder.file("film.gif")) == "65,41,10/1,5");
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
    const Outcome mp4 = runIn(folder, std::string(kFilm) + " --video film.MP4 --frames frames --out one.png");
    BOOST_TEST(mp4.code == 0, mp4.err);
    BOOST_TEST(probed(folder.file("film.MP4")) == "66,42,10/1,5");  // players want even sides
}

BOOST_AUTO_TEST_CASE(an_interrupt_leaves_no_film) {
    if (!hasFfmpeg()) return;
    const WindowFolder folder;
    folder.write("film.mp4", "an old file");
    const std::vector<std::string> before = folder.names();
    const Outcome outcome = interruptIn(
        folder, "render window.cfg in.path --video film.mp4 --size 320x200 --fps 50 --seconds 600");
    BOOST_TEST(outcome.code == 1, outcome.err);
    BOOST_TEST(outcome.err == "");
    BOOST_TEST(row(outcome, "video") == "none, interrupted");
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
    BOOST_TEST(readText(folder.file("film.mp4")) == "an old file");
}

BOOST_AUTO_TEST_CASE(what_ffmpeg_says_when_it_fails_is_told) {
    if (!hasFfmpeg()) return;
    const WindowFolder folder;
    const TemporaryFolder caught;
    const std::string tool = caught.write("ffmpeg", "#!/bin/sh\necho 'no room left' >&2\nexit 1\n");
    std::filesystem::permissions(tool, std::filesystem::perms::owner_all);
    const std::vector<std::string> before = folder.names();
    const std::string command = "cd '" + folder.path() + "' && PATH='" + caught.path() +
                                "':$PATH " CLEARWAY_PROGRAM " " + kFilm + " --video film.mp4 2> '" +
                                caught.file("err") + "' > /dev/null";
    BOOST_TEST(WEXITSTATUS(std::system(command.c_str())) == 2);
    BOOST_TEST(holds(readText(caught.file("err")), "ffmpeg", "no room left"));
    BOOST_TEST(folder.names() == before, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway::testing
