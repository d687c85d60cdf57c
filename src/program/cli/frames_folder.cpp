#include "program/cli/frames_folder.h"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <random>
#include <regex>
#include <stdexcept>
#include <utility>

namespace clearway::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFrameBegin = "frame-";
constexpr const char* kFrameEnd = ".png";

[[noreturn]] void refuseFrames(const std::string& folder, const std::string& fault,
                               const std::string& expected) {
    throw std::runtime_error("cannot write the folder '" + folder + "': " + fault + ", expected " + expected);
}

bool isFrame(const std::string& name) {
    static const std::regex kFrame(fmt::format("{}[0-9]+\\{}", kFrameBegin, kFrameEnd));
    return std::regex_match(name, kFrame);
}

/// The first file that is no picture of a film; empty if there is none.
std::string strangerIn(const std::string& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!isFrame(name)) return name;
    }
    return "";
}

/// Returns the folder. Refuses what is no folder, and a folder that holds anything but pictures of a film.
std::string requireFramesAlone(const std::string& folder) {
    std::error_code failed, ignored;
    if (fs::symlink_status(folder, failed).type() == fs::file_type::not_found) return folder;
    if (!fs::is_directory(folder, failed))
        refuseFrames(folder, "it is not a folder", "a folder or a new name");
    if (fs::equivalent(folder, fs::current_path(), ignored))
        refuseFrames(folder, "it is the current folder, which cannot be replaced",
                     "another folder or a new name");
    const std::string stranger = strangerIn(folder);
    if (!stranger.empty())
        refuseFrames(folder, "it holds '" + stranger + "'",
                     "a new name, an empty folder or one with the pictures of an earlier film alone");
    return folder;
}

/// A link to a folder stays: the folder it leads to is replaced.
std::string resolved(const std::string& folder) {
    std::string given = folder;
    while (given.size() > 1 && given.back() == '/') given.pop_back();
    std::error_code failed;
    const fs::path place = fs::weakly_canonical(given, failed);
    return failed ? given : place.string();
}

std::string besideOf(const std::string& folder) {
    return folder + "." + std::to_string(std::random_device{}()) + ".tmp";
}

}  // namespace

FramesFolder::FramesFolder(std::string folder, std::string temporary)
    : folder_(std::move(folder)), temporary_(std::move(temporary)) {
    std::error_code failed;
    fs::create_directory(temporary_, failed);
    if (failed) refuseFrames(folder_, failed.message(), "a name in a folder that exists and may be written");
}

FramesFolder::FramesFolder(std::string folder)
    : FramesFolder(requireFramesAlone(resolved(folder)), besideOf(resolved(folder))) {}

FramesFolder FramesFolder::beside(const std::string& file) {
    return FramesFolder("", besideOf(resolved(file)));
}

FramesFolder::~FramesFolder() {
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
}

std::string FramesFolder::fileOf(std::size_t picture) const {
    return (fs::path(temporary_) / fmt::format("{}{:04}{}", kFrameBegin, picture, kFrameEnd)).string();
}

std::string FramesFolder::pattern() const {
    const std::string folder = fs::absolute(temporary_).string();
    return boost::replace_all_copy(folder, "%", "%%") + "/" + kFrameBegin + "%04d" + kFrameEnd;
}

void FramesFolder::keep() {
    requireFramesAlone(folder_);  // again: films take minutes
    std::error_code failed, ignored;
    const std::string old = besideOf(folder_);
    const bool hasOld = fs::is_directory(folder_, ignored);
    if (hasOld) fs::rename(folder_, old, failed);
    if (failed) refuseFrames(folder_, failed.message(), "a folder that may be replaced");
    fs::rename(temporary_, folder_, failed);
    if (failed) {
        if (hasOld) fs::rename(old, folder_, ignored);
        refuseFrames(folder_, failed.message(), "a folder that may be replaced");
    }
    if (hasOld) fs::remove_all(old, ignored);
}

}  // namespace clearway::cli
