// The library for C: a table of handles, and the C++ functions behind them. No exception leaves it.
#include "clearway/clearway.h"

#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "clearway/errors.h"
#include "clearway/mesh.h"
#include "clearway/model.h"
#include "clearway/query.h"
#include "clearway/version.h"

namespace clearway {
namespace {

/// A handle stands for one of the two.
struct Entry {
    std::optional<Model> model;
    std::shared_ptr<OwnedWorkspace> workspace;
};

/// The lock is held for look-ups only. A query works on a copy of the entry, which shares the model or the workspace, so
/// that another thread may free the handle meanwhile.
class HandleTable {
  public:
    clearway_handle add(Entry entry) {
        const std::unique_lock<std::shared_mutex> lock(mutex_);
        // The factor is odd, so handles are distinct and not 0. Small numbers and addresses are hardly ever handles.
        const clearway_handle handle = (count_ + 1) * 0x9E3779B97F4A7C15u;
        entries_.emplace(handle, std::move(entry));
        ++count_;
        return handle;
    }

    /// name: of the argument, for the message.
    Entry find(clearway_handle handle, const char* name, const char* expected) const {
        const std::shared_lock<std::shared_mutex> lock(mutex_);
        const auto found = entries_.find(handle);
        if (found == entries_.end()) refuse(handle, name, expected);
        return found->second;
    }

    void remove(clearway_handle handle) {
        std::unique_lock<std::shared_mutex> lock(mutex_);
        const auto removed = entries_.extract(handle);
        lock.unlock();  // a large model takes a while to destroy
        if (removed.empty()) refuse(handle, "handle", "a model or a workspace");
    }

  private:
    [[noreturn]] static void refuse(clearway_handle handle, const char* name, const char* expected) {
        throw ArgumentError(fmt::format("{} is {}{}, expected {}", name, handle,
                                        handle == 0 ? "" : ", a handle that was freed or never given out",
                                        expected));
    }

    mutable std::shared_mutex mutex_;
    std::unordered_map<clearway_handle, Entry> entries_;
    std::uint64_t count_ = 0;
};

/// Never destroyed: threads may still ask while the process ends.
HandleTable& handles() {
    static HandleTable& table = *new HandleTable;
    return table;
}

Model modelOf(clearway_handle handle, const char* name) {
    const Entry entry = handles().find(handle, name, "a model");
    if (entry.model) return *entry.model;
    throw ArgumentError(std::string(name) + " is a workspace, expected a model");
}

std::shared_ptr<OwnedWorkspace> workspaceOf(clearway_handle handle) {
    Entry entry = handles().find(handle, "workspace", "a workspace or 0");
    if (entry.workspace) return std::move(entry.workspace);
    throw ArgumentError("workspace is a model, expected a workspace or 0");
}

void requirePointer(const void* pointer, const char* name, const char* expected) {
    if (pointer != nullptr) return;
    throw ArgumentError(std::string(name) + " is a null pointer, expected " + expected);
}

Pose poseOfRows(const double* m) {
    requirePointer(m, "pose", "16 doubles");
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1) {
        throw ArgumentError(fmt::format("the last row of pose is {:g} {:g} {:g} {:g}, expected 0 0 0 1",
                                        m[12], m[13], m[14], m[15]));
    }
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) pose.rotation(row, column) = m[4 * row + column];
        pose.translation[row] = m[4 * row + 3];
    }
    return pose;
}

/// A query's arguments, from what C hands in.
struct Asked {
    Asked(clearway_handle thePart, clearway_handle theEnvironment, const double* pose,
          clearway_handle workspace)
        : part(modelOf(thePart, "part")),
          environment(modelOf(theEnvironment, "environment")),
          X_environmentPart(poseOfRows(pose)),
          owned(workspace == 0 ? nullptr : workspaceOf(workspace)) {}

    Workspace& scratch() const {
        thread_local Workspace ofThread;
        return owned ? owned->mine() : ofThread;
    }

    const Model part, environment;
    const Pose X_environmentPart;
    const std::shared_ptr<OwnedWorkspace> owned;
};

Model loadModel(const std::string& file, double scale) {
    char start[8] = {};
    std::ifstream(file, std::ios::binary).read(start, sizeof start);
    if (std::string(start, sizeof start) != "clearway") {
        LoadOptions options;
        options.scale = scale;
        return Model::build(loadMesh(file, options));
    }
    if (scale != 1) throw ArgumentError(fmt::format("scale is {:g}, expected 1 for a saved model", scale));
    return Model::load(file);
}

Mesh meshOf(const double* vertices, std::size_t vertexCount, const std::uint32_t* triangles,
            std::size_t triangleCount) {
    if (vertexCount > 0) requirePointer(vertices, "vertices", "3 doubles for each vertex");
    if (triangleCount > 0) requirePointer(triangles, "triangles", "3 indices of vertices for each triangle");
    Mesh mesh;
    // A count that memory cannot hold fails here, before anything is read.
    mesh.vertices.reserve(vertexCount);
    mesh.triangles.reserve(triangleCount);
    for (std::size_t i = 0; i < vertexCount; ++i) {
        mesh.vertices.emplace_back(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
    }
    for (std::size_t i = 0; i < triangleCount; ++i) {
        mesh.triangles.push_back({triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]});
    }
    return mesh;
}

