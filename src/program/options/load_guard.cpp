#include "program/options/load_guard.h"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "program/options/command_line.h"
#include "program/options/print.h"

namespace clearway::cli {

namespace {

constexpr int kCrashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr std::size_t kStackBytes = 1 << 16;
constexpr int kLeastSeconds = 20;
constexpr double kSlowestBytesPerSecond = 1e5;  ///< assimp reads text a hundred times faster

// The lines are made beforehand, because a signal handler may do little.
std::string crashLine;
std::string overtimeLine;

extern "C" void endProgram(int signal) {
    const std::string& line = signal == SIGPROF ? overtimeLine : crashLine;
    const char* from = line.data();
    for (std::size_t left = line.size(); left > 0;) {
        const ssize_t written = ::write(STDERR_FILENO, from, left);
        if (written <= 0) break;
        from += written;
        left -= static_cast<std::size_t>(written);
    }
    ::_exit(kBadInput);
}

std::string lineAbout(const std::string& file, const GuardedReader& reader, const std::string& fault) {
    return oneLine(fmt::format("{}: cannot read {} '{}': the reader ({}) {}, expected a sound file",
                               reader.program, reader.kind, file, reader.library, fault)) +
           "\n";
}

Sink sink;

}  // namespace

LoadGuard::LoadGuard(const std::string& file, int seconds, const GuardedReader& reader)
    : stack_(kStackBytes) {
    crashLine = lineAbout(file, reader, "crashed");
    overtimeLine =
        lineAbout(file, reader, "had not ended after " + std::to_string(seconds) + " s of computing");
    std::cout.flush();  // _exit would lose the buffered output
    out_ = std::cout.rdbuf(&sink);
    err_ = std::cerr.rdbuf(&sink);

    stack_t stack = {};
    stack.ss_sp = stack_.data();
    stack.ss_size = stack_.size();
    sigaltstack(&stack, &previousStack_);
    struct sigaction action = {};
    action.sa_handler = endProgram;
    action.sa_flags = SA_ONSTACK;
    const auto handle = [&](int signal) {
        previous_.push_back({signal, {}});
        sigaction(signal, &action, &previous_.back().action);
    };
    for (const int signal : kCrashes) handle(signal);
    handle(SIGPROF);
    setTimer(seconds);
}

LoadGuard::~LoadGuard() {
    setTimer(0);
    for (const Previous& before : previous_) sigaction(before.signal, &before.action, nullptr);
    sigaltstack(&previousStack_, nullptr);
    std::cerr.rdbuf(err_);
    std::cout.rdbuf(out_);
}

void LoadGuard::setTimer(int seconds) {
    itimerval timer = {};
    timer.it_value.tv_sec = seconds;
    setitimer(ITIMER_PROF, &timer, nullptr);
}

int secondsToLoad(const std::string& file) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    if (error) return kLeastSeconds;
    return kLeastSeconds +
           static_cast<int>(std::min(static_cast<double>(bytes) / kSlowestBytesPerSecond, 1e8));
}

Mesh guardedLoadMesh(const std::string& file, const LoadOptions& options) {
    const LoadGuard guard(file, secondsToLoad(file));
    return loadMesh(file, options);
}

}  // namespace clearway::cli
