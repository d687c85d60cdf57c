#include "support/ppl_scene.h"

#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "core/number.h"
#include "core/text.h"
#include "support/byu_mesh.h"

namespace clearway::testing {
namespace {

struct Line {
    int number = 0;
    std::vector<std::string> words;
};

[[noreturn]] void refuse(const std::string& file, const Line& line, const std::string& expected) {
    throw std::invalid_argument(place(file, line.number) + quote(clearway::joined(line.words, " ")) +
                                " is there, expected " + expected);
}

/// The lines that are neither empty nor comments. The brackets, colons and semicolons of a boundary become
/// spaces.
std::vector<Line> linesOf(const std::string& file, const char* expected) {
    std::vector<Line> found;
    int number = 0;
    for (std::string text : readLines(file, expected)) {
        ++number;
        if (trimmed(text).rfind("Boundary", 0) == 0) {
            for (char& c : text) {
                if (c == '[' || c == ']' || c == ':' || c == ';') c = ' ';
            }
        }
        Line line{number, {}};
        for (const std::string_view word : words(text)) line.words.emplace_back(word);
        if (!line.words.empty() && line.words[0][0] != '#') found.push_back(line);
    }
    return found;
}

/// The line after the one that begins with the word, or the (after)th; null when there is none.
const Line* lineAfter(const std::vector<Line>& lines, const std::string& word, std::size_t after) {
    for (std::size_t i = 0; i + after < lines.size(); ++i) {
        if (lines[i].words[0] == word) return &lines[i + after];
    }
    return nullptr;
}

std::vector<double> numbersFrom(const std::string& file, const Line& line, std::size_t from,
                                std::size_t count, const std::string& expected) {
    std::vector<double> numbers;
    for (std::size_t i = from; i < line.words.size(); ++i) {
        const std::optional<double> number = parseNumber(line.words[i]);
        if (!number) refuse(file, line, expected);
        numbers.push_back(*number);
    }
    if (numbers.size() != count) refuse(file, line, expected);
    return numbers;
}

Box boundsIn(const std::string& file, const std::vector<Line>& lines) {
    const std::string expected = "Boundary Box [a:b ; c:d ; e:f] with a < b, c < d and e < f";
    const Line* line = lineAfter(lines, "Boundary", 0);
    if (line == nullptr)
        throw std::invalid_argument(file + ": no line begins with Boundary, expected " + expected);
    if (line->words.size() < 2 || line->words[1] != "Box") refuse(file, *line, expected);
    const std::vector<double> n = numbersFrom(file, *line, 2, 6, expected);
    const Box bounds(Vector3(n[0], n[2], n[4]), Vector3(n[1], n[3], n[5]));
    if (!(bounds.sizes().minCoeff() > 0)) refuse(file, *line, expected);
    return bounds;
}

std::string beside(const std::string& file, const std::string& name) {
    return (std::filesystem::path(file).parent_path() / name).string();
}

/// Reads "FILE [-c(red green blue alpha)] x y z a b c".
void readObstacle(const std::string& file, const std::vector<Line>& lines, PplScene& scene) {
    const std::string expected = "an obstacle's mesh file, its position and three angles of 0";
    const Line* line = lineAfter(lines, "Passive", 1);
    if (line == nullptr)
        throw std::invalid_argument(file + ": no line follows Passive, expected " + expected);
    std::size_t next = 1;
    if (line->words.size() > 1 && line->words[1].rfind("-c(", 0) == 0) {
        while (next < line->words.size() && line->words[next].back() != ')') ++next;
        ++next;
    }
    const std::vector<double> n = numbersFrom(file, *line, next, 6, expected);
    if (n[3] != 0 || n[4] != 0 || n[5] != 0) refuse(file, *line, expected);
    scene.obstacleFile = beside(file, line->words[0]);
    scene.obstaclePosition = {n[0], n[1], n[2]};
}

void readRobot(const std::string& file, PplScene& scene) {
    const std::string expected = "a robot of one body, Volumetric and Rotational";
    const std::vector<Line> lines = linesOf(file, "a .robot or .env file");
    const Line* active = lineAfter(lines, "Active", 1);
    const Line* count = active != nullptr ? active : lines.empty() ? nullptr : &lines[0];
    if (count == nullptr || count == &lines.back())
        throw std::invalid_argument(file + ": the file ends, expected " + expected);
    if (count->words != std::vector<std::string>{"1"}) refuse(file, *count, expected);
    const Line& body = *(count + 1);
    const std::vector<std::string>& words = body.words;
    if (words.size() < 3 || words[words.size() - 2] != "Volumetric" || words.back() != "Rotational")
        refuse(file, body, expected);
    scene.robotFile = beside(file, words[0]);
}

PartState stateOf(const std::vector<double>& n) {
    using Turn = Eigen::AngleAxisd;
    PartState state;
    state.position = {n[1], n[2], n[3]};
    state.rotation = Turn(M_PI * n[6], Vector3::UnitZ()) * Turn(M_PI * n[5], Vector3::UnitY()) *
                     Turn(M_PI * n[4], Vector3::UnitX());
    return state;
}

void readQuery(const std::string& file, PplScene& scene) {
    const std::string expected = "two lines of a robot's number, a position and three angles";
    const std::vector<Line> lines = linesOf(file, "a .query file");
    if (lines.size() != 2)
        throw std::invalid_argument(file + ": it has " + std::to_string(lines.size()) + " lines, expected " +
                                    expected);
    scene.start = stateOf(numbersFrom(file, lines[0], 0, 7, expected));
    scene.goal = stateOf(numbersFrom(file, lines[1], 0, 7, expected));
}

}  // namespace

PplScene readPplScene(const std::string& envFile, const std::string& robotFile,
                      const std::string& queryFile) {
    PplScene scene;
    const std::vector<Line> lines = linesOf(envFile, "a .env file");
    scene.bounds = boundsIn(envFile, lines);
    readObstacle(envFile, lines, scene);
    readRobot(robotFile, scene);
    readQuery(queryFile, scene);
    return scene;
}

Mesh loadPplMesh(const std::string& file) {
    const bool isByu = boost::iends_with(file, ".g");
    Mesh mesh = isByu ? readByuMesh(file) : loadMesh(file);
    Vector3 sum = Vector3::Zero();
    double count = 0;
    std::set<std::tuple<double, double, double>> distinct;
    for (const Vector3& vertex : mesh.vertices) {
        // assimp makes a vertex for each corner of an .obj's triangle.
        if (!isByu && !distinct.emplace(vertex.x(), vertex.y(), vertex.z()).second) continue;
        sum += vertex;
        ++count;
    }
    mesh.origin.shift = -sum / count;
    for (Vector3& vertex : mesh.vertices) vertex += mesh.origin.shift;
    return mesh;
}

}  // namespace clearway::testing
