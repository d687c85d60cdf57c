// Tables of typed rows, kept as CSV files: one list of columns both writes and reads them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/number.h"
#include "core/text.h"
#include "program/bench/planner_run.h"

namespace clearway::study {

/// The name of a column and the member of a row that its cells hold.
template <class Row>
struct Column {
    std::string name;
    std::variant<std::string Row::*, int Row::*, std::uint64_t Row::*, double Row::*, Count Row::*,
                 Measure Row::*, std::vector<double> Row::*>
        member;
};

template <class Row>
using Columns = std::vector<Column<Row>>;

/// The text of a cell. Doubles have the fewest digits that read back to an equal double; the doubles of a
/// list are separated by spaces.
template <class Value>
std::string cellText(const Value& value) {
    if constexpr (std::is_same_v<Value, std::string>) {
        return value;
    } else if constexpr (std::is_same_v<Value, double>) {
        return shortNumber(value);
    } else if constexpr (std::is_integral_v<Value>) {
        return std::to_string(value);
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
        std::string text;
        for (const double each : value) text += (text.empty() ? "" : " ") + shortNumber(each);
        return text;
    } else {
        return value ? cellText(*value) : "";
    }
}

/// Reads a number, also one that is not finite. Returns false when the text is no number.
bool readNumber(const std::string& text, double& number);

/// Reads a cell. Returns false when the text is no value of this type.
template <class Value>
bool readCell(const std::string& text, Value& value) {
    if constexpr (std::is_same_v<Value, std::string>) {
        value = text;
        return true;
    } else if constexpr (std::is_same_v<Value, double>) {
        return readNumber(text, value);
    } else if constexpr (std::is_integral_v<Value>) {
        const std::optional<std::int64_t> number = parseInteger(text);
        value = static_cast<Value>(number.value_or(0));
        return number && std::to_string(value) == std::to_string(*number);
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
        const std::vector<std::string_view> all = words(text);
        value.assign(all.size(), 0);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!readNumber(std::string(all[i]), value[i])) return false;
        }
        return true;
    } else {
        return text.empty() || readCell(text, value.emplace());
    }
}

using Cells = std::vector<std::string>;  ///< the cells of one line

/// The cells as a line with its end. Cells hold neither commas nor line ends.
std::string lineOf(const Cells& cells);

template <class Row>
Cells namesOf(const Columns<Row>& columns) {
    Cells names;
    for (const Column<Row>& column : columns) names.push_back(column.name);
    return names;
}

template <class Row>
Cells cellsOf(const Columns<Row>& columns, const Row& row) {
    Cells cells;
    for (const Column<Row>& column : columns)
        cells.push_back(std::visit([&](auto member) { return cellText(row.*member); }, column.member));
    return cells;
}

/// Reads one cell for each column into the row, up to a cell that is no value of its column's type. Returns the number of
/// cells read.
template <class Row>
std::size_t readCells(const Columns<Row>& columns, const Cells& cells, Row& row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool isRead =
            std::visit([&](auto member) { return readCell(cells[i], row.*member); }, columns[i].member);
        if (!isRead) return i;
    }
    return columns.size();
}

/// The rows as the text of a CSV file, with the columns' names.
template <class Row>
std::string tableText(const Columns<Row>& columns, const std::vector<Row>& rows) {
    std::string text = lineOf(namesOf(columns));
    for (const Row& row : rows) text += lineOf(cellsOf(columns, row));
    return text;
}

/// The lines of a table's file below its head. Makes the file with the head if there is none. Removes a last
/// line without an end, which is left when the program ends while writing. Throws std::runtime_error, naming
/// the file, when the file can neither be read nor made, or holds other columns.
std::vector<Cells> openTable(const std::string& file, const Cells& names);

/// Appends the text at once and makes sure that the text is on the disk. Throws std::runtime_error when this
/// fails; the file is then unchanged.
void appendText(const std::string& file, const std::string& text);

/// Replaces the whole file. Throws std::runtime_error when this fails; the file is then unchanged.
void replaceText(const std::string& file, const std::string& text);

/// Throws std::runtime_error about a cell that readCell refused. row: counted from 0, below the head.
[[noreturn]] void refuseCell(const std::string& file, std::size_t row, const std::string& column,
                             const std::string& text);

/// A table that is kept as a file while it grows. Appended rows are on the disk, however the program ends.
template <class Row>
class GrowingTable {
  public:
    /// Reads the rows of the file, or makes the file. Throws as openTable does, and when a cell has no value
    /// of its column's type.
    GrowingTable(std::string file, Columns<Row> columns)
        : file_(std::move(file)), columns_(std::move(columns)) {
        for (const Cells& cells : openTable(file_, namesOf(columns_))) {
            Row row;
            const std::size_t read = readCells(columns_, cells, row);
            if (read < columns_.size()) refuseCell(file_, rows_.size(), columns_[read].name, cells[read]);
            rows_.push_back(std::move(row));
        }
    }

    const std::vector<Row>& rows() const { return rows_; }
    const std::string& file() const { return file_; }

    /// Throws as appendText does. If the program ends while appending, the file may have some of the rows.
    void append(const std::vector<Row>& rows) {
        std::string text;
        for (const Row& row : rows) text += lineOf(cellsOf(columns_, row));
        appendText(file_, text);
        rows_.insert(rows_.end(), rows.begin(), rows.end());
    }

    /// Removes rows from the table and from its file. Throws as replaceText does.
    template <class IsUnwanted>
    void remove(const IsUnwanted& isUnwanted) {
        rows_.erase(std::remove_if(rows_.begin(), rows_.end(), isUnwanted), rows_.end());
        replaceText(file_, tableText(columns_, rows_));
    }

  private:
    std::string file_;
    Columns<Row> columns_;
    std::vector<Row> rows_;
};

/// Keeps a second program out of a folder of results, until the lock is destroyed or the program ends.
class FolderLock {
  public:
    /// Throws std::runtime_error, naming the folder, when another program holds it. On a file system without
    /// locks the lock has no effect.
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int folder_;
};

}  // namespace clearway::study
