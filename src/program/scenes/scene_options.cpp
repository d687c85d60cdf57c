#include "program/scenes/scene_options.h"

#include <sstream>
#include <stdexcept>

namespace clearway::scenes {

void requireClearance(double clearance, double least, double most) {
    if (clearance >= least && clearance <= most) return;
    std::ostringstream message;
    message << "clearance is " << clearance << ", expected " << least << " to " << most << " (millimetres)";
    throw std::invalid_argument(message.str());
}

}  // namespace clearway::scenes
