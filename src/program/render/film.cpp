#include "program/render/film.h"

#include <optional>
#include <stdexcept>

#include "program/render/arrangement.h"
#include "program/render/plate.h"

namespace clearway::render {

struct Film::State {
    FilmCast cast;
    RenderOptions options;
    Arrangement arrangement;
    std::size_t mover;
    Stage alone;                 ///< the mover without anything else
    std::optional<Plate> plate;  ///< without the mover; none when its rays would take too much memory

    State(const Mesh& part, const Mesh& environment, FilmCast&& poses, RenderOptions&& drawing)
        : cast(std::move(poses)),
          options(std::move(drawing)),
          arrangement(part, environment, {cast.still, cast.framed, cast.way}, options),
          mover(arrangement.addMover()) {
        Body body = arrangement.bodyOf(cast.framed.front());
        body.shape = alone.addShape(arrangement.partSurface());
        alone.addBody(body);
        if (!Plate::canHold(arrangement.exposure())) return;
        arrangement.stages().solids.showBody(mover, false);
        arrangement.finish();
        plate.emplace(arrangement.stages(), arrangement.camera(), arrangement.exposure());
        arrangement.stages().solids.showBody(mover, true);
    }

    Image taken(const Body& body) {
        arrangement.stages().solids.changeBody(mover, body);
        arrangement.finish();
        if (!plate) return expose(arrangement.stages(), arrangement.camera(), arrangement.exposure());
        alone.changeBody(0, body);
        alone.finish();
        return plate->with(alone.rays(), arrangement.areaOf(body.placement));
    }
};

Film::Film(const Mesh& part, const Mesh& environment, FilmCast cast, RenderOptions options) {
    requireOptions(options);
    if (cast.framed.empty()) throw std::invalid_argument("there is no pose to show, expected at least 1");
    state_ = std::make_unique<State>(part, environment, std::move(cast), std::move(options));
}

Film::~Film() = default;

Image Film::picture(const PosedPart& pose) {
    Image image = state_->taken(state_->arrangement.bodyOf(pose));
    if (state_->options.isStopped()) return Image(0, 0, Colour::Zero());
    state_->arrangement.drawOver(image, {pose});
    return image;
}

}  // namespace clearway::render
