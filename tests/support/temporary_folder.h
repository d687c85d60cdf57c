// A temporary folder for a test's files, removed at the end of the test.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clearway::testing {

class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path() const { return folder_.string(); }
    /// The path of a file in the folder, whether it exists or not.
    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    /// Writes the text and returns the file's path.
    std::string write(const std::string& name, const std::string& text) const;
    /// The names of the folder's contents, sorted.
    std::vector<std::string> names() const;

  private:
    std::filesystem::path folder_;
};

/// The whole text of a file; empty if the file cannot be read.
std::string readText(const std::string& file);

}  // namespace clearway::testing
