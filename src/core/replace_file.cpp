#include "core/replace_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

namespace clearway {

namespace {

/// A random name: two programs that write one file at the same time must not share a temporary file.
std::string temporaryName(const std::string& file) {
    return file + "." + std::to_string(std::random_device{}()) + ".tmp";
}

[[noreturn]] void refuse(const std::string& file, const char* expected) {
    const int reason = errno;
    throw std::runtime_error("cannot write '" + file + "': " +
                             (reason ? std::strerror(reason) : "write failed") + ", expected " + expected);
}

struct TemporaryFile {
    std::string name;
    ~TemporaryFile() { std::remove(name.c_str()); }
};

/// Refuses devices and pipes, which renaming would replace, and folders, over which renaming fails only after
/// all the work.
void requireFileOrNothing(const std::string& file) {
    std::error_code ignored;
    const auto kind = std::filesystem::status(file, ignored).type();
    if (kind == std::filesystem::file_type::directory) {
        throw std::runtime_error("cannot write '" + file + "': it is a folder, expected the name of a file");
    }
    if (kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::regular) {
        throw std::runtime_error("cannot write '" + file +
                                 "': it is not a regular file, expected a regular file or a new name");
    }
}

std::ofstream open(const TemporaryFile& temporary, const std::string& file) {
    errno = 0;
    std::ofstream stream(temporary.name, std::ios::binary | std::ios::trunc);
    if (!stream) refuse(file, "a folder that exists and may be written");
    return stream;
}

}  // namespace

void replaceFile(const std::string& file, const std::function<void(std::ostream&)>& write) {
    requireFileOrNothing(file);
    const TemporaryFile temporary{temporaryName(file)};
    std::ofstream stream = open(temporary, file);
    write(stream);
    stream.close();
    if (!stream) refuse(file, "room for the whole file");
    errno = 0;
    if (std::rename(temporary.name.c_str(), file.c_str()) != 0) refuse(file, "a name that may be replaced");
}

void requireReplaceable(const std::string& file) {
    requireFileOrNothing(file);
    const TemporaryFile temporary{temporaryName(file)};
    open(temporary, file);
}

void makeFolder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::error_code ignored;
    if (!error && std::filesystem::is_directory(folder, ignored)) return;
    throw std::runtime_error("cannot make the folder '" + folder + "'" +
                             (error ? ": " + error.message() : "") +
                             ", expected a folder that exists or a name for a new one");
}

}  // namespace clearway
