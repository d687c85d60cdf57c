// Keeps a second program out of a study's folder.
#pragma once

#include <string>

namespace clearway::study {

/// Holds the folder until its end, or the program's, however that comes.
class FolderLock {
  public:
    /// Throws std::runtime_error naming the folder when another program holds it. A file system that knows no
    /// locks holds nobody out.
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int folder_;
};

}  // namespace clearway::study
