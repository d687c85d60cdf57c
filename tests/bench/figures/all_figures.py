"""The figures and tables that a document can name in its marks: the name, and the function that makes it of the results."""

import answer
import leaf_summary
import motions
import plans
import provenance
import public_problems
import queries
import scenes
import truth

FIGURES = {
    "answer": answer.answer,
    "measured-on": provenance.measured_on,
    # queries.csv, builds.csv
    "queries": queries.all_ratios,
    "queries-collides": queries.collides,
    "queries-losses": queries.losses,
    "queries-main": queries.main_table,
    "queries-scenes": queries.scene_list,
    "queries-over": queries.over,
    "queries-us": queries.times,
    "queries-poses": queries.poses,
    "queries-largest": queries.largest_environment,
    "queries-spread": queries.repetition_spread,
    "queries-shuffled": queries.shuffled_work,
    "queries-warm": queries.warm_gain,
    "queries-pqp-tests": queries.pqp_tests,
    "queries-fewer-volumes": queries.fewer_volumes,
    "builds": queries.builds,
    "strategies": queries.strategies,
    # speed_error.csv, torture.csv, fcl_continuous.csv
    "verdicts": truth.verdicts,
    "verdicts-asked": truth.asked,
    "verdicts-near": truth.asked_near,
    "verdicts-valid": truth.truly_valid,
    "verdicts-false-valid": truth.false_valid,
    "cost-of-truth": truth.cost_of_truth,
    "over-float": truth.over_float,
    "digits-gained": truth.digits_gained,
    "hard-pairs": truth.hard_pairs,
    "hard-poses": truth.hard_poses,
    "torture-total": truth.torture_total,
    "torture-each": truth.torture_each,
    "torture-largest": truth.torture_largest,
    "fcl-continuous": truth.fcl_continuous,
    # certified_motions.csv, motions.csv, fcl_*.csv
    "certified-motions": motions.certified,
    "certified-valid": motions.certified_valid,
    "certified-times": motions.certified_times,
    "verdicts-lost": motions.verdicts_lost,
    "motions-steps": motions.against_steps,
    "fcl-motions": motions.with_fcl,
    "fcl-motions-times": motions.with_fcl_times,
    "fcl-first-path": motions.first_path,
    # scenes.csv
    "scenes": scenes.scenes,
    # plan_*.csv, samplers_*.csv, anytime_clearance.csv
    "first-paths": plans.first_paths,
    "first-path-problems": plans.problems,
    "first-path-seconds": plans.median_seconds,
    "longest-run": plans.longest,
    "room": plans.room,
    "room-of": plans.room_of,
    "turned": plans.degrees,
    "console": plans.console,
    "console-widest": plans.widest_console,
    "samplers": plans.samplers,
    "samplers-found": plans.samplers_found,
    "anytime": plans.anytime,
    "anytime-first": plans.anytime_first,
    "fmt": plans.fmt,
    # public/*.csv
    "public-paths": public_problems.paths,
    "public-segments": public_problems.segments,
    "public-runs": public_problems.runs,
    "public-parts": public_problems.parts,
    "public-invalid-paths": public_problems.invalid_paths,
    "public-invalid-segments": public_problems.invalid_segments,
    "public-problems": public_problems.problem_count,
    "public-solved": public_problems.solved_with_any_seed,
    "public-solved-others": public_problems.solved_by_others,
    "public-fcl": public_problems.with_fcl,
    # leaf_strategies/*/*.csv
    "leaf-tables": leaf_summary.all_tables,
    "leaf-summary": leaf_summary.summary,
    "leaf-general": leaf_summary.general,
    "leaf-replays": leaf_summary.best_replays,
    "leaf-claims": leaf_summary.claims,
    "leaf-setting": leaf_summary.setting,
    "leaf-improved": leaf_summary.improved,
}
