// The pictures of a motion from one camera. The environment, the start, the goal and the way stand still;
// their surfaces, trees and rays serve all pictures.
#pragma once

#include <memory>

#include "program/render/render.h"

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
    /// Throws std::invalid_argument that names the wrong option.
    Film(const Mesh& part, const Mesh& environment, FilmCast cast, RenderOptions options);
    ~Film();

    /// The picture with the part at this pose. Without pixels if stopped.
    Image picture(const PosedPart& pose);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace clearway::render
