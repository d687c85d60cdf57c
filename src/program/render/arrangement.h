// Sets up the stage and the camera of a picture from its options. The stage has a diagonal of 1.
#pragma once

#include <vector>

#include "program/render/camera.h"
#include "program/render/exposure.h"
#include "program/render/outlines.h"
#include "program/render/render.h"
#include "program/render/stage.h"

namespace clearway::render {

/// Maps environment coordinates to those of the stage, in which the environment has a diagonal of 1.
struct StageFrame {
    Vector3 centre;
    double scale;

    explicit StageFrame(const Box& environment);
    Vector3 operator()(const Vector3& point) const { return scale * (point - centre); }
    Placement operator()(const Pose& pose, const Vector3& partCentre) const;
    CutPlane operator()(const CutPlane& plane) const;
};

/// The poses of a picture or film.
struct Cast {
    const std::vector<PosedPart>& drawn;   ///< stand in the picture
    const std::vector<PosedPart>& framed;  ///< the camera keeps them in the picture
    const std::vector<PosedPart>& way;     ///< a line is drawn through them
};

class Arrangement {
  public:
    /// The arguments but for the meshes must outlive the arrangement.
    Arrangement(const Mesh& part, const Mesh& environment, const Cast& cast, const RenderOptions& options);

    /// Adds a solid body of the part, which a film moves. Returns its number among the solids.
    std::size_t addMover();
    Stages& stages() { return stages_; }
    /// To be called after all changes of the stages and before a picture is taken.
    void finish();

    const Camera& camera() const { return camera_; }
    const Exposure& exposure() const { return exposure_; }
    const Surface& partSurface() const { return partSurface_; }
    Body bodyOf(const PosedPart& pose) const;
    /// The pixels that the part at this place can hide.
    PixelArea areaOf(const Placement& placement) const;

    /// Draws rings, axes and the legend, which marks the clearances of these poses.
    void drawOver(Image& image, const std::vector<PosedPart>& marked) const;

  private:
    Placement placementOf(const PosedPart& pose) const {
        return frame_(poseOf(pose.state), partBox_.center());
    }
    void chooseDirection();
    void cutEnvironment();
    void chooseCamera();
    void chooseExposure();
    void addPath();
    void addBodies(const Mesh& environment);

    const RenderOptions& options_;
    const Cast cast_;
    Box partBox_;
    StageFrame frame_;
    double most_;           ///< clearance at the top of the scale
    double mostClearance_;  ///< that there is
    Surface partSurface_, wall_;
    std::size_t partShape_ = 0;
    bool isInside_ = false, isClose_ = false, hasMover_ = false;
    Vector3 direction_ = Vector3::UnitZ();
    Camera camera_;
    Exposure exposure_;
    Stages stages_;
};

}  // namespace clearway::render
