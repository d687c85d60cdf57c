// Source: Wald, Woop, Benthin, Johnson, Ernst, Embree: A Kernel Framework for Efficient CPU Ray Tracing,
// 2014.
#include "program/render/rays.h"

#if CLEARWAY_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace clearway::render {

namespace {

/// Bridges Embree 3, which takes a context, and Embree 4, which takes optional arguments.
void intersect(RTCScene scene, RTCRayHit& ray) {
#if CLEARWAY_EMBREE_MAJOR >= 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

void occlude(RTCScene scene, RTCRay& ray) {
#if CLEARWAY_EMBREE_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

RTCRay rayOf(const Ray& ray, float most) {
    RTCRay made{};
    made.org_x = ray.origin.x();
    made.org_y = ray.origin.y();
    made.org_z = ray.origin.z();
    made.tnear = ray.least;
    made.dir_x = ray.direction.x();
    made.dir_y = ray.direction.y();
    made.dir_z = ray.direction.z();
    made.tfar = most;
    made.mask = std::numeric_limits<unsigned>::max();
    return made;
}

/// Allocates in Embree, because Embree reads 16 bytes for a vertex of 12: its own buffers are padded.
template <class Value>
Value* newBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
    void* memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Value), count);
    if (memory == nullptr) throw std::runtime_error("Embree has no memory for a surface");
    return static_cast<Value*>(memory);
}

void attachTriangles(RTCDevice device, RTCScene scene, const Surface& surface) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    Vector3f* const vertices =
        newBuffer<Vector3f>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, surface.vertices.size());
    std::copy(surface.vertices.begin(), surface.vertices.end(), vertices);
    TriangleIndices* const indices = newBuffer<TriangleIndices>(geometry, RTC_BUFFER_TYPE_INDEX,
                                                                RTC_FORMAT_UINT3, surface.triangles.size());
    std::copy(surface.triangles.begin(), surface.triangles.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

void placeInstance(RTCGeometry instance, const Placement& placement) {
    Eigen::Matrix<float, 3, 4> columns;
    columns << placement.rotation, placement.translation;
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    rtcCommitGeometry(instance);
}

}  // namespace

struct RayScene::State {
    RTCDevice device = rtcNewDevice("set_affinity=0");
    RTCScene scene = nullptr;
    std::vector<RTCScene> shapes;

    void requireDone(const char* what) const {
        const RTCError error = rtcGetDeviceError(device);
        if (error == RTC_ERROR_NONE) return;
        throw std::runtime_error(std::string(what) + ": Embree reports error " +
                                 std::to_string(static_cast<int>(error)));
    }

    ~State() {
        for (const RTCScene shape : shapes) rtcReleaseScene(shape);
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
};

RayScene::RayScene() : state_(std::make_unique<State>()) {
    if (state_->device == nullptr) {
        throw std::runtime_error("Embree cannot be started: it reports error " +
                                 std::to_string(static_cast<int>(rtcGetDeviceError(nullptr))));
    }
    state_->scene = rtcNewScene(state_->device);
    rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
    state_->requireDone("Embree cannot make a scene");
}

RayScene::~RayScene() = default;

std::size_t RayScene::addShape(const Surface& surface) {
    const RTCScene shape = rtcNewScene(state_->device);
    rtcSetSceneFlags(shape, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
    state_->shapes.push_back(shape);
    if (!surface.triangles.empty()) attachTriangles(state_->device, shape, surface);
    rtcCommitScene(shape);
    state_->requireDone("Embree cannot take a surface");
    return state_->shapes.size() - 1;
}

void RayScene::addBody(std::size_t shape, const Placement& placement) {
    const RTCGeometry instance = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, state_->shapes[shape]);
    placeInstance(instance, placement);
    rtcAttachGeometry(state_->scene, instance);  // Embree numbers instances in this order
    rtcReleaseGeometry(instance);
    state_->requireDone("Embree cannot place a body");
}

void RayScene::moveBody(std::size_t body, const Placement& placement) {
    placeInstance(rtcGetGeometry(state_->scene, static_cast<unsigned>(body)), placement);
    state_->requireDone("Embree cannot move a body");
}

void RayScene::showBody(std::size_t body, bool isShown) {
    const RTCGeometry instance = rtcGetGeometry(state_->scene, static_cast<unsigned>(body));
    if (isShown) {
        rtcEnableGeometry(instance);
    } else {
        rtcDisableGeometry(instance);
    }
    rtcCommitGeometry(instance);
    state_->requireDone("Embree cannot show or hide a body");
}

void RayScene::finish() {
    rtcCommitScene(state_->scene);
    state_->requireDone("Embree cannot build its trees");
}

RayHit RayScene::nearest(const Ray& ray) const {
    RTCRayHit shot{};
    shot.ray = rayOf(ray, std::numeric_limits<float>::infinity());
    shot.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    shot.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect(state_->scene, shot);
    if (shot.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {shot.ray.tfar, shot.hit.instID[0], shot.hit.primID, shot.hit.u, shot.hit.v, true};
}

bool RayScene::isBlocked(const Ray& ray, float most) const {
    RTCRay shot = rayOf(ray, most);
    occlude(state_->scene, shot);
    return shot.tfar < 0;  // Embree marks a blocked ray so
}

}  // namespace clearway::render
