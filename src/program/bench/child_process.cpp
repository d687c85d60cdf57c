#include "program/bench/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

extern "C" char** environ;

namespace clearway::study {
namespace {

/// Beginnings of the variables by which MPI's libraries know that a process is a rank, and which one.
constexpr const char* kPrefixesOfRanks[] = {"OMPI_", "PMIX_", "PMI_", "ORTE_", "PRTE_", "OPAL_", "MPI_LOCAL"};

std::vector<char*> environmentWithoutRank() {
    std::vector<char*> kept;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        bool isOfRank = false;
        for (const char* prefix : kPrefixesOfRanks)
            isOfRank = isOfRank || std::strncmp(*variable, prefix, std::strlen(prefix)) == 0;
        if (!isOfRank) kept.push_back(*variable);
    }
    kept.push_back(nullptr);
    return kept;
}

/// A pipe whose ends no other child inherits.
struct Pipe {
    int ends[2] = {-1, -1};  ///< to read from, to write to
    Pipe() {
        if (::pipe2(ends, O_CLOEXEC) != 0)
            throw std::runtime_error(std::string("no pipe can be made: ") + std::strerror(errno));
    }
    ~Pipe() {
        for (const int end : ends) {
            if (end >= 0) ::close(end);
        }
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    int takeReader() {
        const int reader = ends[0];
        ends[0] = -1;
        return reader;
    }
};

/// The new process's standard streams: no input, output and errors into pipes.
struct Streams {
    posix_spawn_file_actions_t actions;
    Streams(const Pipe& out, const Pipe& err) {
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, err.ends[1], STDERR_FILENO);
    }
    ~Streams() { posix_spawn_file_actions_destroy(&actions); }
    Streams(const Streams&) = delete;
    Streams& operator=(const Streams&) = delete;
};

std::string lastLine(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

}  // namespace

// Not fork: a process that talks to others by MPI must not be copied.
ChildProcess::ChildProcess(const std::vector<std::string>& words) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    std::vector<std::string> all = {program};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : all) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    Pipe out, err;
    const Streams streams(out, err);
    const int failed = ::posix_spawn(&process_, program.c_str(), &streams.actions, nullptr, arguments.data(),
                                     environmentWithoutRank().data());
    if (failed != 0) {
        throw std::runtime_error("no process of '" + program + "' can be started: " + std::strerror(failed));
    }
    pipes_ = {out.takeReader(), err.takeReader()};
}

ChildProcess::~ChildProcess() {
    closeAll();
    if (hasEnded_) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, &status_, 0);
}

bool ChildProcess::hasEnded(int milliseconds) {
    if (hasEnded_) return true;
    std::string* const texts[] = {&out_, &err_};
    pollfd waited[] = {{pipes_[0], POLLIN, 0}, {pipes_[1], POLLIN, 0}};  // poll leaves out those that are -1
    if (::poll(waited, 2, milliseconds) < 0 && errno != EINTR)
        throw std::runtime_error(std::string("a process cannot be waited for: ") + std::strerror(errno));
    for (std::size_t i = 0; i < pipes_.size(); ++i) {
        if (pipes_[i] < 0 || waited[i].revents == 0) continue;
        char block[1 << 16];
        const ssize_t size = ::read(pipes_[i], block, sizeof block);
        if (size > 0) texts[i]->append(block, static_cast<std::size_t>(size));
        if (size < 0 && errno != EINTR)
            throw std::runtime_error(std::string("a process's output cannot be read: ") +
                                     std::strerror(errno));
        if (size == 0) {
            ::close(pipes_[i]);
            pipes_[i] = -1;
        }
    }
    if (pipes_[0] >= 0 || pipes_[1] >= 0) return false;
    while (::waitpid(process_, &status_, 0) < 0 && errno == EINTR) continue;
    return hasEnded_ = true;
}

void ChildProcess::waitForEnd() {
    while (!hasEnded(-1)) continue;
}

bool ChildProcess::isDone() const {
    return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

int ChildProcess::signal() const {
    return WIFSIGNALED(status_) ? WTERMSIG(status_) : 0;
}

std::string ChildProcess::fault() const {
    const std::string last = lastLine(err_);
    const std::string end =
        signal() != 0 ? "ended by signal " + std::to_string(signal()) + " (" + ::strsignal(signal()) + ")"
                      : "exit code " + std::to_string(WEXITSTATUS(status_));
    return end + (last.empty() ? "" : ": " + last);
}

void ChildProcess::closeAll() {
    for (int& pipe : pipes_) {
        if (pipe >= 0) ::close(pipe);
        pipe = -1;
    }
}

void endWithParent() {
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (::getppid() == 1) std::exit(1);  // the parent ended before
}

}  // namespace clearway::study
