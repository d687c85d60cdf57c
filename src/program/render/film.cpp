#include "program/render/film.h"

namespace clearway::render {

Film::Film(const Mesh& part, const Mesh& environment, FilmCast cast, RenderOptions options)
    : cast_(std::move(cast)),
      options_(std::move(options)),
      arrangement_(part, environment, {cast_.still, cast_.framed, cast_.way}, options_),
      mover_(arrangement_.addMover()) {
    Body body = arrangement_.bodyOf(cast_.framed.front());
    body.shape = alone_.addShape(arrangement_.partSurface());
    alone_.addBody(body);
    if (!Plate::canHold(arrangement_.exposure())) return;
    arrangement_.stages().solids.showBody(mover_, false);
    arrangement_.finish();
    plate_.emplace(arrangement_.stages(), arrangement_.camera(), arrangement_.exposure());
    arrangement_.stages().solids.showBody(mover_, true);
}

Image Film::taken(const Body& body) {
    arrangement_.stages().solids.changeBody(mover_, body);
    arrangement_.finish();
    if (!plate_) return expose(arrangement_.stages(), arrangement_.camera(), arrangement_.exposure());
    alone_.changeBody(0, body);
    alone_.finish();
    return plate_->with(alone_.rays(), arrangement_.areaOf(body.placement));
}

Image Film::picture(const PosedPart& pose) {
    Image image = taken(arrangement_.bodyOf(pose));
    if (options_.isStopped()) return Image(0, 0, Colour::Zero());
    arrangement_.drawOver(image, {pose});
    return image;
}

}  // namespace clearway::render
