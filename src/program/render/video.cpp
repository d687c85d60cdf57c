#include "program/render/video.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace clearway::render {

namespace {

constexpr const char* kProgram = "ffmpeg";

/// ffmpeg's options for each ending, between its input and its output.
struct VideoKind {
    const char* ending;
    std::vector<std::string> options;
};

const std::vector<VideoKind>& videoKinds() {
    static const std::vector<VideoKind> kinds = {
        // Players want an even number of rows and columns, and colours at half the resolution. faststart lets
        // a browser begin before it has the whole file.
        {".mp4",
         {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-preset", "medium", "-crf",
          "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"}},
        // One palette for the whole film. Its pattern of dots stands still, so what does not move stays equal
        // from picture to picture and takes no room.
        {".gif",
         {"-filter_complex",
          "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=bayer:bayer_scale=3:"
          "diff_mode=rectangle",
          "-loop", "0", "-f", "gif"}},
    };
    return kinds;
}

std::vector<std::string> wordsFor(const std::string& file, const VideoFormat& format) {
    const auto kind = std::find_if(videoKinds().begin(), videoKinds().end(),
                                   [&](const VideoKind& known) { return format.ending == known.ending; });
    if (kind == videoKinds().end())
        throw std::invalid_argument("ending is '" + format.ending + "', expected .mp4 or .gif");
    std::vector<std::string> words = {kProgram, "-y",       "-loglevel", "error",
                                      "-f",     "rawvideo", "-pix_fmt",  "rgb24"};
    words.insert(words.end(), {"-s", std::to_string(format.width) + "x" + std::to_string(format.height), "-r",
                               std::to_string(format.rate), "-i", "-"});
    words.insert(words.end(), kind->options.begin(), kind->options.end());
    words.push_back("file:" + file);  // a name with a colon is no protocol of ffmpeg's
    return words;
}

[[noreturn]] void refuseSystem(const std::string& what, int reason) {
    throw std::runtime_error("cannot " + what + ": " + std::strerror(reason));
}

/// Runs the words with these files as standard input and error. The process is in a group of its own, so that
/// Ctrl-C reaches clearway alone, which then decides about the film.
pid_t spawned(const std::vector<std::string>& words, int input, int errors) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;  // clearway ignores these signals, and children would inherit that
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    sigaddset(&usual, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    pid_t process = -1;
    const int failed = posix_spawnp(&process, kProgram, &files, &attributes, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    if (failed != 0) refuseSystem(std::string("run ") + kProgram, failed);
    return process;
}

}  // namespace

const std::vector<std::string>& videoEndings() {
    static const std::vector<std::string> endings = [] {
        std::vector<std::string> all;
        for (const VideoKind& kind : videoKinds()) all.push_back(kind.ending);
        return all;
    }();
    return endings;
}

void requireFfmpeg() {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((folder + "/" + kProgram).c_str(), X_OK) == 0) return;
    }
    throw std::runtime_error(
        "the program ffmpeg is not in PATH, expected it for a film: install the package ffmpeg (sudo apt-get "
        "install ffmpeg), or write single pictures with --frames");
}

Video::Video(const std::string& file, const VideoFormat& format) : words_(std::tmpfile(), std::fclose) {
    if (!words_) refuseSystem("make a temporary file", errno);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) refuseSystem("make a pipe", errno);
    pictures_ = ends[1];
    try {
        process_ = spawned(wordsFor(file, format), ends[0], fileno(words_.get()));
    } catch (...) {
        close(ends[0]);
        close(ends[1]);
        throw;
    }
    close(ends[0]);
}

Video::~Video() {
    if (process_ > 0) kill(process_, SIGKILL);
    wait();
}

/// Closes the pipe, which ends the film, and waits for ffmpeg. Returns its status; 0 when it has been waited
/// for.
int Video::wait() {
    if (pictures_ >= 0) close(pictures_);
    pictures_ = -1;
    int status = 0;
    while (process_ > 0 && waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    return status;
}

void Video::fail() {
    wait();
    std::rewind(words_.get());
    std::string said;
    for (int character; (character = std::fgetc(words_.get())) != EOF;) said += static_cast<char>(character);
    throw std::runtime_error("ffmpeg cannot write the film" + (said.empty() ? "" : ": " + said));
}

void Video::add(const Image& picture) {
    const std::vector<std::uint8_t> bytes = bytesOf(picture);
    std::size_t written = 0;
    while (written < bytes.size()) {
        const ssize_t more = write(pictures_, &bytes[written], bytes.size() - written);
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) fail();
        written += static_cast<std::size_t>(more);
    }
}

void Video::finish() {
    if (wait() != 0) fail();
}

}  // namespace clearway::render
