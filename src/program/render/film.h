// The pictures of a motion from one camera. The environment, the start, the goal and the way stand still;
// their surfaces, trees and rays serve all pictures.
#pragma once

#include <optional>

#include "program/render/arrangement.h"
#include "program/render/plate.h"

namespace clearway::render {

/// The poses that a film begins from.
struct FilmCast {
    std::vector<PosedPart> still;  ///< stand in every picture, the start and the goal, say
    std::vector<PosedPart>
        framed;                  ///< poses along the way, at least one: the camera keeps them in the picture
    std::vector<PosedPart> way;  ///< a line is drawn through them
};

class Film {
  public:
    /// Throws std::invalid_argument when there is no such view, or the camera stands at the point it looks at.
    Film(const Mesh& part, const Mesh& environment, FilmCast cast, RenderOptions options);
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// The picture with the part at this pose. Without pixels if stopped.
    Image picture(const PosedPart& pose);

  private:
    Image taken(const Body& body);

    const FilmCast cast_;
    const RenderOptions options_;
    Arrangement arrangement_;
    std::size_t mover_;
    Stage alone_;                 ///< the mover without anything else
    std::optional<Plate> plate_;  ///< without the mover; none when its rays would take too much memory
};

}  // namespace clearway::render
