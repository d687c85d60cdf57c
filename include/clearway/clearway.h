// clearway from C99 and from languages that call C: models, and queries of distance, contact and nearness.
//
// Models and workspaces are handles, numbers that are never used again. A handle that was freed, was never given
// out or is of the other kind is an error, as a null pointer is. Functions that can fail return a status;
// clearway_last_error() says why. A call that fails leaves its results as they were. All functions may be called
// from any number of threads at once.
//
// A pose is a matrix of 4 x 4 doubles in row-major order, X_environment_part: it takes coordinates of the part to
// the environment's. Its last row is 0 0 0 1, so the translation stands at the places 3, 7 and 11. Lengths are in
// the unit of the meshes' coordinates.
#pragma once

#include <stddef.h>
#include <stdint.h>

#pragma GCC visibility push(default)

#ifdef __cplusplus
extern "C" {
#endif

/// How a call ended.
typedef enum clearway_status {
    CLEARWAY_OK = 0,                ///< as asked
    CLEARWAY_INVALID_ARGUMENT = 1,  ///< an argument is not what was expected; in C++ clearway::ArgumentError
    CLEARWAY_FILE_ERROR = 2,        ///< a file cannot be used; in C++ clearway::FileError
    CLEARWAY_OUT_OF_MEMORY = 3,     ///< in C++ std::bad_alloc
    CLEARWAY_INTERNAL_ERROR = 4     ///< a bug of clearway's own
} clearway_status;

/// A model or a workspace; 0 is none.
typedef uint64_t clearway_handle;

/// How accurate a distance must be, and from where on it does not matter. All zeros, or a null pointer to options:
/// as accurate as double allows, and no cap.
typedef struct clearway_distance_options {
    double relative_error;  ///< [lower, upper] may be as wide as relative_error * lower ...
    /// ... or as this length (environment's unit), or as the default width
    /// (clearway::DistanceOptions::relativeError), whichever is most.
    double absolute_error;
    double cap;  ///< distances above this do not matter; INFINITY, or 0: all matter
} clearway_distance_options;

/// If the distance is proved to be above the cap, upper and distance are infinite, the triangles -1 and the points
/// NaN.
typedef struct clearway_distance_result {
    double lower;                    ///< at most the true distance; 0 on contact
    double upper;                    ///< at least the true distance; 0 on contact, above 0 otherwise
    double distance;                 ///< between the two points
    double point_on_part[3];         ///< in the environment's frame
    double point_on_environment[3];  ///< in the environment's frame
    int64_t part_triangle;           ///< position in the part's mesh, from 0
    int64_t environment_triangle;    ///< position in the environment's mesh, from 0
} clearway_distance_result;

/// Makes a model of a mesh file (.stl, .obj, .ply, .off, .gltf, .glb, .3mf, .dae and what else assimp reads), whose coordinates are
/// multiplied by `scale`, or reads a model that clearway_save wrote: the file's first bytes tell which. `scale`
/// must be 1 for a saved model.
clearway_status clearway_load(const char* file, double scale, clearway_handle* model);

/// Makes a model of triangles, with a copy of all data. vertices: 3 doubles each. triangles: 3 indices of vertices
/// each, from 0.
clearway_status clearway_build(const double* vertices, size_t vertex_count, const uint32_t* triangles,
                               size_t triangle_count, clearway_handle* model);

/// Writes a model, so that clearway_load need not build it again.
clearway_status clearway_save(clearway_handle model, const char* file);

/// Makes scratch memory for queries of the calling thread. It holds the pairs of triangles that answered the last queries,
/// with which later queries begin. Queries of other threads are refused it.
clearway_status clearway_new_workspace(clearway_handle* workspace);

/// Finds the distance between the part at the pose and the environment. options: may be NULL. workspace: 0 for one
/// that the library keeps for the calling thread.
clearway_status clearway_distance(clearway_handle part, clearway_handle environment, const double pose[16],
                                  const clearway_distance_options* options, clearway_handle workspace,
                                  clearway_distance_result* result);

/// Sets *collides to 1 if the part at the pose and the environment share a point, exactly, else to 0. workspace: as
/// for clearway_distance.
clearway_status clearway_collides(clearway_handle part, clearway_handle environment, const double pose[16],
                                  clearway_handle workspace, int* collides);

/// Sets *within to 1 if the distance is at most d, exactly, else to 0. d: at least 0. workspace: as for
/// clearway_distance.
clearway_status clearway_within(clearway_handle part, clearway_handle environment, const double pose[16],
                                double d, clearway_handle workspace, int* within);

/// Gives a model or a workspace up; 0 does nothing. A query of another thread that still runs with it ends as it
/// would.
clearway_status clearway_free(clearway_handle handle);

/// Why the calling thread's last failing call failed: what was wrong, its value and what was expected. Empty if
/// none failed. The text stays until the thread's next failing call.
const char* clearway_last_error(void);

/// The version of the library, such as "1.2.3".
const char* clearway_version(void);

#ifdef __cplusplus
}
#endif

#pragma GCC visibility pop
