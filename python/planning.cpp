// The extension clearway._planning: plan() and checkPath() for clearway/planning.py, which has their documentation and makes
// its results of the dicts that come from here.
#include "clearway/planning/plan.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clearway/errors.h"
#include "clearway/planning/check_path.h"
#include "clearway/planning/objectives.h"
#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/planners.h"
#include "python/paths.h"
#include "python/scenes.h"
#include "python/stoppable.h"

namespace clearway::python {
namespace {

using planning::MotionVerdict;
using planning::PathAudit;
using planning::PlanReport;
using planning::SegmentAudit;
using Clock = std::chrono::steady_clock;

/// How often a progress callback is called.
constexpr std::chrono::milliseconds kProgressPeriod{200};

const char* nameOf(MotionVerdict verdict) {
    const char* names[] = {"valid", "invalid", "undecided"};
    return names[static_cast<int>(verdict)];
}

const char* nameOf(PlanReport::Outcome outcome) {
    const char* names[] = {"found", "not found", "stopped"};
    return names[static_cast<int>(outcome)];
}

/// Loading, and then those of PlanPhase.
constexpr const char* kPhases[] = {"loading", "planning", "widening", "finishing", "asking why"};

/// The scene that was given, or else the problem's, loaded now.
struct ChosenScene {
    std::optional<Scene> scene;
    std::vector<std::string> notes;

