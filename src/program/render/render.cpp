#include "program/render/render.h"

#include <stdexcept>

#include "program/render/arrangement.h"
#include "program/render/exposure.h"

namespace clearway::render {

Image render(const Mesh& part, const Mesh& environment, const std::vector<PosedPart>& poses,
             const std::vector<PosedPart>& way, const RenderOptions& options) {
    if (poses.empty()) throw std::invalid_argument("there is no pose to show, expected at least 1");
    Arrangement arrangement(part, environment, {poses, poses, way}, options);
    arrangement.finish();
    Image image = expose(arrangement.stages(), arrangement.camera(), arrangement.exposure());
    if (options.isStopped()) return Image(0, 0, Colour::Zero());
    arrangement.drawOver(image, poses);
    return image;
}

}  // namespace clearway::render
