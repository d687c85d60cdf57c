// Keeps the path file of an earlier run from being taken for that of a run that failed.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "core/replace_file.h"
#include "program/options/print.h"

namespace clearway::cli {

/// Make one when the arguments are read, before planning. The destructor renames the old file, unless stays() was called.
class OldPath {
  public:
    explicit OldPath(std::string file) : file_(std::move(file)) {}
    ~OldPath() { leave(); }
    OldPath(const OldPath&) = delete;
    OldPath& operator=(const OldPath&) = delete;

    void stays() { file_.clear(); }  ///< once there is a new path, or after wrong usage
    /// Sets the file aside (setAside) and prints a row about it, or a warning when it cannot; once.
    void leave() {
        if (file_.empty()) return;
        try {
            const std::optional<std::string> name = setAside(std::exchange(file_, {}));
            if (name) printRow("old path", "moved to " + *name + ", because there is no new one");
        } catch (const std::exception& error) {
            printWarnings({std::string("the old path is still there: ") + error.what()});
        }
    }

  private:
    std::string file_;
};

}  // namespace clearway::cli