    explicit ChosenScene(const PyScene* given) {
        if (given) scene = given->clearance.scene();
    }
    template <class IsStopped>
    const Scene& load(const Problem& problem, const planning::PlanOptions& options,
                      const IsStopped& isStopped) {
        if (scene) return *scene;
        requireMeshFiles(problem);
        SceneLoading loading;
        loading.range = [&](const Model& part, const Box& environmentBox) {
            return planning::planningRange(problem, options, part, environmentBox);
        };
        loading.build = [&](const Mesh& mesh, const BuildOptions& build,
                            const std::optional<QueryRange>& range) {
            if (isStopped()) throw Stopped();
            return Model::build(mesh, build, range);
        };
        loading.shrink = [&](const Mesh& part, ShrinkOptions shrinking) {
            shrinking.isStopped = isStopped;
            return shrink(part, shrinking);
        };
        try {
            LoadedScene loaded = loadScene(problem, BuildOptions(), loading);
            notes = std::move(loaded.notes);
            return scene.emplace(std::move(loaded.scene));
        } catch (const ShrinkStopped&) {
            throw Stopped();
        }
    }
};

py::dict dictOf(const PathAudit& audit, std::size_t index) {
    const SegmentAudit& segment = audit.segments.at(index);
    py::dict result;
    result["segment"] = index;
    result["time"] = segment.motion.closestTime;
    result["pose"] = arrayOf(segment.X_environmentPart);
    result["part_mesh"] = segment.partMesh;
    result["environment_mesh"] = segment.environmentMesh;
    const Witness witness = witnessOf(segment.motion.closest);
    result["part_triangle"] = witness.partTriangle;
    result["environment_triangle"] = witness.environmentTriangle;
    result["point_on_part"] = arrayOf(witness.pointOnPart);
    result["point_on_environment"] = arrayOf(witness.pointOnEnvironment);
    return result;
}

py::dict dictOf(const PathAudit& audit) {
    py::list faults;
    for (const std::size_t i : audit.notValid) {
        const SegmentAudit& segment = audit.segments[i];
        const WhyInvalid& why = segment.motion.whyInvalid;
        faults.append(py::make_tuple(i, nameOf(segment.motion.verdict), segment.motion.certifiedTime,
                                     why.words(), nameOf(why.kind), why.partMesh, why.environmentMesh));
    }
    py::dict result;
    result["verdict"] = nameOf(audit.verdict);
    result["lower_clearance"] = audit.lowerClearance;
    result["upper_clearance"] = audit.upperClearance;
    result["length"] = audit.length;
    result["rotation"] = audit.rotation;
    result["closest"] = dictOf(audit, audit.closest);
    result["faults"] = faults;
    return result;
}

py::dict profileOf(const PathAudit& audit) {
    using Point = planning::PathProfilePoint;
    py::dict result;
    result["segment"] = columnOf<std::int64_t>(audit.profile, &Point::segment);
    result["time"] = columnOf<double>(audit.profile, &Point::time);
    result["travel"] = columnOf<double>(audit.profile, &Point::travel);
    result["clearance"] = columnOf<double>(audit.profile, &Point::clearance);
    result["lower_to_next"] = columnOf<double>(audit.profile, &Point::lowerToNext);
    return result;
}

py::dict dictOf(const planning::ReachedFrom& end) {
    py::dict result;
    result["states"] = end.states;
    result["has_tree"] = end.hasTree;
    result["farthest"] = end.farthest;
    result["motions_stopped"] = end.motionsStopped;
    py::list bounds;
    for (const BoxSide& bound : end.bounds) bounds.append(planning::boundNamed(bound));
    result["bounds"] = bounds;
    return result;
}

py::dict dictOf(const planning::WhyNoPath& why) {
    py::list blockers;
    for (const planning::Blocker& each : why.blockers) {
        blockers.append(py::make_tuple(each.name, each.partMesh, each.atStart, each.atGoal));
    }
    py::list tracks;
    for (const planning::FollowedTrack& each : why.tracks) {
        tracks.append(py::make_tuple(each.obstacleMesh, each.partMesh, each.isSquare, each.length));
    }
    py::dict result;
    result["tracks"] = tracks;
    result["diagonal"] = why.diagonal;
    result["start"] = dictOf(why.start);
    result["goal"] = dictOf(why.goal);
    result["is_shut_in_at_start"] = why.isShutIn(why.start);
    result["is_shut_in_at_goal"] = why.isShutIn(why.goal);
    result["motions_tried"] = why.motionsTried;
    result["blockers"] = blockers;
    result["nearest_states"] = arrayOf(why.nearest.path);
    result["gap"] = why.nearest.gap;
    result["displacement"] = why.nearest.displacement;
    return result;
}

py::dict dictOf(const PlanReport& report) {
    py::dict result;
    result["outcome"] = nameOf(report.outcome);
    result["is_stopped"] = report.isStopped;
    result["states"] = arrayOf(report.path);
    result["path"] = posesOf(report.path);
    result["length"] = report.length;
    result["rotation"] = report.rotation;
    for (const char* key : {"audit", "why_no_path", "shut_in"}) result[key] = py::none();
    if (!report.path.empty()) result["audit"] = dictOf(report.audit);
    if (report.whyNoPath) result["why_no_path"] = dictOf(*report.whyNoPath);
    if (report.shutIn) {
        result["shut_in"] =
            py::make_tuple(report.shutIn->isStart ? "start" : "goal", report.shutIn->obstacle);
    }
    result["planners"] = report.planners;
    result["found_by"] = report.foundBy;
    result["objective"] = report.objective;
    result["cost"] = report.cost;
    result["is_repeatable"] = report.isRepeatable;
    result["floor"] = report.floor;
    result["states_before"] = report.statesBefore;
    result["planning_seconds"] = report.planningSeconds;
    result["finishing_seconds"] = report.finishingSeconds;
    result["checks"] = report.checks;
    return result;
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// A whole number of Python's or NumPy's, within limits.
std::int64_t wholeNumber(const py::object& given, const char* name, std::int64_t least, std::int64_t most) {
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
    if (!index) throw py::error_already_set();
    const std::int64_t number = PyLong_AsLongLong(index.ptr());
    const bool isTooLarge = number == -1 && PyErr_Occurred();
    if (isTooLarge) PyErr_Clear();
    if (isTooLarge || number < least || number > most) {
        throw ArgumentError(fmt::format("{} is {}, expected a whole number from {} to {}", name,
                                        std::string(py::str(index)), least, most));
    }
    return number;
}

std::optional<double> numberOrNone(const py::object& given) {
    if (given.is_none()) return std::nullopt;
    const double number = PyFloat_AsDouble(given.ptr());
    if (number == -1 && PyErr_Occurred()) throw py::error_already_set();
    return number;
}

std::string textOf(const py::handle& given) {
    py::ssize_t size = 0;
    const char* text = PyUnicode_AsUTF8AndSize(given.ptr(), &size);
    if (!text) throw py::error_already_set();
    return {text, static_cast<std::size_t>(size)};
}

/// Takes the margin for the problem's.
void setMargin(Problem& problem, const std::optional<double>& margin, const PyScene* scene) {
    if (!margin) return;
    if (scene)
        throw ArgumentError("both a scene and a margin are given, expected one of them: a scene has margins");
    problem.margin = requireMargin(*margin);
}

/// Calls the callback, now and then, with the seconds so far and the phase's name.
class Progress {
  public:
    explicit Progress(py::object callback) : callback_(std::move(callback)) {}
    std::atomic<int> phase{0};

    /// False when the callback returned False.
    bool tell() {
        const Clock::time_point now = Clock::now();
        if (callback_.is_none() || now < due_) return true;
        due_ = now + kProgressPeriod;
        const double seconds = std::chrono::duration<double>(now - begin_).count();
        const auto call = [&] {
            return PyObject_CallFunction(callback_.ptr(), "ds", seconds, kPhases[phase]);
        };
        const auto answer = py::reinterpret_steal<py::object>(callUnlessEnded(call));
        if (!answer) throw py::error_already_set();
        return answer.ptr() != Py_False;
    }

  private:
    py::object callback_;
    Clock::time_point begin_ = Clock::now(), due_ = begin_;
};

planning::PlanOptions optionsOf(const py::dict& given) {
    planning::PlanOptions options;
    options.planner = textOf(given["planner"]);
    for (const py::handle pair : given["parameters"]) {
        const auto both = py::reinterpret_borrow<py::tuple>(pair);
        options.parameters.emplace_back(textOf(both[0]), textOf(both[1]));
    }
    options.seconds = numberOrNone(given["seconds"]);
    if (!given["iterations"].is_none()) {
        options.iterations =
            wholeNumber(given["iterations"], "iterations", 1, std::numeric_limits<std::int64_t>::max());
    }
    options.threads = static_cast<int>(wholeNumber(given["threads"], "threads", 0, 256));
    options.seed = static_cast<std::uint32_t>(
        wholeNumber(given["seed"], "seed", 1, std::numeric_limits<std::uint32_t>::max()));
    options.floor = numberOrNone(given["floor"]);
    options.objective = textOf(given["objective"]);
    options.wantedClearance = numberOrNone(given["wanted_clearance"]);
    options.quick = py::bool_(given["quick"]);
    options.omplWeights = py::bool_(given["ompl_weights"]);
    return options;
}

/// Returns (report, raised): a dict, and what runStoppable returns.
py::tuple plan(const py::object& given, const PyScene* scene, const std::optional<double>& margin,
               const py::dict& how, const py::object& callback) {
    Problem problem = problemOf(given);
    setMargin(problem, margin, scene);
    planning::PlanOptions options = optionsOf(how);
    ChosenScene chosen(scene);
    std::optional<PlanReport> report;
    Progress progress(callback);
    const auto work = [&](const auto& isStopped) {
        const Scene& loaded = chosen.load(problem, options, isStopped);
        options.isStopped = isStopped;
        options.onPhase = [&](planning::PlanPhase phase) { progress.phase = 1 + static_cast<int>(phase); };
        report = planning::plan(problem, loaded, options);
    };
    const py::object raised = runStoppable(work, [&] { return progress.tell(); });
    if (!report) {  // stopped while it waited for its turn or the scene was loaded
        report.emplace();
        report->outcome = PlanReport::Outcome::kStopped;
        report->isStopped = true;
    }
    py::dict result = dictOf(*report);
    result["space"] = problem.space == Space::kSe3 ? "SE3" : "SE2";
    result["warnings"] = joined(joined(problem.warnings, chosen.notes), report->warnings);
    return py::make_tuple(result, raised);
}

/// Returns (check, raised), as plan does; an empty check when it was stopped. path: a file's name, poses or states.
py::tuple check(const py::object& given, const py::object& path, const PyScene* scene,
                const std::optional<double>& margin, bool hasProfile) {
    Problem problem = problemOf(given);
    setMargin(problem, margin, scene);
    const bool isFile = py::isinstance<py::str>(path) || py::hasattr(path, "__fspath__");
    const std::vector<PartState> states =
        isFile ? readPath(fileName(path), problem.space) : statesOf(path, problem.space);
    for (const PartState& state : states) problem.knownPath.extend(state.position);
    ChosenScene chosen(scene);
    std::optional<planning::PathCheck> found;
    const auto work = [&](const auto& isStopped) {
        try {
            const Scene& loaded = chosen.load(problem, planning::PlanOptions(), isStopped);
            const planning::OmplMessages unobserved;  // the audit says what cannot be judged
            const planning::AuditOptions options{hasProfile, isStopped};
            found = planning::checkPath(problem, loaded, states, options);
        } catch (const planning::AuditStopped&) {
        }
    };
    const py::object raised = runStoppable(work, [] { return true; });
    if (!found) return py::make_tuple(py::dict(), raised);
    py::dict result = dictOf(found->audit);
    result["off_start"] = found->offStart;
    result["off_goal"] = found->offGoal;
    result["tolerance"] = found->tolerance;
    result["profile"] = hasProfile ? profileOf(found->audit) : py::object(py::none());
    result["warnings"] = joined(problem.warnings, chosen.notes);
    return py::make_tuple(result, raised);
}

/// The file of the OMPL that clearway is bound to in this process.
std::string omplLibrary() {
    Dl_info found{};
    const auto function = reinterpret_cast<void*>(&ompl::msg::useOutputHandler);
    return dladdr(function, &found) != 0 && found.dli_fname ? found.dli_fname : "";
}

}  // namespace
}  // namespace clearway::python

PYBIND11_MODULE(_planning, module) {
    namespace py = pybind11;
    using namespace clearway::python;
    py::module_::import("clearway._core");  // has the classes, and how errors are raised
    module.def("plan", &plan, py::arg("problem"), py::arg("scene"), py::arg("margin"), py::arg("options"),
               py::arg("progress"), R"(For clearway.planning.plan.)");
    module.def("check", &check, py::arg("problem"), py::arg("path"), py::arg("scene"), py::arg("margin"),
               py::arg("profile"), R"(For clearway.planning.check.)");
    module.def("planner_names", &clearway::planning::plannerNames,
               R"(The names that plan's planner takes, in any case.)");
    module.def("objective_names", &clearway::planning::objectiveNames,
               R"(The names that plan's objective takes.)");
    module.def("ompl_library", &omplLibrary,
               R"(The file of the OMPL that clearway is bound to in this process.)");
    RunningWork::watchPython();
}
