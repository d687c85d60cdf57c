#include "planning/planners/floor_search.h"

#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <algorithm>
#include <future>
#include <iterator>
#include <utility>

#include "clearway/planning/ompl_messages.h"
#include "clearway/planning/outside_goal.h"
#include "clearway/planning/simplify.h"
#include "clearway/planning/sliding_rrt_connect.h"
#include "clearway/planning/validity_checker.h"
#include "core/clock.h"
#include "planning/check/floor_validator.h"
#include "planning/improve/elastic_band.h"
#include "planning/improve/widen_both_ways.h"
#include "planning/planners/other_paths.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

/// Floors, by turns, of the planners that look for short ways, as shares of the best clearance. A low one is quick, and a
/// high one keeps out of ways that are short but narrow.
constexpr double kShortPathsFloors[] = {0.5, 0.75, 0.9};
/// Some seeks of the first ways keep to this share of the best clearance: bands widen some ways further than others.
constexpr double kLowFloor = 0.5;
constexpr double kLeastShare = 1.0 / 32;  ///< below it the shares begin anew
constexpr double kPatience = 4;           ///< times the duration of the seek that found the last path
constexpr double kGrowth = 1.5;           ///< of patience, when a seek finds nothing
constexpr int kFirstIdleStages = 2;       ///< of a path's first band: another path may have more clearance
constexpr double kBandGainLoss = 0.5;     ///< from one band of a path to the next
constexpr double kLeastBandGain =
    1e-3;  ///< the smallest steps; after them a band begins with large ones again
constexpr double kShorteningShare =
    0.25;  ///< of what it took to find a path goes to shortening it before its band
constexpr double kLeastShortening = 0.25;  ///< seconds
constexpr double kLeastWidening = 0.5;     ///< seconds of a band that goes on
constexpr double kSurelyKept =
    0.99;  ///< of the clearance that an audit certifies, by the validator's other searches

/// RRTConnect and SlidingRRTConnect take turns: one of four seeks is beside the narrow places, so their numbers are apart by more.
constexpr int kTurnsBeside = 4;
constexpr int kFirstPaths = 3;  ///< that are widened before ways that wind less are sought

/// A planner that draws its samples from a given sampler.
template <class Planner>
class Sampling : public Planner {
  public:
    Sampling(const ob::SpaceInformationPtr& si, const ob::StateSamplerPtr& sampler) : Planner(si) {
        this->sampler_ = sampler;
    }
};

}  // namespace

struct FloorSearch::Job {
    enum class Kind { kWiden, kWidenOn, kSeek } kind = Kind::kSeek;
    WidePath path{};            ///< to be widened; of a seek, the one with the narrow places, if any
    double gain = 0;            ///< of a band that goes on
    double floor = 0;           ///< of a seek
    double seconds = 0;         ///< limit of a seek, of a band that goes on, or of shortening; 0: none
    bool isShortPath = false;   ///< to be sought or widened: it counts where it winds less than the best path
    bool isLow = false;         ///< to be sought by less clearance than the best path keeps
    int number = 0, known = 0;  ///< of a seek, and of the paths found when it began
};

/// The problem with margins raised by a floor, and a planner for it.
class FloorSearch::Seeker {
  public:
    Seeker(const FloorSearch& search, const Job& job)
        : si_(makeOnSharedSpace(search.si_->getStateSpace())),
          definition_(std::make_shared<ob::ProblemDefinition>(si_)) {
        Scene raised = search.validator_->scene();
        for (Obstacle& obstacle : raised.obstacles) obstacle.margin += job.floor;
        si_->setStateValidityChecker(std::make_shared<ValidityChecker>(si_, raised));
        si_->setMotionValidator(std::make_shared<FloorValidator>(si_, *search.validator_, job.floor));
        setUpOnSharedSpace(*si_);
        for (unsigned int i = 0; i < search.definition_->getStartStateCount(); ++i) {
            definition_->addStartState(search.definition_->getStartState(i));
        }
        definition_->setGoal(goalOf(search.definition_->getGoal()));
        if (job.path.path) goAround(search, job);
        if (job.number / 2 % (sampler_ ? kTurnsBeside : 2) == 0) {
            make<og::RRTConnect>(search.options_.range);
        } else {
            make<SlidingRRTConnect>(search.options_.range);
        }
    }

