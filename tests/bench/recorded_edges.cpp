#include "bench/recorded_edges.h"

#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "clearway/planning/motion_validator.h"

namespace clearway::testing {
namespace {

/// Passes motions on to a validator and keeps them.
class Recorder : public ob::MotionValidator {
  public:
    Recorder(const ob::SpaceInformationPtr& si, const Scene& scene)
        : ob::MotionValidator(si), space_(si->getStateSpace()), validator_(si, scene) {}
    bool checkMotion(const ob::State* s1, const ob::State* s2) const override {
        edges.push_back({ob::ScopedState<>(space_, s1), ob::ScopedState<>(space_, s2)});
        return validator_.checkMotion(s1, s2);
    }
    bool checkMotion(const ob::State* s1, const ob::State* s2,
                     std::pair<ob::State*, double>& lastValid) const override {
        edges.push_back({ob::ScopedState<>(space_, s1), ob::ScopedState<>(space_, s2)});
        return validator_.checkMotion(s1, s2, lastValid);
    }
    mutable std::vector<Edge> edges;

  private:
    ob::StateSpacePtr space_;
    planning::MotionValidator validator_;
};

}  // namespace

EdgeRecorder::EdgeRecorder(const Problem& problem, const Scene& scene, double range)
    : problem_(problem),
      scene_(scene),
      range_(range),
      space_(planning::makeSpace(problem.space, boundsOf(problem, scene.environmentBox(), scene.part.box()),
                                 scene.part.radiusAboutOrigin())) {}

ob::SpaceInformationPtr EdgeRecorder::makeSpaceInformation(const Scene& scene) const {
    const auto si = std::make_shared<ob::SpaceInformation>(space_);
    si->setStateValidityChecker(std::make_shared<planning::ValidityChecker>(si, scene));
    return si;
}

std::vector<Edge> EdgeRecorder::record(std::size_t count) const {
    const ob::SpaceInformationPtr si = makeSpaceInformation(scene_);
    const auto recorder = std::make_shared<Recorder>(si, scene_);
    si->setMotionValidator(recorder);
    si->setup();
    while (recorder->edges.size() < count) {
        const auto definition = std::make_shared<ob::ProblemDefinition>(si);
        definition->setStartAndGoalStates(planning::toOmpl(space_, problem_.space, problem_.start),
                                          planning::toOmpl(space_, problem_.space, problem_.goal));
        og::RRTConnect planner(si);
        planner.setRange(range_);
        planner.setProblemDefinition(definition);
        planner.solve(ob::PlannerTerminationCondition([&] { return recorder->edges.size() >= count; }));
    }
    return recorder->edges;
}

}  // namespace clearway::testing
