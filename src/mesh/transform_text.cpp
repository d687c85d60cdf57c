#include "mesh/transform_text.h"

#include <cmath>
#include <sstream>

namespace clearway {

namespace {

std::string rowText(const Eigen::Matrix<double, 1, 4>& row) {
    const char* const variables[] = {"x", "y", "z", ""};
    std::ostringstream text;
    text.precision(9);
    for (int column = 0; column < 4; ++column) {
        const double factor = row[column];
        if (factor == 0) continue;
        if (text.tellp() > 0) {
            text << (factor < 0 ? " - " : " + ");
        } else if (factor < 0) {
            text << '-';
        }
        const bool isUnit = column < 3 && std::fabs(factor) == 1;
        if (!isUnit) text << std::fabs(factor) << (column < 3 ? " " : "");
        text << variables[column];
    }
    return text.tellp() > 0 ? text.str() : "0";
}

}  // namespace

std::string transformText(const Eigen::Matrix<double, 3, 4>& transform) {
    return "x' = " + rowText(transform.row(0)) + ", y' = " + rowText(transform.row(1)) +
           ", z' = " + rowText(transform.row(2));
}

}  // namespace clearway
