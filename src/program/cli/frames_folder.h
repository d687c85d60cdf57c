// A folder of numbered pictures, which appears whole or not at all.
#pragma once

#include <string>

namespace clearway::cli {

class FramesFolder {
  public:
    /// Makes a temporary folder beside `folder`, FOLDER.<number>.tmp. `folder` may be new, empty, or hold the
    /// pictures of an earlier film alone, which are then replaced. Throws std::runtime_error that names the
    /// folder.
    explicit FramesFolder(std::string folder);
    /// The temporary folder beside `file` alone, which is never kept.
    static FramesFolder beside(const std::string& file);
    /// Removes the temporary folder with all its pictures.
    ~FramesFolder();
    FramesFolder(const FramesFolder&) = delete;
    FramesFolder& operator=(const FramesFolder&) = delete;

    /// The file for a picture, counted from 1, in the temporary folder.
    std::string fileOf(std::size_t picture) const;
    /// All pictures' files as one pattern of ffmpeg's.
    std::string pattern() const;
    /// Puts the temporary folder into its place.
    void keep();

  private:
    FramesFolder(std::string folder, std::string temporary);

    std::string folder_, temporary_;
};

}  // namespace clearway::cli
