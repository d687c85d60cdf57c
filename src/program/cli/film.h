// The film of `clearway render`: numbered pictures of the motion, a video, or both.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "clearway/scene_clearance.h"
#include "problem/path_line.h"
#include "program/options/command_line.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"
#include "program/render/render.h"

namespace clearway::cli {

/// The values of --frames, --video, --seconds and --fps.
struct FilmChoice {
    std::string frames, video;  ///< empty if the option is not given
    double seconds = 6;
    int rate = 20;  ///< pictures a second

    bool isWanted() const { return !frames.empty() || !video.empty(); }
    std::size_t pictureCount() const {
        return static_cast<std::size_t>(std::max(2L, std::lround(seconds * rate)));
    }

    /// Throws before long work when a film of this size cannot be written. states: of the path. picture: the
    /// file of --out, or empty.
    void require(const render::RenderOptions& drawing, std::size_t states, const std::string& picture,
                 OutputFiles& files) const;
};

/// Declares --frames, --video, --seconds and --fps. hasPath: asked when the options are read.
void addFilm(CommandLine& line, FilmChoice& film, const std::function<bool()>& hasPath);

/// The scene that a film shows.
struct FilmScene {
    const Mesh& part;
    const Mesh& environment;
    const PathLine& line;
    const SceneClearance& clearance;
    const std::vector<render::PosedPart>& way;
    ElapsedLine& elapsed;  ///< tells which picture is taken
};

/// Writes the film and prints a row for each output, and one about poses in contact. Returns false when
/// interrupted; then nothing is written.
bool writeFilm(const FilmChoice& film, const FilmScene& scene, const render::RenderOptions& drawing);

}  // namespace clearway::cli
