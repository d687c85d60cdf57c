// Encodes pictures as a film, by the program ffmpeg. It is run, not linked: a machine without it lacks films
// alone.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "program/render/image.h"

namespace clearway::render {

/// The kinds of films, by the endings of their files: H.264 for players, GIF for pages.
const std::vector<std::string>& videoEndings();  // ".mp4", ".gif"

/// Throws std::runtime_error that names the package to install unless ffmpeg is in PATH.
void requireFfmpeg();

struct VideoFormat {
    std::string ending;  ///< one of videoEndings(), lower case
    int width, height;   ///< pixels
    int rate;            ///< pictures a second
};

class Video {
  public:
    /// Starts ffmpeg, which writes the file, whatever its ending.
    Video(const std::string& file, const VideoFormat& format);
    /// Ends ffmpeg; the file is then of no use unless finish() has returned.
    ~Video();
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    /// Throws std::runtime_error with ffmpeg's words when it fails, as finish() does.
    void add(const Image& picture);
    /// Waits until the file is complete.
    void finish();

  private:
    int wait();
    [[noreturn]] void fail();

    pid_t process_ = -1;
    int pictures_ = -1;                                                            ///< the pipe to ffmpeg
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> words_{nullptr, std::fclose};  ///< what ffmpeg says
};

}  // namespace clearway::render
