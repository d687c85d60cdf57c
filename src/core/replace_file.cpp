#include "core/replace_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "clearway/errors.h"

namespace clearway {

namespace {

/// A random name: two programs that write one file at the same time must not share a temporary file.
std::string temporaryName(const std::string& file) {
    return file + "." + std::to_string(std::random_device{}()) + ".tmp";
}

[[noreturn]] void refuse(const std::string& file, const char* expected) {
    const int reason = errno;
    throw FileError("cannot write '" + file + "': " + (reason ? std::strerror(reason) : "write failed") +
                    ", expected " + expected);
}

struct TemporaryFile {
    std::string name;
    ~TemporaryFile() { std::remove(name.c_str()); }
};

/// Where a name leads.
struct Target {
    std::string name;  ///< of the file itself, at the end of all links; it need not exist
    std::filesystem::file_type type;
    std::error_code error;  ///< why the type is none
};

/// /dev/stdout and other links to a process's streams count as devices even where the stream goes to a regular file, which
/// belongs to whoever opened it.
Target targetOf(const std::string& file) {
    namespace fs = std::filesystem;
    constexpr int kMostLinks = 40;  // as many as the system follows
    std::error_code ignored, error;
    const fs::file_type type = fs::status(file, error).type();
    fs::path name = file;
    for (int i = 0; i < kMostLinks; ++i) {
        const fs::path folder = fs::weakly_canonical(fs::absolute(name, ignored).parent_path(), ignored);
        if (folder.string().rfind("/proc/", 0) == 0) return {file, fs::file_type::character, {}};
        if (!fs::is_symlink(name, ignored)) break;
        name = folder / fs::read_symlink(name, ignored);
    }
    return {name.string(), type, error};
}

/// The first free name for a file that is set aside.
std::string freeName(const std::string& file) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    std::string name = file + ".old";
    for (int i = 2; fs::symlink_status(name, ignored).type() != fs::file_type::not_found; ++i) {
        name = file + ".old." + std::to_string(i);
    }
    return name;
}

/// Refuses devices and pipes, which renaming would replace, and folders, over which renaming fails only after
/// all the work. Returns the name of the file to replace: a link stays one.
std::string requireFileOrNothing(const std::string& file) {
    const auto [name, kind, error] = targetOf(file);
    if (kind == std::filesystem::file_type::directory) {
        throw FileError("cannot write '" + file + "': it is a folder, expected the name of a file");
    }
    if (kind == std::filesystem::file_type::none) {
        errno = error.value();
        refuse(file, "a regular file or a new name");
    }
    if (kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::regular) {
        throw FileError("cannot write '" + file +
                        "': it is not a regular file, expected a regular file or a new name");
    }
    return name;
}

constexpr const char* kSpace = "room for the whole file";

/// Closes the file or the folder once the disk holds it: after a power failure, a renamed file must not be empty.
void saveAndClose(int opened, const std::string& file) {
    errno = 0;
    const bool isSaved = ::fsync(opened) == 0 || errno == EINVAL || errno == ENOTSUP;
    const int reason = errno;
    ::close(opened);
    errno = reason;
    if (!isSaved) refuse(file, kSpace);
}

/// Puts the temporary file, which is complete, in place of the target. `file`: the name for messages.
void putInPlace(const TemporaryFile& temporary, const std::string& target, const std::string& file) {
    errno = 0;
    const int written = ::open(temporary.name.c_str(), O_RDONLY | O_CLOEXEC);
    if (written < 0) refuse(file, kSpace);
    struct stat old;
    // Where the file system has no modes, that fails, and nothing is lost.
    if (::stat(target.c_str(), &old) == 0) ::fchmod(written, old.st_mode & 0777);
    saveAndClose(written, file);
    errno = 0;
    if (std::rename(temporary.name.c_str(), target.c_str()) != 0) refuse(file, "a name that may be replaced");
    const std::string folder = std::filesystem::path(target).parent_path().string();
    const int holding = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (holding >= 0) saveAndClose(holding, file);  // a folder may be written, but not read
}

std::ofstream open(const TemporaryFile& temporary, const std::string& file) {
    errno = 0;
    std::ofstream stream(temporary.name, std::ios::binary | std::ios::trunc);
    if (!stream) refuse(file, "a folder that exists and may be written");
    return stream;
}

}  // namespace

void replaceFile(const std::string& file, const std::function<void(std::ostream&)>& write) {
    const std::string target = requireFileOrNothing(file);
    const TemporaryFile temporary{temporaryName(target)};
    std::ofstream stream = open(temporary, file);
    write(stream);
    stream.close();
    if (!stream) refuse(file, kSpace);
    putInPlace(temporary, target, file);
}

bool replaceFileByName(const std::string& file, const std::function<bool(const std::string&)>& write) {
    const std::string target = requireFileOrNothing(file);
    const TemporaryFile temporary{temporaryName(target)};
    if (!write(temporary.name)) return false;
    putInPlace(temporary, target, file);
    return true;
}

void requireReplaceable(const std::string& file) {
    const TemporaryFile temporary{temporaryName(requireFileOrNothing(file))};
    open(temporary, file);
}

std::optional<std::string> setAside(const std::string& given) {
    const Target target = targetOf(given);
    if (target.type != std::filesystem::file_type::regular) return std::nullopt;
    const std::string& file = target.name;
    // A hard link never replaces a file, even one that another program has just made. Where the file system has no hard links
    // the file is renamed.
    std::error_code failed;
    std::string name = freeName(file);
    std::filesystem::create_hard_link(file, name, failed);
    while (failed == std::errc::file_exists) {
        name = freeName(file);
        std::filesystem::create_hard_link(file, name, failed);
    }
    errno = 0;
    const int done = failed ? std::rename(file.c_str(), name.c_str()) : std::remove(file.c_str());
    if (done == 0) return name;
    const std::string reason = std::strerror(errno);
    throw FileError("cannot rename '" + file + "' to '" + name + "': " + reason +
                    ", expected a folder that may be written");
}

void makeFolder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::error_code ignored;
    if (!error && std::filesystem::is_directory(folder, ignored)) return;
    throw FileError("cannot make the folder '" + folder + "'" + (error ? ": " + error.message() : "") +
                    ", expected a folder that exists or a name for a new one");
}

bool isSameFile(const std::string& a, const std::string& b) {
    namespace fs = std::filesystem;
    std::error_code isMissing;
    if (fs::equivalent(a, b, isMissing)) return true;
    const auto whole = [](const std::string& name) {
        std::error_code isGone;  // the current folder: names are then compared as they are
        const fs::path absolute = fs::absolute(name, isGone);
        const fs::path canonical = isGone ? fs::path() : fs::weakly_canonical(absolute, isGone);
        return (isGone ? fs::path(name) : canonical).lexically_normal();
    };
    return whole(a) == whole(b);
}

}  // namespace clearway
