// OMPL's log messages, caught for a test.
#pragma once

#include <ompl/util/Console.h>

#include <string>
#include <vector>

namespace clearway::testing {

/// Collects what OMPL logs while this object lives, instead of printing it.
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
