#include "program/cli/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "core/replace_file.h"
#include "program/cli/frames_folder.h"
#include "program/cli/render.h"
#include "program/options/facts.h"
#include "program/render/film.h"

namespace clearway::cli {

namespace {

constexpr double kMostSeconds = 600;
constexpr int kMostRate = 60,
              kMostGifRate = 50;          ///< the time of a GIF's picture is whole hundredths of a second
constexpr int kLargestFilmSide = 4096;    ///< pixels; common players decode no more
constexpr double kMostGifBytes = 2e9;     ///< ffmpeg keeps all pictures of a GIF, in 4 bytes a pixel
constexpr std::size_t kFramedPoses = 25;  ///< poses that the camera keeps in the picture

struct VideoKind {
    const char *ending, *options;  ///< of the file; of ffmpeg
};

constexpr VideoKind kVideoKinds[] = {
    // Players want an even number of rows and columns, and colours at half the resolution. faststart lets a browser begin
    // before it has the whole file.
    {".mp4",
     "-vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white' -c:v libx264 -crf 18 -pix_fmt yuv420p "
     "-movflags +faststart -f mp4"},
    // One palette for the whole film. Its pattern of dots stands still, so what does not move stays equal from picture to
    // picture and takes no room.
    {".gif",
     "-filter_complex 'split[a][b];[a]palettegen=stats_mode=full[p];"
     "[b][p]paletteuse=dither=bayer:bayer_scale=3:diff_mode=rectangle' -loop 0 -f gif"},
};

std::string endingOf(const std::string& file) {
    return boost::to_lower_copy(std::filesystem::path(file).extension().string());
}

std::string sizeText(const render::RenderOptions& drawing) {
    return fmt::format("{} x {}", drawing.width, drawing.height);
}

void requireSize(const FilmChoice& film, const render::RenderOptions& drawing) {
    if (film.video.empty()) return;
    if (std::max(drawing.width, drawing.height) > kLargestFilmSide) {
        throw std::invalid_argument(fmt::format("--size is {}, expected at most {} pixels a side for --video",
                                                sizeText(drawing), kLargestFilmSide));
    }
    if (endingOf(film.video) != ".gif") return;
    if (film.rate > kMostGifRate) {
        throw std::invalid_argument(
            fmt::format("--fps is {}, expected at most {} for a GIF", film.rate, kMostGifRate));
    }
    const double bytes = 4.0 * drawing.width * drawing.height * static_cast<double>(film.pictureCount());
    if (bytes > kMostGifBytes) {
        throw std::invalid_argument(
            counted(film.pictureCount(), "picture") + " of " + sizeText(drawing) +
            " are too much for a GIF, expected a smaller --size, fewer --seconds, or .mp4");
    }
}

/// Refuses a file in the folder of --frames, which is replaced.
void requireOutside(const std::string& option, const std::string& file, const std::string& folder) {
    if (file.empty() || folder.empty()) return;
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path above = fs::weakly_canonical(fs::absolute(file, failed), failed).parent_path();
    if (above != fs::weakly_canonical(fs::absolute(folder, failed) / "file", failed).parent_path()) return;
    throw std::invalid_argument(option + " is '" + file +
                                "', in the folder of --frames, expected another folder");
}

/// Poses at even shares of the path, as single pictures of a film show them: neither start nor goal.
std::vector<render::PosedPart> evenPoses(const FilmScene& scene, std::size_t count) {
    auto poses = posesAt(scene.line, evenShares(count), scene.clearance, false);
    for (render::PosedPart& pose : poses) pose.role = render::PoseRole::kBetween;
    return poses;
}

render::FilmCast castOf(const FilmScene& scene) {
    render::FilmCast cast{posesAt(scene.line, {0, 1}, scene.clearance, false), evenPoses(scene, kFramedPoses),
                          scene.way};
    for (render::PosedPart& end : cast.still) end.isGhost = true;
    return cast;
}

void printContacts(const std::vector<render::PosedPart>& poses) {
    const auto isInContact = [](const render::PosedPart& pose) { return pose.isInContact; };
    const auto count = std::count_if(poses.begin(), poses.end(), isInContact);
    if (count == 0) return;
    const auto first = std::find_if(poses.begin(), poses.end(), isInContact);
    const double share = double(first - poses.begin()) / double(std::max<std::size_t>(1, poses.size() - 1));
    printRow("in contact", fmt::format("{} of {}: IN COLLISION or too close, first at {}",
                                       counted(static_cast<std::size_t>(count), "picture"), poses.size(),
                                       readable(std::round(1000 * share) / 1000)));
}

/// Takes all pictures. Returns false when interrupted.
bool takePictures(render::Film& film, const std::vector<render::PosedPart>& poses, const FramesFolder& folder,
                  ElapsedLine& elapsed) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
        elapsed.tell(fmt::format("picture {} of {},", i + 1, poses.size()));
        const render::Image picture = film.picture(poses[i]);
        if (picture.pixels.empty()) return false;
        render::writePng(picture, folder.fileOf(i + 1));
    }
    return true;
}

/// Throws std::runtime_error that names the package to install unless ffmpeg is in PATH.
void requireFfmpeg() {
    if (std::system("command -v ffmpeg > /dev/null 2>&1") == 0) return;
    throw std::runtime_error(
        "the program ffmpeg is not in PATH, expected it for a film: install the package ffmpeg (sudo apt-get "
        "install ffmpeg), or write single pictures with --frames");
}

