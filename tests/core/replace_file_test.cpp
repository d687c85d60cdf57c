#include "core/replace_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/full_disk.h"
#include "support/temporary_folder.h"
#include "support/words.h"

namespace clearway {
BOOST_AUTO_TEST_SUITE(replace_file_test)

using testing::readText;
using testing::TemporaryFolder;

std::string messageOf(const std::string& file) {
    return testing::refusalBy<std::runtime_error>(
        [&] { replaceFile(file, [](std::ostream& stream) { stream << "new"; }); });
}

/// messageOf in a process that modes bind, unlike one of root.
std::string messageForUser(const std::string& file) {
    constexpr uid_t kNobody = 65534;
    std::array<int, 2> ends;
    BOOST_REQUIRE(pipe(ends.data()) == 0);
    const pid_t child = fork();
    if (child == 0) {
        const bool isUser = geteuid() != 0 || setuid(kNobody) == 0;
        const std::string message = isUser ? messageOf(file) : "root";
        _exit(::write(ends[1], message.data(), message.size()) < 0);
    }
    ::close(ends[1]);
    std::string message(1000, '\0');
    message.resize(std::size_t(std::max<ssize_t>(0, ::read(ends[0], message.data(), message.size()))));
    ::close(ends[0]);
    waitpid(child, nullptr, 0);
    return message;
}

BOOST_AUTO_TEST_CASE(a_file_is_made_or_replaced_and_nothing_else_is_left) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.csv");
    for (const char* text : {"first", "second"}) {
        replaceFile(file, [&](std::ostream& stream) { stream << text; });
        BOOST_TEST(readText(file) == text);
        BOOST_TEST(folder.names() == std::vector<std::string>{"a.csv"}, boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_made_is_named_with_what_was_expected) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.csv", "old");
    makeFolder(folder.file("new/deep"));
    makeFolder(folder.file("new/deep"));
    for (const std::string& wrong : {file, file + "/deep"}) {
        testing::requireRefusedBy<std::runtime_error>([&] { makeFolder(wrong); },
                                                      {"'" + wrong + "'", "expected a folder"});
    }
}

BOOST_AUTO_TEST_CASE(an_exception_half_way_leaves_the_old_file_alone) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.csv", "old");
    const auto failing = [](std::ostream& stream) {
        stream << "half";
        throw std::domain_error("stop");
    };
    BOOST_CHECK_THROW(replaceFile(file, failing), std::domain_error);
    BOOST_TEST(readText(file) == "old");
    BOOST_TEST(folder.names() == std::vector<std::string>{"a.csv"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_stream_that_fails_leaves_the_old_file_alone) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.csv", "old");
    const auto failing = [](std::ostream& stream) { stream.setstate(std::ios::badbit); };
    BOOST_CHECK_THROW(replaceFile(file, failing), std::runtime_error);
    BOOST_TEST(readText(file) == "old");
    BOOST_TEST(folder.names() == std::vector<std::string>{"a.csv"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_written_is_named) {
    const TemporaryFolder folder;
    const std::string inNoFolder = folder.file("none/a.csv");
    BOOST_TEST(messageOf(inNoFolder) ==
               "cannot write '" + inNoFolder +
                   "': No such file or directory, expected a folder that exists and may be written");
    BOOST_TEST(messageOf(folder.path()) ==
               "cannot write '" + folder.path() + "': it is a folder, expected the name of a file");
    const std::string pipe = folder.file("pipe");
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    BOOST_TEST(messageOf(pipe) == "cannot write '" + pipe +
                                      "': it is not a regular file, expected a regular file or a new name");
    BOOST_TEST(folder.names() == std::vector<std::string>{"pipe"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_stream_of_the_process_is_refused_wherever_it_leads) {
    const TemporaryFolder folder;
    const std::string redirected = folder.write("out.txt", "shown");
    const int stream = ::open(redirected.c_str(), O_WRONLY);
    BOOST_REQUIRE(stream >= 0);
    const std::string name = "/proc/self/fd/" + std::to_string(stream), link = folder.file("link");
    std::filesystem::create_symlink(name, link);
    for (const std::string& each : {name, link, "/dev/fd/" + std::to_string(stream)}) {
        BOOST_TEST(messageOf(each).find("it is not a regular file") != std::string::npos, each);
        BOOST_TEST(!setAside(each), each);
    }
    ::close(stream);
    BOOST_TEST(readText(redirected) == "shown");
    BOOST_TEST(std::filesystem::is_symlink(link));
}

BOOST_AUTO_TEST_CASE(links_stay_and_modes_are_kept) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    makeFolder(folder.file("deep"));
    const std::string there = folder.write("deep/there.csv", "old"), link = folder.file("link"),
                      second = folder.file("second"), dangling = folder.file("dangling");
    fs::permissions(there, fs::perms(0640));
    fs::create_symlink("deep/there.csv", link);
    fs::create_symlink("link", second);
    fs::create_symlink("deep/new.csv", dangling);
    for (const std::string& name : {second, dangling}) {
        BOOST_TEST(messageOf(name) == "accepted");
        BOOST_TEST(fs::is_symlink(name));
        BOOST_TEST(readText(name) == "new");
    }
    BOOST_TEST(readText(there) == "new");
    BOOST_TEST(fs::is_regular_file(folder.file("deep/new.csv")));
    BOOST_TEST((fs::status(there).permissions() == fs::perms(0640)));
    const mode_t mask = umask(0);
    umask(mask);
    BOOST_TEST((fs::status(folder.file("deep/new.csv")).permissions() == fs::perms(0666 & ~mask)));
    replaceFileByName(second, [](const std::string& name) { return std::ofstream(name) << "by name", true; });
    BOOST_TEST(readText(there) == "by name");
    BOOST_TEST((fs::status(there).permissions() == fs::perms(0640)));
}

BOOST_AUTO_TEST_CASE(the_reason_why_a_name_leads_nowhere_is_told) {
    const TemporaryFolder folder;
    const std::string round = folder.file("round"), longName = folder.file(std::string(300, 'n'));
    std::filesystem::create_symlink("round", round);
    BOOST_TEST(messageOf(round) == "cannot write '" + round +
                                       "': Too many levels of symbolic links, expected a regular file or a "
                                       "new name");
    BOOST_TEST(messageOf(longName).find("': File name too long, expected") != std::string::npos);
    BOOST_TEST(std::filesystem::is_symlink(round));
}

BOOST_AUTO_TEST_CASE(a_full_disk_leaves_the_old_file_alone) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.csv", "old");
    std::string message;
    {
        const testing::FullDisk full(1);
        message = messageOf(file);
    }
    BOOST_TEST(message == "cannot write '" + file + "': File too large, expected room for the whole file");
    BOOST_TEST(readText(file) == "old");
    BOOST_TEST(folder.names() == std::vector<std::string>{"a.csv"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(modes_of_file_and_folder_decide_what_may_be_written) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.csv", "old");
    chmod(file.c_str(), 0222);
    chmod(folder.path().c_str(), 0333);
    BOOST_TEST(messageForUser(file) == "accepted");
    chmod(folder.path().c_str(), 0555);
    BOOST_TEST(messageForUser(file) ==
               "cannot write '" + file +
                   "': Permission denied, expected a folder that exists and may be written");
    chmod(folder.path().c_str(), 0222);
    BOOST_TEST(messageForUser(file) ==
               "cannot write '" + file + "': Permission denied, expected a regular file or a new name");
    chmod(folder.path().c_str(), 0777);
    BOOST_TEST((std::filesystem::status(file).permissions() == std::filesystem::perms(0222)));
    chmod(file.c_str(), 0666);
    BOOST_TEST(readText(file) == "new");
    BOOST_TEST(folder.names() == std::vector<std::string>{"a.csv"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_file_set_aside_never_overwrites_another) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.path");
    BOOST_TEST(!setAside(file));
    folder.write("a.path.old.2", "kept");
    for (const char* name : {"a.path.old", "a.path.old.3", "a.path.old.4"}) {
        folder.write("a.path", name);
        BOOST_TEST(setAside(file).value_or("") == folder.file(name));
        BOOST_TEST(readText(folder.file(name)) == name);
        BOOST_TEST(!std::filesystem::exists(file));
    }
    BOOST_TEST(readText(folder.file("a.path.old.2")) == "kept");

    folder.write("b.path", "there");
    std::filesystem::create_symlink("b.path", file);
    BOOST_TEST(setAside(file).value_or("") == folder.file("b.path.old"));
    BOOST_TEST(std::filesystem::is_symlink(file));
    BOOST_TEST(readText(folder.file("b.path.old")) == "there");
    BOOST_TEST(!setAside(file));           // the link leads to nothing
    BOOST_TEST(!setAside(folder.path()));  // a folder stays
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace clearway
