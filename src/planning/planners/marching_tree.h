// FMT and BFMT with neighbours that are near. OMPL takes the costs of motions for distances between states:
// by clearance they are none, and a state is not the nearest to itself, which neighbourhoods rely on.
// Searches miss most neighbours, or crash, after as many costs as a path takes.
#pragma once

#include <ompl/base/SpaceInformation.h>

namespace clearway::planning {

/// Tree: ompl::geometric::FMT or BFMT. With length for a cost it is that planner.
template <class Tree>
class MarchingTree : public Tree {
  public:
    using Tree::Tree;

    void setup() override {
        Tree::setup();
        if (!this->nn_) return;  // set up without a problem definition, and later again
        this->nn_->setDistanceFunction([this](const auto* a, const auto* b) {
            return this->si_->distance(a->getState(), b->getState());
        });
    }
};

}  // namespace clearway::planning