/// As one word for a shell.
std::string quoted(const std::string& word) {
    return "'" + boost::replace_all_copy(word, "'", "'\\''") + "'";
}

/// Makes the pictures a film, by the program ffmpeg. Returns false when interrupted, as ffmpeg is by Ctrl-C, too. Throws
/// std::runtime_error with its words when it fails.
bool encode(const FramesFolder& folder, const FilmChoice& film, const std::string& file,
            const std::function<bool()>& isStopped) {
    const auto kind =
        std::find_if(std::begin(kVideoKinds), std::end(kVideoKinds),
                     [&](const VideoKind& known) { return known.ending == endingOf(film.video); });
    // A name with a colon is no protocol of ffmpeg's, nor one that begins with a dash an option.
    const std::string command =
        fmt::format("ffmpeg -nostdin -y -loglevel error -framerate {} -i {} {} {} 2>&1", film.rate,
                    quoted("file:" + folder.pattern()), kind->options, quoted("file:" + file));
    std::FILE* const ffmpeg = popen(command.c_str(), "r");
    if (ffmpeg == nullptr)
        throw std::runtime_error("cannot run ffmpeg: " + std::string(std::strerror(errno)));
    std::string said;
    for (int character; (character = std::fgetc(ffmpeg)) != EOF;) said += static_cast<char>(character);
    const int status = pclose(ffmpeg);
    if (isStopped()) return false;
    if (status != 0 || !std::filesystem::exists(file))
        throw std::runtime_error("ffmpeg cannot write the film: " + said);
    return true;
}

/// With --video alone the pictures are in a folder beside the film until it is done.
FramesFolder folderOf(const FilmChoice& film) {
    if (film.frames.empty()) return FramesFolder::beside(film.video);
    return FramesFolder(film.frames);
}

}  // namespace

void FilmChoice::require(const render::RenderOptions& drawing, std::size_t states, const std::string& picture,
                         OutputFiles& files) const {
    if (!isWanted()) return;
    if (frames == "-") throw std::invalid_argument("--frames is '-', expected the name of a folder");
    std::vector<std::string> endings;
    for (const VideoKind& kind : kVideoKinds) endings.emplace_back(kind.ending);
    files.add("--video", video, endings);
    requireOutside("--video", video, frames);
    requireOutside("--out", picture, frames);
    if (states < 2)
        throw std::invalid_argument("the path has 1 state, expected at least 2 for --frames or --video");
    requireSize(*this, drawing);
    const FramesFolder canBeMade = folderOf(*this);
    if (!video.empty()) requireFfmpeg();
}

void addFilm(CommandLine& line, FilmChoice& film, const std::function<bool()>& hasPath) {
    const auto withPath = [hasPath](std::string& to) {
        return [&to, hasPath](const std::string& value) {
            if (!hasPath()) throw Expected{"only with a path file beside the problem"};
            to = value;
        };
    };
    const auto ofFilm = [&film](const Reader& read) {
        return [&film, read](const std::string& value) {
            if (!film.isWanted()) throw Expected{"only with --frames or --video"};
            read(value);
        };
    };
    line.option("--frames DIR", "a folder of numbered PNG files: the motion, picture by picture",
                withPath(film.frames));
    line.option("--video FILE", "the motion as a film, .mp4 or .gif; runs the program ffmpeg",
                withPath(film.video));
    line.option("--seconds S", "length of the film (6)", ofFilm([&film](const std::string& text) {
                    film.seconds = positiveNumber(text);
                    if (film.seconds > kMostSeconds)
                        throw Expected{"a number above 0, at most " + readable(kMostSeconds)};
                }));
    line.option("--fps N", "pictures of the film in a second (20)",
                ofFilm(integer<int>(film.rate, 1, kMostRate)));
}

bool writeFilm(const FilmChoice& film, const FilmScene& scene, const render::RenderOptions& drawing) {
    FramesFolder folder = folderOf(film);
    const std::vector<render::PosedPart> poses = evenPoses(scene, film.pictureCount());
    printContacts(poses);
    render::Film pictures(scene.part, scene.environment, castOf(scene), drawing);
    bool isDone = takePictures(pictures, poses, folder, scene.elapsed);
    const auto keepFrames = [&] {
        if (!film.frames.empty()) folder.keep();
    };
    if (isDone && !film.video.empty()) {
        scene.elapsed.tell("ffmpeg,");
        try {
            isDone = replaceFileByName(film.video, [&](const std::string& temporary) {
                return encode(folder, film, temporary, drawing.isStopped);
            });
        } catch (const std::exception&) {
            keepFrames();  // they are whole
            throw;
        }
    }
    if (isDone) keepFrames();
    const std::string told = counted(poses.size(), "picture") + " of " + sizeText(drawing);
    const auto tellFile = [&](const std::string& name, const std::string& file, const std::string& shown) {
        Fact fact = shownIf(!file.empty(), {name, isDone ? shown : "none, interrupted"});
        if (isDone) {
            fact.name = name;
            fact.value = file.empty() ? Json() : Json(file);
        }
        tell({fact});
    };
    tellFile("frames", film.frames, film.frames + ", " + told);
    tellFile("video", film.video, fmt::format("{}, {}, {} a second", film.video, told, film.rate));
    return isDone;
}

}  // namespace clearway::cli
