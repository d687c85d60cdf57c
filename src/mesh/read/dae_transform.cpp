#include "mesh/read/dae_transform.h"

#include <fmt/format.h>
#include <cmath>

namespace clearway {

using pugi::xml_node;

namespace {

std::vector<double> numbersOf(const DaeDocument& document, const xml_node& element, std::size_t count) {
    std::string joinedText;
    const std::string what = fmt::format("<{}> of {}", element.name(), DaeDocument::textOf(element.parent()));
    std::vector<double> numbers = numbersIn<double>(textOf(element, joinedText), what, document.mesh());
    if (numbers.size() == count) return numbers;
    document.mesh().refuse("{} has {} numbers, expected {}", what, numbers.size(), count);
}

void requireDirection(const DaeDocument& document, const xml_node& node, const Vector3& direction,
                      const char* element) {
    if (direction.norm() > 0) return;
    document.mesh().refuse("{} of {} has no direction, expected one that is not 0", element,
                           DaeDocument::textOf(node));
}

/// Quarter turns are exact, so that boxes stay boxes.
Placement rotationOf(const std::vector<double>& numbers) {
    const double degrees = std::remainder(numbers[3], 360.0);
    const double radians = degrees * (std::acos(-1.0) / 180);
    const bool isQuarter = std::remainder(degrees, 90.0) == 0;
    const double sine = isQuarter ? std::round(std::sin(radians)) : std::sin(radians);
    const double cosine = isQuarter ? std::round(std::cos(radians)) : std::cos(radians);
    const Vector3 given(numbers[0], numbers[1], numbers[2]);
    if (degrees == 0) return {};  // some exporters write no axis then
    const Vector3 axis = given / given.norm();
    Matrix3 cross;
    cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    Placement placement;
    placement.linear = cosine * Matrix3::Identity() + (1 - cosine) * axis * axis.transpose() + sine * cross;
    return placement;
}

/// Moves the origin to the eye and turns -z towards the point of interest.
Placement lookAtOf(const std::vector<double>& numbers) {
    const Vector3 eye(numbers[0], numbers[1], numbers[2]), interest(numbers[3], numbers[4], numbers[5]);
    const Vector3 up(numbers[6], numbers[7], numbers[8]);
    const Vector3 back = (eye - interest).normalized();
    const Vector3 right = up.cross(back).normalized();
    Placement placement;
    placement.linear << right, back.cross(right), back;
    placement.translation = eye;
    return placement;
}

}  // namespace

Placement daeMatrixOf(const DaeDocument& document, const xml_node& element) {
    const std::vector<double> m = numbersOf(document, element, 16);
    constexpr double kRounding = 1e-6;  // of texts with few digits
    if (std::abs(m[12]) + std::abs(m[13]) + std::abs(m[14]) + std::abs(m[15] - 1) > kRounding) {
        document.mesh().refuse("<{}> of {} has another last row than 0 0 0 1", element.name(),
                               DaeDocument::textOf(element.parent()));
    }
    Placement placement;
    placement.linear << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    placement.translation << m[3], m[7], m[11];
    return placement;
}

Placement daeTransformOf(const DaeDocument& document, const xml_node& node) {
    Placement placement;
    for (const xml_node element : node) {
        const std::string_view name = element.name();
        Placement step;
        if (name == "matrix") {
            step = daeMatrixOf(document, element);
        } else if (name == "translate") {
            const std::vector<double> numbers = numbersOf(document, element, 3);
            step.translation << numbers[0], numbers[1], numbers[2];
        } else if (name == "scale") {
            const std::vector<double> numbers = numbersOf(document, element, 3);
            step.linear.diagonal() << numbers[0], numbers[1], numbers[2];
        } else if (name == "rotate") {
            const std::vector<double> numbers = numbersOf(document, element, 4);
            if (numbers[3] != 0)
                requireDirection(document, node, Vector3(numbers[0], numbers[1], numbers[2]), "<rotate>");
            step = rotationOf(numbers);
        } else if (name == "lookat") {
            const std::vector<double> numbers = numbersOf(document, element, 9);
            const Vector3 view(numbers[0] - numbers[3], numbers[1] - numbers[4], numbers[2] - numbers[5]);
            requireDirection(document, node, Vector3(numbers[6], numbers[7], numbers[8]).cross(view),
                             "<lookat>");
            step = lookAtOf(numbers);
        } else if (name == "skew") {
            document.mesh().refuse(DaeDocument::textOf(node) + " has a <skew>, which is not read");
        } else {
            continue;
        }
        placement = placement * step;
    }
    return placement;
}

}  // namespace clearway
