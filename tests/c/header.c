/* The header serves a program in C99, which gets right answers and reasons. */
#include <clearway/clearway.h>
#include <clearway/version.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int faults = 0;

static void check(int holds, const char* what) {
    if (holds) return;
    ++faults;
    fprintf(stderr, "header.c: not so: %s (last error: '%s')\n", what, clearway_last_error());
}
#define CHECK(condition) check(condition, #condition)

int main(void) {
    /* A tetrahedron with a corner at the origin, and the same one 3 away along x, turned by half a turn about z. */
    static const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    static const double pose[16] = {-1, 0, 0, 5, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    clearway_handle part = 0, environment = 0, workspace = 0;
    clearway_distance_options options = {0};
    clearway_distance_result result;
    int answer = -1;

    CHECK(strcmp(clearway_version(), CLEARWAY_VERSION) == 0);
    CHECK(strcmp(clearway_last_error(), "") == 0);
    CHECK(clearway_build(vertices, 4, triangles, 4, &part) == CLEARWAY_OK);
    CHECK(clearway_build(vertices, 4, triangles, 4, &environment) == CLEARWAY_OK);
    CHECK(clearway_new_workspace(&workspace) == CLEARWAY_OK);
    CHECK(clearway_distance(part, environment, pose, NULL, workspace, &result) == CLEARWAY_OK);
    CHECK(result.lower <= 3 && 3 <= result.upper && result.distance == 3);
    CHECK(result.point_on_part[0] == 4 && result.point_on_environment[0] == 1);
    CHECK(result.part_triangle >= 0 && result.part_triangle < 4);
    CHECK(result.environment_triangle >= 0 && result.environment_triangle < 4);

    options.cap = 2;
    CHECK(clearway_distance(part, environment, pose, &options, 0, &result) == CLEARWAY_OK);
    CHECK(result.lower >= 2 && isinf(result.upper) && result.part_triangle == -1 &&
          isnan(result.point_on_part[0]));
    CHECK(clearway_collides(part, environment, pose, workspace, &answer) == CLEARWAY_OK && answer == 0);
    CHECK(clearway_within(part, environment, pose, 3, workspace, &answer) == CLEARWAY_OK && answer == 1);
    CHECK(clearway_within(part, environment, pose, 2.99, workspace, &answer) == CLEARWAY_OK && answer == 0);

    CHECK(clearway_free(part) == CLEARWAY_OK);
    CHECK(clearway_collides(part, environment, pose, workspace, &answer) == CLEARWAY_INVALID_ARGUMENT);
    CHECK(strstr(clearway_last_error(), "part is ") != NULL);
    CHECK(clearway_load("no such file.stl", 1, &part) == CLEARWAY_FILE_ERROR);
    CHECK(strstr(clearway_last_error(), "no such file.stl") != NULL);
    CHECK(clearway_free(environment) == CLEARWAY_OK && clearway_free(workspace) == CLEARWAY_OK);
    return faults != 0;
}
