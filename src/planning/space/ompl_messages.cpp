#include "clearway/planning/ompl_messages.h"

#include <algorithm>
#include <set>
#include <thread>

namespace clearway::planning {

namespace {

/// OMPL's handler while there are receivers: each is destroyed only once no message is on its way to it.
class Receivers : public ompl::msg::OutputHandler {
  public:
    void add(OmplMessages* receiver) {
        const std::lock_guard<std::mutex> changing(changes_);
        const bool isFirst = all_.empty();
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            all_.push_back({receiver, std::this_thread::get_id()});
        }
        if (!isFirst) return;
        previous_ = ompl::msg::getOutputHandler();
        ompl::msg::useOutputHandler(this);
    }

    void remove(const OmplMessages* receiver) {
        const std::lock_guard<std::mutex> changing(changes_);
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            all_.erase(std::find_if(all_.begin(), all_.end(),
                                    [&](const Receiver& each) { return each.messages == receiver; }));
        }
        if (all_.empty() && ompl::msg::getOutputHandler() == this) ompl::msg::useOutputHandler(previous_);
    }

    void log(const std::string& text, ompl::msg::LogLevel level, const char*, int) override {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto isOwn = [](const Receiver& each) { return each.thread == std::this_thread::get_id(); };
        const auto own = std::find_if(all_.rbegin(), all_.rend(), isOwn);
        if (own != all_.rend()) return own->messages->log(text, level);
        std::set<std::thread::id> told;
        for (auto each = all_.rbegin(); each != all_.rend(); ++each) {
            if (told.insert(each->thread).second) each->messages->log(text, level);
        }
    }

  private:
    struct Receiver {
        OmplMessages* messages;
        std::thread::id thread;
    };

    std::mutex
        changes_;  // of the handler. OMPL holds a lock of its own while it calls log(), so log() must not wait for it
    std::mutex mutex_;           // of the receivers
    std::vector<Receiver> all_;  // in the order of their making
    ompl::msg::OutputHandler* previous_ = nullptr;
};

/// Never destroyed: OMPL may log while a process ends.
Receivers& receivers() {
    static auto* const all = new Receivers;
    return *all;
}

}  // namespace

OmplMessages::OmplMessages() {
    receivers().add(this);
}

OmplMessages::~OmplMessages() {
    receivers().remove(this);
}

void OmplMessages::log(const std::string& text, ompl::msg::LogLevel level) {
    if (level < ompl::msg::LOG_WARN) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) warnings_.push_back(text);
}

std::vector<std::string> OmplMessages::warnings() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return warnings_;
}

}  // namespace clearway::planning
