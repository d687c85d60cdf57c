// The legend at the right side of a picture: the colour scale of clearances, and the signs that the picture
// uses.
#pragma once

#include <string>
#include <vector>

#include "program/render/camera.h"
#include "program/render/image.h"
#include "program/render/render.h"

namespace clearway::render {

/// The things beside the environment that a picture may show.
enum class Sign { kStart, kGoal, kBetween, kMoving, kWay, kContact, kOverlap, kMeeting };

/// The words of a sign in the legend.
std::string wordsOf(Sign sign);

/// The signs for these poses of the part; hasMover: one more pose changes from picture to picture.
std::vector<Sign> signsOf(const std::vector<PosedPart>& poses, bool hasMover);

struct Legend {
    double most = 1;                  ///< clearance at the top of the scale
    bool isCutOff = false;            ///< larger clearances have the colour at the top too
    std::string title = "clearance";  ///< above the scale
    std::string unit;                 ///< of the clearances; empty: unknown
    std::vector<double> clearances;   ///< marked beside the scale
    std::vector<Sign> signs;          ///< explained below the scale
};

/// The area of the picture that the legend leaves to the scene.
Area areaBesideLegend(int width, int height);

void drawLegend(const Legend& legend, Image& image);

}  // namespace clearway::render
