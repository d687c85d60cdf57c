// Keeps the path file of an earlier run from being taken for that of a run that failed.
#pragma once

#include <string>
#include <utility>

namespace clearway::cli {

/// Make one when the arguments are read, before planning. The destructor renames the old file, unless isReplaced() or
/// stays() was called.
class OldPath {
  public:
    explicit OldPath(std::string file) : file_(std::move(file)) {}
    ~OldPath() { leave(); }
    OldPath(const OldPath&) = delete;
    OldPath& operator=(const OldPath&) = delete;

    void isReplaced() { file_.clear(); }
    void stays() { file_.clear(); }  ///< after wrong usage
    /// Sets the file aside (setAside) and prints a row about it, or a warning when it cannot; once.
    void leave();

  private:
    std::string file_;
};

}  // namespace clearway::cli
