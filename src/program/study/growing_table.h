// A table that is kept as a CSV file while it grows: what was added is there after any end of the program.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace clearway::study {

using TableRow = std::map<std::string, std::string>;  ///< by the columns' names; a value left out is empty

class GrowingTable {
  public:
    /// Reads the file's rows, or makes it with the columns' names. A last line without an end is one that the
    /// end of the program cut short: it is taken away. Throws std::runtime_error, naming the file, when it
    /// can neither be read nor made, or holds other columns.
    GrowingTable(std::string file, std::vector<std::string> columns);

    const std::vector<TableRow>& rows() const { return rows_; }

    /// Writes the rows at once and makes sure that they are on the disk. Values hold neither commas nor line
    /// ends. Throws std::runtime_error when it cannot; then the file is as it was. An end of the program in
    /// the midst of it may leave some of the rows.
    void append(const std::vector<TableRow>& rows);

    /// Takes rows away, from the file too, which is replaced as a whole. Throws as append does.
    void remove(const std::function<bool(const TableRow&)>& isUnwanted);

    const std::string& file() const { return file_; }

  private:
    void write(const std::string& text) const;
    std::string file_;
    std::vector<std::string> columns_;
    std::vector<TableRow> rows_;
};

/// The rows as such a file's text, with the columns' names.
std::string tableText(const std::vector<std::string>& columns, const std::vector<TableRow>& rows);

}  // namespace clearway::study
