// The study's jobs, as its workers do them. A job is a word that names its kind, the position of its problem, and what follows below.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <stdexcept>

#include "core/number.h"
#include "core/text.h"
#include "demos/study/files.h"
#include "demos/study/qualification.h"
#include "demos/study/replay.h"
#include "demos/study/replayer.h"
#include "demos/study/study.h"
#include "demos/study/tree_tables.h"

namespace clearway::study {
namespace {

class Jobs {
  public:
    Jobs(LoadProblem load, StudyOptions options, std::string folder)
        : load_(std::move(load)), options_(std::move(options)), folder_(std::move(folder)) {}

    bool operator()(const Job& job) {
        options_.isStopped = job.isStopped;
        options_.tell = job.tell;
        std::vector<std::string> given;
        for (const std::string_view word : words(job.text)) given.emplace_back(word);
        const std::string kind = given.at(0);
        useProblem(std::stoul(given.at(1)));
        given.erase(given.begin(), given.begin() + 2);
        if (kind == "files") return keepAll(job, "files", filesColumns(), files());
        if (kind == "qualify") return qualify(job, given);
        if (kind == "runs") return runs(job, given);
        if (kind == "replay") return keepAll(job, "replay", replayColumns(), replay(given));
        if (kind == "trees") return keepAll(job, "trees", treeColumns(), trees(given));
        throw std::logic_error("unknown job '" + job.text + "'");
    }

  private:
    void useProblem(std::size_t position) {
        if (position == position_ && problem_) return;
        scenes_.clear();
        problem_ = load_(position);
        position_ = position;
    }

    const Scene& sceneIn(const Engine& engine) {
        std::unique_ptr<Scene>& scene = scenes_[engine.name()];
        if (!scene) scene = std::make_unique<Scene>(buildScene(*problem_, engine));
        return *scene;
    }

    template <class Row>
    static void keep(const Job& job, const char* table, const Columns<Row>& columns, const Row& row) {
        std::string line = lineOf(cellsOf(columns, row));
        line.pop_back();  // its end
        job.keep(std::string(table) + " " + line);
    }

    template <class Row>
    static bool keepAll(const Job& job, const char* table, const Columns<Row>& columns,
                        const std::optional<std::vector<Row>>& rows) {
        if (!rows) return false;
        for (const Row& row : *rows) keep(job, table, columns, row);
        return true;
    }

    std::optional<std::vector<FilesRow>> files() {
        return measureFiles([this] { return load_(position_); }, options_);
    }

    /// Does one run and keeps its row. Returns nothing when it was stopped.
    std::optional<StudyRun> run(const Job& job, const char* table, const PlannedRun& planned,
                                bool samplesCalls) {
        const Scene& scene = sceneIn(planned.engine);
        std::optional<StudyRun> done = runPlanned(*problem_, scene, options_, planned, samplesCalls);
        if (!done) return std::nullopt;
        for (const std::string& warning : done->warnings) job.tell("warning: " + warning);
        // The sample first, so that every run in the table has it.
        if (!done->calls.empty()) keepCalls(*done, *problem_, scene, folder_);
        keep(job, table, runColumns(), done->row);
        return done;
    }

    /// given: the planner, then for each seed that has run its seconds, or "-" for no path.
    bool qualify(const Job& job, const std::vector<std::string>& given) {
        Outcomes outcomes;
        for (std::size_t i = 1; i < given.size(); ++i) outcomes.push_back(parseNumber(given[i]));
        while (!isDecided(outcomes, options_)) {
            const int seed = static_cast<int>(outcomes.size()) + 1;
            const PlannedRun planned{given.at(0), qualifyingEngine(options_), seed,
                                     options_.qualifyingSeconds};
            const auto done = run(job, "qualification", planned, seed <= options_.recordedSeeds);
            if (!done) return false;
            outcomes.push_back(done->row.planningSeconds());
        }
        return true;
    }

    /// given: the planner, the seed, the limit in seconds, and the positions of the engines in their order.
    bool runs(const Job& job, const std::vector<std::string>& given) {
        const std::vector<Engine> engines = plannedEngines(options_);
        for (std::size_t i = 3; i < given.size(); ++i) {
            const PlannedRun planned{given.at(0), engines.at(std::stoul(given[i])), std::stoi(given.at(1)),
                                     parseNumber(given.at(2)).value()};
            if (!run(job, "runs", planned, false)) return false;
        }
        return true;
    }

    std::vector<CallsSample> samples(const std::vector<std::string>& planners) {
        std::vector<CallsSample> all;
        for (const std::string& planner : planners) {
            for (int seed = 1; seed <= options_.recordedSeeds; ++seed) {
                if (auto sample = readSample(folder_, problem_->name, planner, seed))
                    all.push_back(std::move(*sample));
            }
        }
        return all;
    }

    /// given: the position of the group, then the planners whose samples are replayed.
    std::optional<std::vector<ReplayRow>> replay(std::vector<std::string> given) {
        scenes_.clear();  // the group's scenes are built anew, and both might fill the memory
        const std::size_t group = std::stoul(given.at(0));
        given.erase(given.begin());
        return replayGroup(*problem_, replayedGroups(options_).at(group), samples(given), options_);
    }

    /// planners: those whose samples give the poses of a problem that has none of its own.
    std::optional<std::vector<TreeRow>> trees(const std::vector<std::string>& planners) {
        scenes_.clear();
        return measureTrees(*problem_, tablePoses(planners), options_);
    }

    /// The poses of the problem, or the states of its recorded calls. If there are too many, takes stretches of consecutive poses, spread
    /// evenly.
    std::vector<Pose> tablePoses(const std::vector<std::string>& planners) {
        constexpr std::size_t kPosesTogether = 25;
        std::vector<Pose> all = problem_->replayPoses;
        if (all.empty()) {
            for (const CallsSample& sample : samples(planners)) {
                for (const Pose& pose : posesOf(problem_->problem, sample.blocks)) all.push_back(pose);
            }
        }
        const auto most = static_cast<std::size_t>(options_.tablePoses);
        if (all.size() <= std::max(most, kPosesTogether)) return all;
        std::vector<Pose> some;
        const std::size_t stretches = (most + kPosesTogether - 1) / kPosesTogether;
        for (std::size_t i = 0; i < most; ++i)
            some.push_back(
                all[(all.size() - kPosesTogether) * (i / kPosesTogether) / stretches + i % kPosesTogether]);
        return some;
    }

    LoadProblem load_;
    StudyOptions options_;
    std::string folder_;
    std::size_t position_ = 0;
    std::optional<StudyProblem> problem_;
    std::map<std::string, std::unique_ptr<Scene>> scenes_;  // by the engine's name
};

}  // namespace

DoJob studyJobs(const LoadProblem& load, const StudyOptions& options, const std::string& folder) {
    const auto jobs = std::make_shared<Jobs>(load, options, folder);
    return [jobs](const Job& job) { return (*jobs)(job); };
}

}  // namespace clearway::study
