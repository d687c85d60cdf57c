#include "program/study/growing_table.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "core/replace_file.h"

namespace clearway::study {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> values(1);
    for (const char c : line) {
        if (c == ',') {
            values.emplace_back();
        } else {
            values.back() += c;
        }
    }
    return values;
}

std::string joined(const std::vector<std::string>& values) {
    std::string line;
    for (std::size_t i = 0; i < values.size(); ++i) line += (i > 0 ? "," : "") + values[i];
    return line + "\n";
}

std::string lineOf(const std::vector<std::string>& columns, const TableRow& row) {
    std::vector<std::string> values;
    for (const std::string& column : columns) {
        const auto found = row.find(column);
        values.push_back(found == row.end() ? "" : found->second);
        assert(values.back().find_first_of(",\n\r") == std::string::npos);
    }
    return joined(values);
}

/// The whole lines of the file; what follows the last line's end is cut off. Empty when there is no file.
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

/// Some of the rows, as a full disk leaves them, must not pass for all.
void cutBack(int file, off_t size) {
    if (::ftruncate(file, size) != 0) return;  // what failed first is told
}

}  // namespace

GrowingTable::GrowingTable(std::string file, std::vector<std::string> columns)
    : file_(std::move(file)), columns_(std::move(columns)) {
    std::istringstream lines(wholeLines(file_));
    std::string line;
    if (!std::getline(lines, line)) {
        write(joined(columns_));
        return;
    }
    if (line + "\n" != joined(columns_)) {
        throw std::runtime_error(file_ +
                                 " has other columns than this version writes, expected a table of its own");
    }
    for (int number = 2; std::getline(lines, line); ++number) {
        const std::vector<std::string> values = split(line);
        if (values.size() != columns_.size()) {
            throw std::runtime_error(file_ + ":" + std::to_string(number) + ": " +
                                     std::to_string(values.size()) + " values, expected " +
                                     std::to_string(columns_.size()));
        }
        TableRow row;
        for (std::size_t i = 0; i < values.size(); ++i) row[columns_[i]] = values[i];
        rows_.push_back(row);
    }
}

void GrowingTable::append(const std::vector<TableRow>& rows) {
    std::string text;
    for (const TableRow& row : rows) text += lineOf(columns_, row);
    write(text);
    for (TableRow row : rows) {
        for (const std::string& column : columns_) row.emplace(column, "");
        rows_.push_back(std::move(row));
    }
}

void GrowingTable::remove(const std::function<bool(const TableRow&)>& isUnwanted) {
    rows_.erase(std::remove_if(rows_.begin(), rows_.end(), isUnwanted), rows_.end());
    replaceFile(file_, [&](std::ostream& out) { out << tableText(columns_, rows_); });
}

void GrowingTable::write(const std::string& text) const {
    const int out = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
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
    if (!isWritten) throw std::runtime_error(file_ + " cannot be written: " + std::strerror(reason));
}

std::string tableText(const std::vector<std::string>& columns, const std::vector<TableRow>& rows) {
    std::string text = joined(columns);
    for (const TableRow& row : rows) text += lineOf(columns, row);
    return text;
}

}  // namespace clearway::study
