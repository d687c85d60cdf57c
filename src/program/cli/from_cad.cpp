#include "program/cli/from_cad.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "core/replace_file.h"
#include "core/text.h"

extern char** environ;

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kCadProgram = "clearway-cad";
constexpr const char* kCadEndings[] = {".step", ".stp", ".iges", ".igs"};

bool isCadFile(const std::string& file) {
    for (const char* const ending : kCadEndings) {
        if (boost::iends_with(file, ending)) return fs::is_regular_file(file);
    }
    return false;
}

/// The program's file: beside this one, else the first on the PATH. Throws std::runtime_error when there is none. cadFile: for the message.
std::string cadProgramFor(const std::string& cadFile) {
    std::error_code ignored;
    std::vector<fs::path> folders = {fs::read_symlink("/proc/self/exe", ignored).parent_path()};
    const char* const path = std::getenv("PATH");
    std::istringstream rest(path ? path : "");
    for (std::string folder; std::getline(rest, folder, ':');) folders.emplace_back(folder);
    for (const fs::path& folder : folders) {
        const fs::path file = folder / kCadProgram;
        if (fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return file.string();
    }
    const std::string mesh = fs::path(cadFile).replace_extension(".3mf").string();
    throw std::runtime_error(fmt::format(
        "'{}' holds surfaces, of which {} makes triangles, and that is neither in {}, where this program is, "
        "nor on "
        "the PATH, expected it there (its Debian package is {}; builds have it where "
        "libocct-data-exchange-dev is "
        "installed), or a mesh: {} '{}' --out '{}' on another machine, or an export from the CAD program",
        cadFile, kCadProgram, folders[0].string(), kCadProgram, kCadProgram, cadFile, mesh));
}

/// Runs a program without a shell. Returns its exit code, and what it writes to stderr; its rows are dropped.
std::pair<int, std::string> ran(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("cannot make a pipe to " + words[0]);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    pid_t child = 0;
    const int failed = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    std::string said;
    std::array<char, 4096> buffer{};
    for (ssize_t count = 0; !failed && (count = ::read(ends[0], buffer.data(), buffer.size())) > 0;)
        said.append(buffer.data(), static_cast<std::size_t>(count));
    ::close(ends[0]);
    int status = -1;
    if (failed || ::waitpid(child, &status, 0) != child) return {-1, "it cannot be run"};
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said};
}

std::string contentOf(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

Rows makeMeshesOfCad(std::vector<std::string*> files, const std::string& out) {
    Rows rows;
    std::map<std::string, std::string> made;  // by the new file, the old one
    for (std::string* const file : files) {
        if (!isCadFile(*file)) continue;
        const std::string program = cadProgramFor(*file);
        const fs::path name = fs::path(*file).filename().replace_extension(".3mf");
        const std::string mesh = (fs::path(out).parent_path() / name).string();
        const auto [entry, isNew] = made.emplace(mesh, *file);
        if (!isNew && entry->second != *file)
            throw std::runtime_error(quote(entry->second) + " and " + quote(*file) + " would both become " +
                                     quote(mesh) + ", expected files of different names");
        if (isNew) {
            const ElapsedLine elapsed("making triangles of " + *file);
            const std::string temporary = mesh + ".new.3mf";
            const auto [code, said] = ran({program, *file, "--out", temporary});
            if (code != 0) {
                const std::string reason =
                    boost::starts_with(said, kCadProgram) ? said.substr(said.find(' ') + 1) : said;
                throw std::runtime_error(std::string(kCadProgram) + " fails: " + boost::trim_copy(reason));
            }
            std::error_code isGone;
            const bool isKept = fs::exists(mesh, isGone) && contentOf(mesh) == contentOf(temporary);
            const auto old = isKept ? std::nullopt : setAside(mesh);
            fs::rename(temporary, mesh);
            rows.push_back({"made", mesh + " of " + *file +
                                        " by clearway-cad, which can be told another --deflection" +
                                        (old ? "; the old one is now " + *old : "")});
        }
        *file = mesh;
    }
    return rows;
}

}  // namespace clearway::cli
