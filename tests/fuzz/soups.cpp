// For two triangle soups at a pose, every query on every instruction set keeps its promise. Exact arithmetic
// decides.
#include <cmath>
#include <iomanip>
#include <limits>
#include <stdexcept>

#include "clearway/model.h"
#include "clearway/query.h"
#include "clearway/targets.h"
#include "fuzz/bytes.h"
#include "fuzz/soup.h"
#include "support/exact_check.h"

namespace clearway::testing {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;
/// The absolute rounding error of results among denormal numbers.
constexpr double kLeast = std::numeric_limits<double>::denorm_min();
constexpr std::size_t kMostTriangles = 12;

struct Case {
    Mesh part;
    Mesh environment;
    Pose pose;
    BuildOptions options;
    bool isWild;
    ExactDistance distance;
    double sceneSize;
    double largest;  ///< M
};

/// Printed to the last digit if a promise is broken.
void describe(const Mesh& mesh, const char* name) {
    std::cerr << name << ", three corners a line:\n";
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const Vector3& corner : cornersOf(mesh, i)) std::cerr << corner.transpose() << "  ";
        std::cerr << "\n";
    }
}

void describe(const Case& given, const std::string& question) {
    std::cerr << std::setprecision(17) << question << " on " << currentTarget() << ", built by "
              << given.options.generalSplit << ", " << given.options.leafSplit << ", " << given.options.fit
              << ", leaves of " << given.options.leafSize << ", " << given.options.nodeWidth << " wide\n";
    describe(given.part, "part");
    describe(given.environment, "environment");
    std::cerr << "rotation\n"
              << given.pose.rotation << "\ntranslation " << given.pose.translation.transpose()
              << "\ndistance " << given.distance.rounded() << ", M " << given.largest << "\n";
}

