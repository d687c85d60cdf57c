#include "clearway/planning/planners.h"

#include <ompl/base/ValidStateSampler.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sbl/pSBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <future>
#include <memory>
#include <type_traits>

#include "clearway/errors.h"
#include "clearway/planning/sliding_rrt_connect.h"
#include "core/number.h"
#include "core/text.h"
#include "planning/planners/planner_team.h"
#include "planning/planners/rising_floor.h"
#include "planning/planners/twist_search.h"
#include "planning/space/ompl_refusal.h"
#include "planning/space/ompl_states.h"

namespace clearway::planning {
namespace {

template <class PlannerClass>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
    return std::make_shared<PlannerClass>(si);
}

/// FMT and BFMT with neighbours that are near. OMPL uses the costs of motions as distances between states.
/// Costs of clearance are no distances, and a state is not the nearest to itself, which OMPL's neighbourhoods
/// rely on: searches miss most neighbours, or crash. With length as the cost this is OMPL's own planner.
template <class Tree>
class MarchingTree : public Tree {
  public:
    using Tree::Tree;

    void setup() override {
        Tree::setup();
        if (!this->nn_) return;  // without a problem definition; OMPL calls setup again later
        this->nn_->setDistanceFunction([this](const auto* a, const auto* b) {
            return this->si_->distance(a->getState(), b->getState());
        });
    }
};

/// OMPL renames these planners, with a warning, unless they are given the name of the variant that they are.
template <class PlannerClass>
ob::PlannerPtr makeNearest(const ob::SpaceInformationPtr& si) {
    return std::make_shared<PlannerClass>(
        si, std::is_same_v<PlannerClass, og::BITstar> ? "kBITstar" : "kABITstar");
}

/// A sampler that takes the near state itself where another sampler finds none.
class NearOrSame : public ob::ValidStateSampler {
  public:
    explicit NearOrSame(const ob::SpaceInformation* si)
        : ob::ValidStateSampler(si), sampler_(si->allocValidStateSampler()) {}

    bool sample(ob::State* state) override { return sampler_->sample(state); }

    bool sampleNear(ob::State* state, const ob::State* near, double distance) override {
        if (!sampler_->sampleNear(state, near, distance)) si_->copyState(state, near);
        return true;
    }

  private:
    ob::ValidStateSamplerPtr sampler_;
};

/// pSBL whose samplers always have a state near another one. Where they have none, OMPL's own keeps a lock for good and, from the next
/// invalid motion on, waits for it until its time is over.
class SteadySbl : public og::pSBL {
  public:
    explicit SteadySbl(const ob::SpaceInformationPtr& si)
        : og::pSBL(si), samplers_(makeOnSharedSpace(si->getStateSpace())) {
        samplers_->setValidStateSamplerAllocator(
            [asked = si.get()](const ob::SpaceInformation*) { return std::make_shared<NearOrSame>(asked); });
        samplerArray_ = ob::StateSamplerArray<ob::ValidStateSampler>(samplers_);
    }

