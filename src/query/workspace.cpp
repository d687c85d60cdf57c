#include "clearway/query.h"
#include "query/workspace_state.h"

namespace clearway {

Workspace::Workspace() : state_(std::make_unique<State>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

void Workspace::forgetWarmStart() {
    state_->warmStart = {};
}

const QueryCounters& Workspace::counters() const {
    return state_->counters;
}

}  // namespace clearway
