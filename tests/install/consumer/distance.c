/* A program of a user in C: the distance of the triangles of distance.cpp at the same pose, as one number with 17 digits. */
#include <clearway/clearway.h>
#include <stdio.h>

static clearway_handle triangle(double z) {
    const double vertices[] = {0.1, 0, z, 1.3, 0, z, 0.1, 1.7, z};
    const uint32_t corners[] = {0, 1, 2};
    clearway_handle model = 0;
    if (clearway_build(vertices, 3, corners, 1, &model) != CLEARWAY_OK)
        fprintf(stderr, "%s\n", clearway_last_error());
    return model;
}

int main(void) {
    // distance.cpp's pose with all digits, row by row.
    const double pose[16] = {0.78163917390702509,
                             -0.48292928421421222,
                             0.39473979817379978,
                             0.2,
                             0.55011723070435836,
                             0.83203013377463464,
                             -0.071392499417875857,
                             0.3,
                             -0.29395787843858057,
                             0.27295633888831433,
                             0.91601506688731726,
                             4.1,  // z
                             0,
                             0,
                             0,
                             1};
    clearway_distance_result result;
    if (clearway_distance(triangle(0.3), triangle(-0.7), pose, NULL, 0, &result) != CLEARWAY_OK) return 1;
    printf("%.17g\n", result.distance);
    return 0;
}