  private:
    ob::SpaceInformationPtr samplers_;  ///< allocates them
};

struct NamedPlanner {
    const char* name;
    ob::PlannerPtr (*make)(const ob::SpaceInformationPtr&);
    bool isRepeatable;
};

// Planners are not repeatable for two reasons. Some use several threads: AnytimePathShortening, CForest,
// pRRT, pSBL, and PRM, PRMstar, SPARS and SPARStwo, which look for the solution in a thread of their own and
// take turns by the clock. LBTRRT reads costs before they are set.
constexpr NamedPlanner kPlanners[] = {
    {"ABITstar", makeNearest<og::ABITstar>, true},
    {"AITstar", make<og::AITstar>, true},
    {"AnytimePathShortening", make<og::AnytimePathShortening>, false},
    {"BFMT", make<MarchingTree<og::BFMT>>, true},
    {"BITstar", makeNearest<og::BITstar>, true},
    {"BKPIECE1", make<og::BKPIECE1>, true},
    {"BiEST", make<og::BiEST>, true},
    {"BiTRRT", make<og::BiTRRT>, true},
    {"CForest", make<og::CForest>, false},
    {"EST", make<og::EST>, true},
    {"FMT", make<MarchingTree<og::FMT>>, true},
    {"InformedRRTstar", make<og::InformedRRTstar>, true},
    {"KPIECE1", make<og::KPIECE1>, true},
    {"LBKPIECE1", make<og::LBKPIECE1>, true},
    {"LBTRRT", make<og::LBTRRT>, false},
    {"LazyPRM", make<og::LazyPRM>, true},
    {"LazyPRMstar", make<og::LazyPRMstar>, true},
    {"LazyRRT", make<og::LazyRRT>, true},
    {"PDST", make<og::PDST>, true},
    {"PRM", make<og::PRM>, false},
    {"PRMstar", make<og::PRMstar>, false},
    {"PlannerTeam", make<PlannerTeam>, true},
    {"ProjEST", make<og::ProjEST>, true},
    {"RRT", make<og::RRT>, true},
    {"RRTConnect", make<og::RRTConnect>, true},
    {"RRTXstatic", make<og::RRTXstatic>, true},
    {"RRTsharp", make<og::RRTsharp>, true},
    {"RRTstar", make<og::RRTstar>, true},
    {"RisingFloor", make<RisingFloor>, false},
    {"SBL", make<og::SBL>, true},
    {"SORRTstar", make<og::SORRTstar>, true},
    {"SlidingRRTConnect", make<SlidingRRTConnect>, true},
    {"SPARS", make<og::SPARS>, false},
    {"SPARStwo", make<og::SPARStwo>, false},
    {"SST", make<og::SST>, true},
    {"STRIDE", make<og::STRIDE>, true},
    {"TRRT", make<og::TRRT>, true},
    {"TwistSearch", make<TwistSearch>, true},
    {"pRRT", make<og::pRRT>, false},
    {"pSBL", make<SteadySbl>, false},
};

struct ShortName {
    const char* shortName;
    const char* name;
};

constexpr ShortName kShortNames[] = {
    {"kpiece", "KPIECE1"},  {"bkpiece", "BKPIECE1"},          {"lbkpiece", "LBKPIECE1"},
    {"spars2", "SPARStwo"}, {"aps", "AnytimePathShortening"},
};

const NamedPlanner& findPlanner(const std::string& name) {
    std::string wanted = name;
    for (const ShortName& row : kShortNames) {
        if (boost::iequals(row.shortName, name)) wanted = row.name;
    }
    for (const NamedPlanner& row : kPlanners) {
        if (boost::iequals(row.name, wanted)) return row;
    }
    throw ArgumentError("unknown planner '" + name + "'" + didYouMean(name, plannerNames()) +
                        ", expected one of " + joined(plannerNames()));
}

template <class Value>
bool holds(const ob::GenericParam& parameter) {
    return dynamic_cast<const ob::SpecificParam<Value>*>(&parameter) != nullptr;
}

bool isWhole(const ob::GenericParam& parameter) {
    return holds<int>(parameter) || holds<unsigned int>(parameter) || holds<long>(parameter) ||
           holds<unsigned long>(parameter) || holds<long long>(parameter) ||
           holds<unsigned long long>(parameter);
}

/// Returns what was expected instead of the value, empty when the value is right. OMPL's own conversion would
/// read "1x" as 1.
std::string expectedInstead(const ob::GenericParam& parameter, const std::string& value) {
    if (holds<std::string>(parameter) || holds<char>(parameter)) return "";
    if (holds<bool>(parameter)) return value == "0" || value == "1" ? "" : "0 or 1";
    const std::optional<double> number = parseNumber(value);
    if (!number) return isWhole(parameter) ? "a whole number" : "a number";
    if (isWhole(parameter) && !parseInteger(value)) return "a whole number";
    const bool isUnsigned = holds<unsigned int>(parameter) || holds<unsigned long>(parameter) ||
                            holds<unsigned long long>(parameter);
    if (isUnsigned && *number < 0) return "a whole number of at least 0";
    // OMPL's ranges are "least:step:most" or "least:most". Values above `most` are allowed, because OMPL does
    // not know the unit of length.
    const std::string& range = parameter.getRangeSuggestion();
    const std::size_t colon = range.find(':');
    if (colon == std::string::npos) return "";
    std::string least = range.substr(0, colon);
    if (!least.empty() && least.back() == '.') least += '0';
    const std::optional<double> leastNumber = parseNumber(least);
    return leastNumber && *number < *leastNumber ? "at least " + least : "";
}

}  // namespace

std::vector<std::string> plannerNames() {
    return namesOf(kPlanners);
}

std::string plannerClassName(const std::string& name) {
    return findPlanner(name).name;
}

bool isRepeatable(const std::string& name) {
    return findPlanner(name).isRepeatable;
}

ob::PlannerPtr makePlanner(const ob::SpaceInformationPtr& si, const std::string& name) try {
    return findPlanner(name).make(si);
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

bool hasParameter(const ob::Planner& planner, const std::string& parameter) {
    return planner.params().hasParam(parameter);
}

void setParameter(ob::Planner& planner, const std::string& parameter, const std::string& value) {
    const auto& known = planner.params().getParams();
    const auto found = known.find(parameter);
    if (found == known.end()) {
        std::vector<std::string> names;
        for (const auto& entry : known) names.push_back(entry.first);
        throw ArgumentError("planner " + planner.getName() + " has no parameter '" + parameter + "'" +
                            didYouMean(parameter, names) + ", expected one of " +
                            (names.empty() ? "none" : joined(names)));
    }
    const std::string problem =
        "parameter " + parameter + " of planner " + planner.getName() + " is '" + value + "'";
    const std::string expected = expectedInstead(*found->second, value);
    if (!expected.empty()) throw ArgumentError(problem + ", expected " + expected);
    bool isSet = false;
    try {
        isSet = planner.params().setParam(parameter, value);
    } catch (const std::exception&) {  // a number that OMPL's type cannot hold
    }
    if (!isSet) {
        const std::string& range = found->second->getRangeSuggestion();
        throw ArgumentError(problem + ", which OMPL refuses" +
                            (range.empty() ? "" : "; it suggests " + range));
    }
}

ob::PlannerStatus solveSideBySide(const std::vector<ob::PlannerPtr>& planners,
                                  const ob::PlannerTerminationCondition& isSpent,
                                  const std::function<void()>& onFound) try {
    if (planners.empty()) throw ArgumentError("planners is empty, expected at least one");
    const auto solveOne = [&](const ob::PlannerPtr& planner) {
        const ob::PlannerStatus status = planner->solve(isSpent);
        if (status == ob::PlannerStatus::EXACT_SOLUTION) onFound();
        return status;
    };
    std::vector<std::future<ob::PlannerStatus>> others;
    for (std::size_t i = 1; i < planners.size(); ++i) {
        others.push_back(std::async(std::launch::async, solveOne, planners[i]));
    }
    const ob::PlannerStatus status = solveOne(planners[0]);
    for (auto& other : others) other.get();
    return status;
} catch (const ompl::Exception& refusal) {
    throw OmplRefusal(refusal);
}

}  // namespace clearway::planning