DistanceOptions optionsOf(const clearway_distance_options* given) {
    DistanceOptions options;
    if (given == nullptr) return options;
    options.relativeError = given->relative_error;
    options.absoluteError = given->absolute_error;
    if (given->cap != 0) options.cap = given->cap;
    return options;
}

void writeResult(const DistanceResult& found, clearway_distance_result& result) {
    result.lower = found.lower;
    result.upper = found.upper;
    result.distance = found.distance;
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    for (int axis = 0; axis < 3; ++axis) {
        result.point_on_part[axis] = found.witness ? found.witness->pointOnPart[axis] : kNowhere;
        result.point_on_environment[axis] =
            found.witness ? found.witness->pointOnEnvironment[axis] : kNowhere;
    }
    result.part_triangle = found.witness ? found.witness->partTriangle : -1;
    result.environment_triangle = found.witness ? found.witness->environmentTriangle : -1;
}

struct LastError {
    std::string text;
    const char* shown = "";
};

LastError& lastError() {
    thread_local LastError error;
    return error;
}

clearway_status fail(clearway_status status, const char* why) noexcept {
    LastError& error = lastError();
    try {
        error.text = why;
        error.shown = error.text.c_str();
    } catch (...) {
        error.shown = "out of memory";
    }
    return status;
}

/// Does the work; turns what it throws into a status and a text.
template <class Work>
clearway_status answer(const Work& work) noexcept {
    try {
        work();
        return CLEARWAY_OK;
    } catch (const ArgumentError& error) {
        return fail(CLEARWAY_INVALID_ARGUMENT, error.what());
    } catch (const FileError& error) {
        return fail(CLEARWAY_FILE_ERROR, error.what());
    } catch (const std::bad_alloc&) {
        return fail(CLEARWAY_OUT_OF_MEMORY, "out of memory");
    } catch (const std::length_error&) {  // more elements than any memory holds
        return fail(CLEARWAY_OUT_OF_MEMORY, "out of memory");
    } catch (const std::exception& error) {
        return fail(CLEARWAY_INTERNAL_ERROR, error.what());
    } catch (...) {
        return fail(CLEARWAY_INTERNAL_ERROR, "an exception of an unknown type");
    }
}

constexpr const char* kHandlePlace = "a place for the handle";

}  // namespace
}  // namespace clearway

using namespace clearway;

clearway_status clearway_load(const char* file, double scale, clearway_handle* model) {
    return answer([=] {
        requirePointer(file, "file", "a name");
        requirePointer(model, "model", kHandlePlace);
        *model = handles().add({loadModel(file, scale), nullptr});
    });
}

clearway_status clearway_build(const double* vertices, size_t vertex_count, const uint32_t* triangles,
                               size_t triangle_count, clearway_handle* model) {
    return answer([=] {
        requirePointer(model, "model", kHandlePlace);
        *model =
            handles().add({Model::build(meshOf(vertices, vertex_count, triangles, triangle_count)), nullptr});
    });
}

clearway_status clearway_save(clearway_handle model, const char* file) {
    return answer([=] {
        requirePointer(file, "file", "a name");
        modelOf(model, "model").save(file);
    });
}

clearway_status clearway_new_workspace(clearway_handle* workspace) {
    return answer([=] {
        requirePointer(workspace, "workspace", kHandlePlace);
        *workspace = handles().add({std::nullopt, std::make_shared<OwnedWorkspace>()});
    });
}

clearway_status clearway_distance(clearway_handle part, clearway_handle environment, const double pose[16],
                                  const clearway_distance_options* options, clearway_handle workspace,
                                  clearway_distance_result* result) {
    return answer([=] {
        requirePointer(result, "result", "a place for the result");
        const Asked asked(part, environment, pose, workspace);
        writeResult(distance(asked.part, asked.environment, asked.X_environmentPart, optionsOf(options),
                             asked.scratch()),
                    *result);
    });
}

clearway_status clearway_collides(clearway_handle part, clearway_handle environment, const double pose[16],
                                  clearway_handle workspace, int* collides) {
    return answer([=] {
        requirePointer(collides, "collides", "a place for the answer");
        const Asked asked(part, environment, pose, workspace);
        *collides =
            clearway::collides(asked.part, asked.environment, asked.X_environmentPart, asked.scratch());
    });
}

clearway_status clearway_within(clearway_handle part, clearway_handle environment, const double pose[16],
                                double d, clearway_handle workspace, int* within) {
    return answer([=] {
        requirePointer(within, "within", "a place for the answer");
        const Asked asked(part, environment, pose, workspace);
        *within = isWithin(asked.part, asked.environment, asked.X_environmentPart, d, asked.scratch());
    });
}

clearway_status clearway_free(clearway_handle handle) {
    return answer([=] {
        if (handle != 0) handles().remove(handle);
    });
}

const char* clearway_last_error(void) {
    return lastError().shown;
}

const char* clearway_version(void) {
    return CLEARWAY_VERSION;
}