double largestCoordinate(const Case& given) {
    double largest = given.pose.translation.cwiseAbs().maxCoeff();
    for (const Vector3& v : given.part.vertices) {
        largest = std::max({largest, v.cwiseAbs().maxCoeff(), (given.pose * v).cwiseAbs().maxCoeff()});
    }
    for (const Vector3& v : given.environment.vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    return largest;
}

bool areFinite(const Mesh& mesh) {
    for (const Vector3& v : mesh.vertices) {
        if (!v.allFinite()) return false;
    }
    return true;
}

/// Returns false if the numbers drawn form no meshes.
bool readCase(std::string_view input, Case& given) {
    Bytes bytes(input);
    given.isWild = bytes.below(8) == 7;
    given.options = takeOptions(bytes);
    SoupReader soup(bytes, given.isWild);
    given.part = soup.soup(kMostTriangles);
    given.environment = soup.soup(kMostTriangles);
    given.pose = soup.pose();
    if (!areFinite(given.part) || !areFinite(given.environment)) return false;
    if (!(rotationDefect(given.pose) <= kPoseDefect)) return false;
    given.largest = largestCoordinate(given);
    given.sceneSize =
        boundingBox(given.part).diagonal().norm() + boundingBox(given.environment).diagonal().norm();
    if (!(given.largest < 1e150)) return false;  // squares of lengths must be finite doubles
    given.distance = exactMeshDistance(given.part, given.environment, given.pose);
    return true;
}

/// Queries may refuse sizes and offsets that differ by about 2^60 or more, and they refuse tiny coordinates.
bool mayBeRefused(const Case& given) {
    if (given.largest < 1e-297) return true;
    const double part = boundingBox(given.part).diagonal().norm();
    const double environment = boundingBox(given.environment).diagonal().norm();
    return given.largest * 0x1p-55 > std::min(part, environment);
}

/// Exact arithmetic, because long double is far off near needles.
void requireWitness(const Vector3& point, const Pose& X, const std::array<Vector3, 3>& triangle,
                    double within) {
    const ExactDistance away = exactDistance(X, triangle, {point, point, point});
    require(away.compare(within) <= 0, "a witness lies on its triangle");
}

void requireWitnesses(const Case& given, const DistanceResult& result) {
    const double rounding = kUnitRoundoff * given.largest + kLeast;
    const double within = (result.collides() ? 16 : 8) * rounding;
    require(result.witness.has_value(), "a distance has a witness");
    const auto part = std::size_t(result.witness->partTriangle),
               other = std::size_t(result.witness->environmentTriangle);
    require(part < given.part.triangles.size() && other < given.environment.triangles.size(),
            "an id is that of a triangle");
    requireWitness(result.witness->pointOnPart, given.pose, cornersOf(given.part, part), within);
    requireWitness(result.witness->pointOnEnvironment, {}, cornersOf(given.environment, other), within);
    const double apart = (result.witness->pointOnPart - result.witness->pointOnEnvironment).norm();
    require(std::abs(apart - result.distance) <= 4 * rounding, "the distance is that of the witnesses");
    require(apart >= result.lower - 16 * rounding && result.upper >= apart - 4 * rounding &&
                result.upper <= apart + 16 * rounding,
            "the interval is about the witnesses");
}

void requireDistance(const Case& given, const DistanceOptions& options, const DistanceResult& result) {
    if (options.cap && result.lower >= *options.cap && result.upper > *options.cap) {
        require(given.distance.compare(result.lower) >= 0, "lower <= distance");
        return;
    }
    require(given.distance.compare(result.lower) >= 0, "lower <= distance");
    require(given.distance.compare(result.upper) <= 0, "distance <= upper");
    require(result.collides() == given.distance.isZero(), "an interval of 0 is contact");
    const double width = std::max({1e-12 * given.sceneSize + 32 * kUnitRoundoff * given.largest,
                                   options.absoluteError, options.relativeError * result.lower});
    require(result.upper - result.lower <= width * (1 + 1e-15) + 2 * kLeast,
            "the interval is as narrow as asked for");
    requireWitnesses(given, result);
}

/// The lengths at which a wrong decision is most likely.
std::vector<double> lengthsToAsk(const Case& given) {
    const double infinity = std::numeric_limits<double>::infinity();
    const auto root = static_cast<double>(given.distance.rounded());
    return {0,
            root,
            std::nextafter(root, infinity),
            std::max(0.0, std::nextafter(root, -1.0)),
            0.5 * root,
            2 * root,
            std::numeric_limits<double>::denorm_min()};
}

/// While it lives, a broken promise also prints what was asked.
class Asking {
  public:
    Asking(const Case& given, std::string question) {
        tellMore = [&given, question = std::move(question)] { describe(given, question); };
    }
    ~Asking() { tellMore = nullptr; }
};

void askDistance(const Case& given, const DistanceOptions& options, const Model& part,
                 const Model& environment, Workspace& workspace) {
    std::ostringstream question;
    question << std::setprecision(17) << "distance, relative error " << options.relativeError << ", cap "
             << options.cap.value_or(HUGE_VAL);
    const Asking asking(given, question.str());
    const DistanceResult result = distance(part, environment, given.pose, options, workspace);
    question << ": " << result.lower << " to " << result.upper;
    if (result.witness) {
        question << " by triangles " << result.witness->partTriangle << " and "
                 << result.witness->environmentTriangle << ", witnesses " << result.distance
                 << " apart: " << result.witness->pointOnPart.transpose() << " and "
                 << result.witness->pointOnEnvironment.transpose();
    }
    const Asking answered(given, question.str());
    requireDistance(given, options, result);
}

void requireAnswers(const Case& given, const Model& part, const Model& environment, Workspace& workspace) {
    askDistance(given, {}, part, environment, workspace);
    {
        const Asking asking(given, "collides");
        require(collides(part, environment, given.pose, workspace) == given.distance.isZero(),
                "collides is exact");
    }
    DistanceOptions options;
    options.relativeError = 0.1;
    askDistance(given, options, part, environment, workspace);
    for (const double d : lengthsToAsk(given)) {
        {
            std::ostringstream question;
            question << std::setprecision(17) << "isWithin " << d;
            const Asking asking(given, question.str());
            require(isWithin(part, environment, given.pose, d, workspace) == (given.distance.compare(d) <= 0),
                    "isWithin is exact");
        }
        DistanceOptions capped;
        capped.cap = d;
        askDistance(given, capped, part, environment, workspace);
    }
}

}  // namespace

void fuzzOne(std::string_view input) {
    Case given;
    if (!readCase(input, given)) return;
    const Model part = Model::build(given.part, given.options);
    const Model environment = Model::build(given.environment, given.options);
    for (const std::string& target : availableTargets()) {
        useTarget(target);
        Workspace workspace;
        try {
            for (int warm = 0; warm < 2; ++warm) requireAnswers(given, part, environment, workspace);
        } catch (const std::invalid_argument& error) {
            require(mayBeRefused(given), std::string("coordinates of like sizes are taken: ") + error.what());
        }
    }
    useTarget("best");
}

std::vector<std::string> seeds() {
    std::vector<std::string> result;
    for (int step = 1; step < 24; ++step) {  // each step makes other choices everywhere
        std::string bytes;
        for (int i = 0; i < 300; ++i) bytes += static_cast<char>((i * step + i / 7) % 251);
        bytes[0] = char(step % 8);
        result.push_back(bytes);
    }
    return result;
}

}  // namespace clearway::testing