    /// Returns a path, or null.
    std::shared_ptr<og::PathGeometric> solve(const ob::PlannerTerminationCondition& isOver) {
        planner_->solve(isOver);
        if (!definition_->hasExactSolution()) return nullptr;
        auto found = std::static_pointer_cast<og::PathGeometric>(definition_->getSolutionPath());
        if (known_) joinEnds(*found);
        return found;
    }

  private:
    /// A goal outside has to draw states that keep the floor.
    ob::GoalPtr goalOf(const ob::GoalPtr& given) const {
        const auto* outside = dynamic_cast<const OutsideGoal*>(given.get());
        return outside == nullptr ? given : std::make_shared<OutsideGoal>(si_, *outside);
    }

    /// Looks for other ways around the motions of the known path that do not keep the floor.
    void goAround(const FloorSearch& search, const Job& job) {
        const og::PathGeometric& path = *job.path.path;
        const auto narrows = narrowsOf(path, *search.validator_, job.floor, search.isSpent_);
        const ob::GoalPtr goal = definition_->getGoal();
        if (narrows.empty() || !goal->hasType(ob::GOAL_SAMPLEABLE_REGION)) return;
        known_ = job.path.path;
        for (unsigned int i = 1; i < narrows.front(); ++i) definition_->addStartState(path.getState(i));
        // Motions after the last narrow one keep the floor; the last state of all ends none of them.
        const unsigned int last = narrows.back();
        definition_->setGoal(std::make_shared<EndOfPath>(
            si_, goal, path, si_->isValid(path.getState(last)) ? last : last + 1));
        sampler_ = std::make_shared<BesideNarrows>(*si_, path, narrows, search.validator_->scene().part);
    }

    /// Adds the known path's states before the first and after the last, where these are states of it.
    void joinEnds(og::PathGeometric& found) const {
        const auto placeOf = [&](const ob::State* state) {
            unsigned int i = 0;
            while (i < known_->getStateCount() && !si_->equalStates(known_->getState(i), state)) ++i;
            return i;
        };
        const unsigned int first = placeOf(found.getState(0)), last = placeOf(found.getStates().back());
        if (first < known_->getStateCount()) {
            for (unsigned int i = first; i > 0; --i) found.prepend(known_->getState(i - 1));
        }
        for (unsigned int i = last + 1; i < known_->getStateCount(); ++i) found.append(known_->getState(i));
    }

    template <class Tree>
    void make(double range) {
        const auto planner = std::make_shared<Sampling<Tree>>(si_, sampler_);
        planner->setRange(range);
        planner->setProblemDefinition(definition_);
        planner->setup();
        planner_ = planner;
    }

    ob::SpaceInformationPtr si_;
    ob::ProblemDefinitionPtr definition_;
    ob::StateSamplerPtr sampler_;                     ///< null: the space's own
    std::shared_ptr<const og::PathGeometric> known_;  ///< whose ends the trees begin with; null: none
    ob::PlannerPtr planner_;
};

FloorSearch::FloorSearch(ob::SpaceInformationPtr si, ob::ProblemDefinitionPtr definition,
                         std::shared_ptr<const MotionValidator> validator, const WidePath& first,
                         double seconds)
    : si_(std::move(si)), definition_(std::move(definition)), validator_(std::move(validator)), best_(first) {
    widenLater(first, seconds, false);
}

FloorSearch::~FloorSearch() = default;

void FloorSearch::add(const WidePath& path, double seconds) {
    takeIfBetter(path, 0);
    widenLater(path, seconds, false);
    wideSeeks_.patience = shortSeeks_.patience = std::max(kLeastPatience, kPatience * seconds);
    share_ = kFirstShare;
}

void FloorSearch::widenLater(const WidePath& path, double seconds, bool isShortPath) {
    Job job;
    job.kind = Job::Kind::kWiden;
    job.path = path;
    job.seconds = std::max(kLeastShortening, kShorteningShare * seconds);
    job.isShortPath = isShortPath;
    waiting_.push_back(job);
}

