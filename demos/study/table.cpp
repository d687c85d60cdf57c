#include "demos/study/table.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "core/replace_file.h"

namespace clearway::study {
namespace {

/// The complete lines of the file; empty if there is no file. Removes a last line without an end from the
/// file.
std::string wholeLines(const std::string& file) {
    if (!std::filesystem::exists(file)) return "";
    std::ifstream in(file, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    if (!in) throw std::runtime_error(file + " cannot be read");
    std::string text = all.str();
    const std::size_t end = text.rfind('\n') + 1;  // 0 without a line's end
    if (end < text.size()) {
        text.resize(end);
        std::filesystem::resize_file(file, end);
    }
    return text;
}

/// Removes the rows that a full disk let through, so that a part of the rows does not pass for all of them.
void cutBack(int file, off_t size) {
    if (::ftruncate(file, size) != 0) return;  // the caller reports what failed first
}

}  // namespace

bool readNumber(const std::string& text, double& number) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double unusual : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
        number = unusual;
        if (text == shortNumber(unusual)) return true;
    }
    const std::optional<double> read = parseNumber(text);
    number = read.value_or(0);
    return read.has_value();
}

std::string lineOf(const Cells& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        assert(cells[i].find_first_of(",\n\r") == std::string::npos);
        line += (i > 0 ? "," : "") + cells[i];
    }
    return line + "\n";
}

std::vector<Cells> openTable(const std::string& file, const Cells& names) {
    std::istringstream lines(wholeLines(file));
    std::string line;
    if (!std::getline(lines, line)) {
        appendText(file, lineOf(names));
        return {};
    }
    if (line + "\n" != lineOf(names)) {
        throw std::runtime_error(file +
                                 " has other columns than this version writes, expected a table of its own");
    }
    std::vector<Cells> all;
    while (std::getline(lines, line)) {
        boost::split(all.emplace_back(), line, boost::is_any_of(","));
        if (all.back().size() == names.size()) continue;
        throw std::runtime_error(fmt::format("{}{} values, expected {}",
                                             place(file, static_cast<int>(all.size()) + 1), all.back().size(),
                                             names.size()));
    }
    return all;
}

void appendText(const std::string& file, const std::string& text) {
    const int out = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    const off_t before = out >= 0 ? ::lseek(out, 0, SEEK_END) : -1;
    bool isWritten = before >= 0;
    for (std::size_t done = 0; isWritten && done < text.size();) {
        const ssize_t count = ::write(out, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) continue;
        isWritten = count > 0;
        if (isWritten) done += static_cast<std::size_t>(count);
    }
    isWritten = isWritten && ::fsync(out) == 0;
    const int reason = errno;
    if (before >= 0 && !isWritten) cutBack(out, before);
    if (out >= 0) ::close(out);
    if (!isWritten) throw std::runtime_error(file + " cannot be written: " + std::strerror(reason));
}

void replaceText(const std::string& file, const std::string& text) {
    replaceFile(file, [&](std::ostream& out) { out << text; });
}

void refuseCell(const std::string& file, std::size_t row, const std::string& column,
                const std::string& text) {
    throw std::runtime_error(place(file, static_cast<int>(row) + 2) + column + " is " + quote(text) +
                             ", expected a number");
}

FolderLock::FolderLock(const std::string& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_ < 0 || ::flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(folder_);
    throw std::runtime_error("another program works on the results in '" + folder +
                             "', expected another folder, or this one when that program has ended");
}

FolderLock::~FolderLock() {
    if (folder_ >= 0) ::close(folder_);
}

}  // namespace clearway::study
