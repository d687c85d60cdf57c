"""The figures and tables that a document can name in its marks: the name, and the function that makes it of the results."""

import queries

FIGURES = {
    "queries": queries.all_ratios,
    "queries-main": queries.main_table,
    "queries-scenes": queries.scene_list,
    "queries-over": queries.over,
    "queries-us": queries.times,
    "queries-poses": queries.poses,
    "queries-largest": queries.largest_environment,
    "queries-spread": queries.repetition_spread,
    "queries-shuffled": queries.shuffled_work,
    "builds": queries.builds,
}