void FloorSearch::run(const FloorSearchOptions& options, const std::function<bool()>& isSpent) {
    options_ = options;
    isSpent_ = isSpent;
    isEnough_ = isEnough(best_);
    std::vector<std::future<void>> others;
    for (unsigned int i = 1; i < options.threads; ++i) {
        others.push_back(std::async(std::launch::async, [this] { work(); }));
    }
    work();
    for (auto& other : others) other.get();
}

double FloorSearch::clearance() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return best_.clearance;
}

bool FloorSearch::hasWidenedSeveral() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ways_ > 1;
}

void FloorSearch::getPlannerData(ob::PlannerData& data) const {
    const std::vector<ob::State*>& states = bestPath().path->getStates();
    data.addStartVertex(ob::PlannerDataVertex(states.front()));
    data.addGoalVertex(ob::PlannerDataVertex(states.back()));
    for (std::size_t i = 1; i < states.size(); ++i) {
        data.addEdge(ob::PlannerDataVertex(states[i - 1]), ob::PlannerDataVertex(states[i]));
    }
}

bool FloorSearch::isOver() const {
    if (isSpent_()) return true;
    const std::lock_guard<std::mutex> lock(mutex_);
    return isEnough_;
}

void FloorSearch::work() {
    while (!isOver()) {
        const Job job = nextJob();
        const double begin = threadSeconds();
        const bool isSeek = job.kind == Job::Kind::kSeek;
        isSeek ? seek(job) : widen(job);
        const std::lock_guard<std::mutex> lock(mutex_);
        Seeks& seeks = job.isShortPath ? shortSeeks_ : wideSeeks_;
        (isSeek ? seeks.spent : widened_) += threadSeconds() - begin;
        widening_ -= !isSeek;
    }
}

/// New paths are widened first. Then one thread goes on with the best path's band while the others seek. A single thread
/// gives as much time to either.
FloorSearch::Job FloorSearch::nextJob() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!waiting_.empty()) {
        Job job = std::move(waiting_.back());
        waiting_.pop_back();
        ++widening_;
        return job;
    }
    const bool isTurn = options_.threads > 1 || widened_ <= wideSeeks_.spent + shortSeeks_.spent;
    if (gain_ == 0 || widening_ > 0 || !isTurn) return seekingJob();
    Job job;
    job.kind = Job::Kind::kWidenOn;
    job.path = {std::make_shared<og::PathGeometric>(*best_.path), best_.clearance};
    job.gain = gain_;
    job.seconds = std::max(wideSeeks_.patience, kLeastWidening);
    gain_ = gain_ > kLeastBandGain ? kBandGainLoss * gain_ : kFirstBandGain;
    ++widening_;
    return job;
}

FloorSearch::Job FloorSearch::seekingJob() {
    Job job;
    job.known = paths_;
    // Wider ways come first, since the clearance of a single one says little. By turns they are sought anywhere, beside the
    // narrow places, anywhere, and anywhere with a low floor.
    const bool isAmongFirst = ways_ < kFirstPaths;
    job.isShortPath = !isAmongFirst && options_.wantsShortPaths && shortSeeks_.spent < wideSeeks_.spent;
    Seeks& seeks = job.isShortPath ? shortSeeks_ : wideSeeks_;
    job.number = seeks.begun++;
    job.isLow = isAmongFirst && job.number % 4 == 3;
    if (isAmongFirst && job.number % 4 == 1) job.path = best_;
    job.seconds = seeks.patience;
    if (job.isShortPath) {
        job.floor = kShortPathsFloors[job.number % std::size(kShortPathsFloors)] * best_.clearance;
    } else if (job.isLow) {
        job.floor = kLowFloor * best_.clearance;
    } else {
        job.floor = best_.clearance + share_ * std::max(0.0, options_.most - best_.clearance);
    }
    return job;
}

