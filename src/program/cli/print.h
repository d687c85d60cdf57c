// How the subcommands print what they found: one labelled row a line.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "clearway/types.h"

namespace clearway::cli {

/// Nine significant digits: enough to tell any two floats apart, few enough to read.
std::string readable(double value);
std::string readable(const Vector3& v);  ///< (x, y, z)
std::string readable(const Box& box);    ///< (x, y, z) to (x, y, z)

/// "1 triangle", "5 triangles"; an irregular plural is given.
std::string counted(std::size_t count, const std::string& singular, const std::string& plural = "");

/// The label, padded, then the value, to standard output.
void printRow(const std::string& label, const std::string& value);

/// Labels and values.
using Rows = std::vector<std::pair<std::string, std::string>>;

void printRows(const Rows& rows);

/// A message is one line of plain characters, whatever it quotes of a file or of a library.
std::string oneLine(std::string message);

/// Flushes standard output. Throws std::runtime_error when what was printed could not be written.
void requirePrinted();

}  // namespace clearway::cli
