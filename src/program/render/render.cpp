#include "program/render/render.h"

#include <cmath>
#include <stdexcept>

#include "program/render/arrangement.h"
#include "program/render/exposure.h"

namespace clearway::render {

void requireOptions(const RenderOptions& options) {
    const auto refuse = [](const std::string& what, double value, const std::string& expected) {
        throw std::invalid_argument(what + " is " + std::to_string(value) + ", expected " + expected);
    };
    if (options.width < 16) refuse("width", options.width, "at least 16 pixels");
    if (options.height < 16) refuse("height", options.height, "at least 16 pixels");
    if (options.samples < 1) refuse("samples", options.samples, "at least 1");
    if (!(options.angle > 0 && options.angle < 170)) refuse("angle", options.angle, "0 to 170 degrees");
    if (options.cut && std::abs(options.cut->normal.norm() - 1) > 1e-6)
        refuse("length of the cut's normal", options.cut->normal.norm(), "1");
    if (options.scaleMost && !(*options.scaleMost > 0))
        refuse("scale", *options.scaleMost, "a clearance above 0");
}

Image render(const Mesh& part, const Mesh& environment, const std::vector<PosedPart>& poses,
             const std::vector<PosedPart>& way, const RenderOptions& options) {
    requireOptions(options);
    if (poses.empty()) throw std::invalid_argument("there is no pose to show, expected at least 1");
    Arrangement arrangement(part, environment, {poses, poses, way}, options);
    arrangement.finish();
    Image image = expose(arrangement.stages(), arrangement.camera(), arrangement.exposure());
    if (options.isStopped()) return Image(0, 0, Colour::Zero());
    arrangement.drawOver(image, poses);
    return image;
}

}  // namespace clearway::render
