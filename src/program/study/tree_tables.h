// The thesis's tables 5 to 11 for a scene of ours: what trees of its strategies cost to build, what they look
// like and how fast they answer, in its engine (nodes of 2 children, volumes fitted by covariance) and in
// ours.
#pragma once

#include <string>
#include <vector>

#include "program/study/growing_table.h"
#include "program/study/study_options.h"
#include "program/study/study_problem.h"

namespace clearway::study {

/// scene, node_width, fit, general_split, leaf_split; triangles, build_seconds, megabytes, leaves_1 to
/// leaves_4, leaves; poses, colliding, distances_per_second, collisions_per_second, and the seconds of blocks
/// of poses, from which claims are judged; then the thesis's values, where it has them. Of the environment,
/// but for the queries.
std::vector<std::string> treeColumns();

/// Measures the scene unless the table has it. Trees are built by one thread; all are asked at the same poses
/// in turn, each warm from the pose before; a block's time is the median of the repetitions, the processor's.
/// poses: the problem's replay poses, or those of recorded calls. False when it was stopped: then the table
/// is as before. Throws std::logic_error when two engines contradict each other.
bool measureTrees(const StudyProblem& problem, const std::vector<Pose>& poses, const StudyOptions& options,
                  GrowingTable& trees);

}  // namespace clearway::study