void FloorSearch::widen(const Job& job) {
    const double begin = threadSeconds();
    WideningOptions options;
    options.enough = options_.enough;
    options.clearance = job.path.clearance;
    const double seconds = job.kind == Job::Kind::kWidenOn ? job.seconds : 0;
    options.isSpent = [&] { return isSpent_() || (seconds > 0 && threadSeconds() - begin > seconds); };
    og::PathGeometric path = *job.path.path;
    // The seeks aim above the clearance that a band has reached so far.
    options.onGain = [&](double kept) {
        const std::lock_guard<std::mutex> lock(mutex_);
        takeIfBetter({std::make_shared<og::PathGeometric>(path), kept}, gain_);
    };
    if (job.kind == Job::Kind::kWidenOn) {
        options.gain = job.gain;
    } else {
        options.idleStages = kFirstIdleStages;
        endFurtherOut(path, definition_->getGoal(), validator_->scene(), options_.most);
        options.clearance = shortenFirst(job, path);
        if (job.isShortPath && isTooLong(path)) return;
    }
    // A path that has enough needs no band. Where no obstacle counts, any path has: its clearance is infinite.
    const bool isEnough = options.clearance >= options.enough;
    const double clearance = isEnough ? options.clearance : widenPath(path, *validator_, options);
    const WidePath widened{std::make_shared<og::PathGeometric>(path), clearance};
    const std::lock_guard<std::mutex> lock(mutex_);
    takeIfBetter(widened, kFirstBandGain);
    ways_ += job.kind == Job::Kind::kWiden;
    if (job.isShortPath && (!shortPath_ || isBetterPath(widened, *shortPath_, radius())))
        shortPath_ = widened;
    if (gain_ == 0) gain_ = kFirstBandGain;
}

bool FloorSearch::isTooLong(const og::PathGeometric& path) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return windingLength(path, radius()) >= windingLength(*bestPath().path, radius());
}

/// A band of few states is quicker. Returns the clearance that the path keeps.
double FloorSearch::shortenFirst(const Job& job, og::PathGeometric& path) const {
    const double begin = threadSeconds();
    const double floor = kClearanceBeforeBand * validator_->scene().part.box().diagonal().norm();
    const PathAudit found = simplify(path, *validator_,
                                     {std::max(floor, job.path.clearance),
                                      [&] { return isSpent_() || threadSeconds() - begin > job.seconds; }});
    return found.isValid() ? std::max(0.0, kSurelyKept * found.lowerClearance) : 0;
}

void FloorSearch::takeIfBetter(const WidePath& path, double gain) {
    if (path.clearance <= best_.clearance) return;
    best_ = path;
    gain_ = gain;
    isEnough_ = isEnough(best_);
}

void FloorSearch::seek(const Job& job) {
    const double begin = threadSeconds();
    const auto isPassed = [&] {
        const std::lock_guard<std::mutex> lock(mutex_);
        return !job.isShortPath && !job.isLow && (paths_ > job.known || best_.clearance > job.floor);
    };
    const ob::PlannerTerminationCondition isOver([&] {
        return isSpent_() || (job.seconds > 0 && threadSeconds() - begin > job.seconds) || isPassed();
    });
    const OmplMessages unobserved;  // some floors leave no room at the goal, which OMPL would call invalid
    Seeker seeker(*this, job);
    const std::shared_ptr<og::PathGeometric> states = seeker.solve(isOver);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (states) {
        WidePath found{std::make_shared<og::PathGeometric>(si_), job.floor};
        for (const ob::State* state : states->getStates()) found.path->append(state);
        if (job.isShortPath || job.isLow) {
            return widenLater(found, threadSeconds() - begin, job.isShortPath);
        }
        ++paths_;
        add(found, threadSeconds() - begin);
    } else if (job.isShortPath) {
        shortSeeks_.patience *= kGrowth;
    } else if (job.isLow) {
        wideSeeks_.patience *= kGrowth;
    } else if (paths_ == job.known && !(best_.clearance > job.floor)) {
        wideSeeks_.patience *= kGrowth;
        share_ = share_ > kLeastShare ? 0.5 * share_ : kFirstShare;
    }
}

}  // namespace clearway::planning
