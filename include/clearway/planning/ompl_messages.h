// Keeps OMPL's console quiet and collects its warnings for a report.
#pragma once

#include <ompl/util/Console.h>

#include <mutex>
#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway::planning {

/// While an object lives, OMPL's messages go to it instead of to the terminal: those of its own thread, and those of threads that
/// have no object. If a thread has several objects, the newest receives its messages. Objects may be made and
/// destroyed in any thread and order; the handler that OMPL had before the first one comes back after the last one.
class OmplMessages {
  public:
    /// Begins to receive OMPL's messages.
    OmplMessages();
    /// No message comes any more, once this returns.
    ~OmplMessages();
    OmplMessages(const OmplMessages&) = delete;
    OmplMessages& operator=(const OmplMessages&) = delete;

    /// Keeps a warning or an error, drops all other messages. Any thread may call it.
    void log(const std::string& text, ompl::msg::LogLevel level);

    /// Returns the warnings and errors so far, each text once, in order.
    std::vector<std::string> warnings() const;

  private:
    mutable std::mutex mutex_;
    std::vector<std::string> warnings_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
