#include "demos/study/workers.h"

#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <new>
#include <stdexcept>

namespace clearway::study {
namespace {

constexpr int kLookMilliseconds = 200;  ///< between two looks at isStopped

/// The first character of a line from a worker.
constexpr char kKept = 'k', kTold = 't', kEnded = 'e', kStopped = 's', kFailed = 'f';

std::vector<std::size_t> usableProcessors() {
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<std::size_t> all;
    if (sched_getaffinity(0, sizeof set, &set) != 0) return all;
    for (std::size_t i = 0; i < CPU_SETSIZE; ++i) {
        if (CPU_ISSET(i, &set)) all.push_back(i);
    }
    return all;
}

/// Returns false when the reader is gone.
bool writeAll(int file, std::string text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) text.erase(0, static_cast<std::size_t>(written));
    }
    return true;
}

/// Moves the first line, without its end, out of the text. Returns false when there is none.
bool takeLine(std::string& text, std::string& line) {
    const std::size_t end = text.find('\n');
    if (end == std::string::npos) return false;
    line = text.substr(0, end);
    text.erase(0, end + 1);
    return true;
}

/// Appends what the file has. Returns false at its end.
bool readSome(int file, std::string& text) {
    std::array<char, 65536> buffer{};
    ssize_t read = 0;
    do {
        read = ::read(file, buffer.data(), buffer.size());
    } while (read < 0 && errno == EINTR);
    if (read <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(read));
    return true;
}

}  // namespace

Workers::Workers(std::size_t count, const DoJob& doJob) {
    const std::vector<std::size_t> processors = usableProcessors();
    const std::size_t most = std::max<std::size_t>(processors.size(), 1);
    count = count == 0 ? most : std::min(count, most);
    void* const shared =
        mmap(nullptr, sizeof(std::atomic<bool>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("cannot share memory with other processes");
    isStopped_ = new (shared) std::atomic<bool>(false);
    signal(SIGPIPE, SIG_IGN);  // a write to a process that died fails instead
    for (std::size_t i = 0; i < count; ++i) start(processors.empty() ? CPU_SETSIZE : processors[i], doJob);
}

void Workers::start(std::size_t processor, const DoJob& doJob) {
    std::array<int, 2> to{}, from{};
    if (pipe(to.data()) != 0 || pipe(from.data()) != 0)
        throw std::runtime_error("cannot open pipes to another process");
    const pid_t parent = getpid(), process = fork();
    if (process < 0) throw std::runtime_error("cannot start another process");
    if (process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) _exit(1);  // it died before the line above
        signal(SIGINT, SIG_IGN);            // Ctrl-C reaches all processes; the first one decides
        signal(SIGTERM, SIG_DFL);
        close(to[1]);
        close(from[0]);
        for (const Worker& other : workers_) {
            close(other.toIt);
            close(other.fromIt);
        }
        serve(processor, to[0], from[1], doJob);
    }
    close(to[0]);
    close(from[1]);
    workers_.push_back({process, to[1], from[0], {}, {}});
}

Workers::~Workers() {
    for (const Worker& worker : workers_) {
        close(worker.toIt);
        close(worker.fromIt);
        kill(worker.process, SIGKILL);
    }
    for (const Worker& worker : workers_) waitpid(worker.process, nullptr, 0);
    munmap(isStopped_, sizeof *isStopped_);
}

void Workers::serve(std::size_t processor, int in, int out, const DoJob& doJob) {
    cpu_set_t one;
    CPU_ZERO(&one);
    if (processor < CPU_SETSIZE) {
        CPU_SET(processor, &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    const auto send = [out](char kind, std::string text) {
        std::replace(text.begin(), text.end(), '\n', ' ');
        if (!writeAll(out, kind + text + "\n")) _exit(1);
    };
    Job job{{},
            [&](const std::string& line) { send(kKept, line); },
            [&](const std::string& line) { send(kTold, line); },
            [this] { return isStopped_->load(); }};
    std::string received;
    for (;;) {
        while (!takeLine(received, job.text)) {
            if (!readSome(in, received)) _exit(0);
        }
        try {
            send(doJob(job) ? kEnded : kStopped, "");
        } catch (const std::exception& error) {
            send(kFailed, error.what());
        }
    }
}

bool Workers::share(const std::vector<std::string>& jobs, const std::function<void(const std::string&)>& take,
                    const std::function<void(const std::string&)>& tell, const std::function<void()>& ended,
                    const std::function<bool()>& isStopped) {
    std::size_t next = 0;
    bool wasStopped = false;
    std::string failure;
    for (;;) {
        if (!wasStopped && isStopped && isStopped()) {
            wasStopped = true;
            *isStopped_ = true;
        }
        std::vector<pollfd> waited;
        std::vector<Worker*> busy;
        for (Worker& worker : workers_) {
            if (worker.job.empty() && next < jobs.size() && !wasStopped && failure.empty()) {
                worker.job = jobs[next++];
                writeAll(worker.toIt, worker.job + "\n");  // a failure shows as the end of its answers
            }
            if (worker.job.empty()) continue;
            waited.push_back({worker.fromIt, POLLIN, 0});
            busy.push_back(&worker);
        }
        if (busy.empty()) break;
        if (poll(waited.data(), waited.size(), kLookMilliseconds) <= 0) continue;
        for (std::size_t i = 0; i < busy.size(); ++i) {
            if (waited[i].revents == 0) continue;
            Worker& worker = *busy[i];
            if (!readSome(worker.fromIt, worker.received))
                throw std::runtime_error("a process of the study died during the job '" + worker.job + "'");
            for (std::string line; takeLine(worker.received, line);) {
                const std::string text = line.substr(1);
                if (line[0] == kKept) take(text);
                if (line[0] == kTold) tell(text);
                if (line[0] == kFailed) failure = text;
                if (line[0] == kStopped) wasStopped = true;
                if (line[0] == kKept || line[0] == kTold) continue;
                worker.job.clear();
                ended();
            }
        }
    }
    if (!failure.empty()) throw std::runtime_error(failure);
    return !wasStopped;
}

}  // namespace clearway::study
