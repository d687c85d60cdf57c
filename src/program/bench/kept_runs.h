// The runs of a benchmark that have ended, in a folder, so that a benchmark that was stopped or killed can go on: one file a
// run, which is whole or not there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "program/bench/settings.h"
#include "program/bench/table.h"

namespace clearway::study {

class KeptRuns {
  public:
    /// Makes the folder unless it is there. Throws as requireSettings() does when it holds runs with other settings, and
    /// std::runtime_error when it cannot be made or another program uses it.
    KeptRuns(const std::string& folder, const Settings& settings);

    /// The run's text; empty when it is not kept.
    std::optional<std::string> read(std::size_t run) const;

    /// Throws std::runtime_error when the file cannot be written.
    void keep(std::size_t run, const std::string& text) const;

    /// Removes the folder with all that it holds, when the runs stand elsewhere.
    void remove() const;

  private:
    std::string fileOf(std::size_t run) const;

    std::string folder_;
    std::optional<FolderLock> lock_;
};

}  // namespace clearway::study
