// Keeps OMPL's console quiet and its warnings for a report.
#pragma once

#include <ompl/util/Console.h>

#include <mutex>
#include <string>
#include <vector>

namespace clearway::planning {

/// While it lives, what OMPL says goes here instead of to the terminal. Two of them end in the reverse order
/// of their making.
class OmplMessages : public ompl::msg::OutputHandler {
  public:
    OmplMessages();
    ~OmplMessages() override;
    OmplMessages(const OmplMessages&) = delete;
    OmplMessages& operator=(const OmplMessages&) = delete;

    void log(const std::string& text, ompl::msg::LogLevel level, const char* file, int line) override;

    /// Warnings and errors so far, each text once, in order.
    std::vector<std::string> warnings() const;

  private:
    ompl::msg::OutputHandler* previous_;
    mutable std::mutex mutex_;
    std::vector<std::string> warnings_;
};

}  // namespace clearway::planning
