// demos/distance.c PART ENVIRONMENT: moves a part past its environment and tells how far apart the two are, in C.
#include <clearway/clearway.h>
#include <stdio.h>
#include <stdlib.h>

static void require(clearway_status status) {
    if (status == CLEARWAY_OK) return;
    fprintf(stderr, "distance: %s\n", clearway_last_error());
    exit(2);
}

int main(int count, char** files) {
    clearway_handle part, environment, workspace;
    // The part's coordinates to the environment's, row by row: unturned, and too high for the window.
    double pose[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 12, 0, 0, 0, 1};
    if (count != 3) {
        fprintf(stderr, "distance: %d files, expected 2: distance PART ENVIRONMENT\n", count - 1);
        return 2;
    }
    require(clearway_load(files[1], /*scale*/ 1, &part));
    require(clearway_load(files[2], /*scale*/ 1, &environment));
    require(clearway_new_workspace(
        &workspace));  // of this thread: each query begins with the last one's closest pair
    printf("     x    distance   triangles           closest point of the environment\n");
    for (pose[3] = -60; pose[3] <= 60; pose[3] += 10) {
        clearway_distance_result found;
        require(clearway_distance(part, environment, pose, /*options*/ NULL, workspace, &found));
        printf("%6.1f  %10.4f   %4ld and %4ld   (%.3f, %.3f, %.3f)\n", pose[3], found.distance,
               (long)found.part_triangle, (long)found.environment_triangle, found.point_on_environment[0],
               found.point_on_environment[1], found.point_on_environment[2]);
    }
    require(clearway_free(workspace));
    require(clearway_free(environment));
    require(clearway_free(part));
    return 0;
}
