#include "program/cli/print.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <stdexcept>

namespace clearway::cli {

namespace {

constexpr std::size_t kLabelWidth = 20;

}  // namespace

std::string readable(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value == 0 ? 0.0 : value);  // -0 reads as 0
    return text;
}

std::string readable(const Vector3& v) {
    return "(" + readable(v.x()) + ", " + readable(v.y()) + ", " + readable(v.z()) + ")";
}

std::string readable(const Box& box) {
    return readable(Vector3(box.min())) + " to " + readable(Vector3(box.max()));
}

std::string counted(std::size_t count, const std::string& singular, const std::string& plural) {
    return std::to_string(count) + " " + (count == 1 ? singular : plural.empty() ? singular + "s" : plural);
}

void printRow(const std::string& label, const std::string& value) {
    const std::size_t padding = kLabelWidth - std::min(label.size() + 1, kLabelWidth - 1);
    std::cout << label << ":" << std::string(padding, ' ') << value << "\n";
}

void printRows(const Rows& rows) {
    for (const auto& [label, value] : rows) printRow(label, value);
}

std::string oneLine(std::string message) {
    while (!message.empty() && message.back() == '\n') message.pop_back();
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
    }
    return message;
}

void requirePrinted() {
    if (!std::cout.flush()) throw std::runtime_error("cannot write to standard output");
}

}  // namespace clearway::cli
