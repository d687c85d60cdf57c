#include "clearway/planning/ompl_messages.h"

#include <algorithm>

namespace clearway::planning {

OmplMessages::OmplMessages() : previous_(ompl::msg::getOutputHandler()) {
    ompl::msg::useOutputHandler(this);
}

OmplMessages::~OmplMessages() {
    ompl::msg::useOutputHandler(previous_);  // OMPL's own way back works for one level only
}

void OmplMessages::log(const std::string& text, ompl::msg::LogLevel level, const char* /*file*/,
                       int /*line*/) {
    if (level < ompl::msg::LOG_WARN) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) warnings_.push_back(text);
}

std::vector<std::string> OmplMessages::warnings() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return warnings_;
}

}  // namespace clearway::planning
