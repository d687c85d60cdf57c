// Keeps OMPL's console quiet and collects its warnings for a report.
#pragma once

#include <ompl/util/Console.h>

#include <mutex>
#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace clearway::planning {

/// While an object lives, OMPL's messages go to it instead of to the terminal. Objects must be destroyed in
/// the reverse order of their construction.
class OmplMessages : public ompl::msg::OutputHandler {
  public:
    /// Begins to receive OMPL's messages.
    OmplMessages();
    /// Gives the messages back to the former receiver.
    ~OmplMessages() override;
    OmplMessages(const OmplMessages&) = delete;
    OmplMessages& operator=(const OmplMessages&) = delete;

    /// Called by OMPL, from any thread. Keeps warnings and errors, drops all other messages.
    void log(const std::string& text, ompl::msg::LogLevel level, const char* file, int line) override;

    /// Returns the warnings and errors so far, each text once, in order.
    std::vector<std::string> warnings() const;

  private:
    ompl::msg::OutputHandler* previous_;
    mutable std::mutex mutex_;
    std::vector<std::string> warnings_;
};

}  // namespace clearway::planning

#pragma GCC visibility pop
