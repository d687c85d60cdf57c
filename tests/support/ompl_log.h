// What OMPL would print.
#pragma once

#include <ompl/util/Console.h>

#include <string>
#include <vector>

namespace clearway::testing {

/// What OMPL logs while it lives, rather than on the terminal.
class OmplLog : public ompl::msg::OutputHandler {
  public:
    OmplLog() { ompl::msg::useOutputHandler(this); }
    ~OmplLog() override { ompl::msg::restorePreviousOutputHandler(); }
    void log(const std::string& text, ompl::msg::LogLevel, const char*, int) override {
        lines.push_back(text);
    }
    std::vector<std::string> lines;
};

}  // namespace clearway::testing
