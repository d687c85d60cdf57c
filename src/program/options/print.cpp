#include "program/options/print.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <stdexcept>

#include "core/number.h"
#include "core/replace_file.h"
#include "mesh/check.h"
#include "program/options/command_line.h"

namespace clearway::cli {

namespace {

constexpr std::size_t kLabelWidth = 20;

constexpr double kRounded = 1e-12;  // a value that far above a number of four digits is shown as that number

// Numbers from here on are shown whole, and with an exponent where a double has no digits left.
constexpr double kFirstLong = 9999.5, kFirstWithoutExponent = 1e15;

std::string& claimedBy() {
    static std::string option;
    return option;
}

std::string& unitInUse() {
    static std::string unit;
    return unit;
}

struct Deflection {
    double length = 0;
    bool isInMargin = false;
};

Deflection& deflectionInUse() {
    static Deflection deflection;
    return deflection;
}

/// The process's standard output once an option has claimed it.
std::ostream& standardOutput() {
    static std::ostream stream(std::cout.rdbuf());
    return stream;
}

}  // namespace

std::string readable(double value) {
    const double size = std::abs(value);
    const bool isLong = size >= kFirstLong && size < kFirstWithoutExponent;
    return isLong ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value + 0.0);  // -0 + 0 reads as 0
}

std::string readable(const Vector3& v) {
    return fmt::format("({}, {}, {})", readable(v.x()), readable(v.y()), readable(v.z()));
}

std::string readable(const Box& box) {
    return readable(Vector3(box.min())) + " to " + readable(Vector3(box.max()));
}

std::string shortened(double value, int digits) {
    const double rounded = value < 0 ? awayFromZero(value, digits) : towardsZero(value, digits);
    return fmt::format("{:.{}g}", rounded + 0.0, digits);  // -0 + 0 reads as 0
}

std::string shortenedUp(double value) {
    return readable(value < 0 ? towardsZero(value * (1 + kRounded), 4)
                              : awayFromZero(value * (1 - kRounded), 4));
}

void useUnit(const std::string& unit) {
    unitInUse() = unit;
}

const std::string& usedUnit() {
    return unitInUse();
}

std::string inUnit(const std::string& shown) {
    return withUnit(shown, usedUnit());
}

std::string shownLength(double value) {
    return inUnit(readable(value));
}

std::string shownPlace(const Vector3& place) {
    return inUnit(readable(place));
}

std::string statedLength(double value) {
    return inUnit(shortNumber(value));
}

std::string shownState(const PartState& state) {
    const auto& q = state.rotation;
    return fmt::format("position {}, quaternion (x, y, z, w) ({}, {}, {}, {})", shownPlace(state.position),
                       readable(q.x()), readable(q.y()), readable(q.z()), readable(q.w()));
}

std::string counted(std::size_t count, const std::string& singular, const std::string& plural) {
    return std::to_string(count) + " " + (count == 1 ? singular : plural.empty() ? singular + "s" : plural);
}

void printRow(const std::string& label, const std::string& value) {
    const std::size_t padding = kLabelWidth - std::min(label.size() + 1, kLabelWidth - 1);
    std::cout << label << (label.empty() ? ' ' : ':') << std::string(padding, ' ') << value << "\n";
}

void printRows(const Rows& rows) {
    for (const auto& [label, value] : rows) printRow(label, value);
}

std::string unitName(double metres) {
    for (const LengthUnit& unit : lengthUnits()) {
        if (std::abs(unit.metres - metres) <= 1e-9 * metres) return unit.name;
    }
    return readable(metres) + " m";
}

Rows readingRows(const MeshOrigin& origin) {
    Rows rows;
    const std::string turn = turnedByAssimp(origin);
    if (!turn.empty()) rows.push_back({"but turned", "by assimp: " + turn});
    // As OMPL.app reads a COLLADA file they are applied, and a note says so.
    const bool isApplied = std::any_of(origin.notes.begin(), origin.notes.end(),
                                       [](const std::string& note) { return note.find(kAssimpsUnit) == 0; });
    if (!isApplied && origin.unitMetres > 0) {
        rows.push_back({"unit stated", unitName(origin.unitMetres) + ", not applied"});
    }
    if (!isApplied && origin.upAxis != 0) {
        rows.push_back({"up axis stated", std::string(1, origin.upAxis) + ", not applied"});
    }
    for (const std::string& note : origin.notes) rows.push_back({"note", note});
    for (const std::string& warning : origin.warnings) rows.push_back({"warning", warning});
    return rows;
}

std::string readingWord(const MeshOrigin& origin) {
    return origin.isChecked ? "checked" : "unchecked";
}

bool isChecked(const Scene& scene) {
    return scene.part.origin().isChecked &&
           std::all_of(scene.obstacles.begin(), scene.obstacles.end(),
                       [](const Obstacle& obstacle) { return obstacle.model.origin().isChecked; });
}

std::string certificateScope(const Scene& scene) {
    return isChecked(scene) ? "" : " for the triangles that assimp delivered";
}

void useDeflection(double deflection, bool isInMargin) {
    deflectionInUse() = {deflection, isInMargin};
}

Rows deflectionRows() {
    const Deflection deflection = deflectionInUse();
    if (!(deflection.length > 0)) return {};
    const std::string length = statedLength(deflection.length);
    return {{"deflection", length + (deflection.isInMargin
                                         ? "; the margin holds the 2 x " + length +
                                               " by which the surfaces may be closer than these triangles"
                                         : "; certified for these triangles; the surfaces may be up to 2 x " +
                                               length + " closer")}};
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) std::cerr << "clearway: warning: " << warning << "\n";
}

std::string oneLine(std::string message) {
    while (!message.empty() && message.back() == '\n') message.pop_back();
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
    }
    return message;
}

void claimStandardOutput(const std::string& option) {
    if (!claimedBy().empty())
        throw std::invalid_argument(option + " is -, which " + claimedBy() +
                                    " is too, expected a file for one of them");
    claimedBy() = option;
    // The sink is never destroyed: std::cout is flushed after all objects of the program are gone.
    static Sink* const sink = new Sink;
    standardOutput().rdbuf(std::cout.rdbuf(sink));
}

void writeOut(const std::string& file, const std::function<void(std::ostream&)>& write) {
    if (file != "-") return replaceFile(file, write);
    write(standardOutput());
    if (!standardOutput().flush()) throw std::runtime_error("cannot write to standard output");
}

void requirePrinted() {
    if (!std::cout.flush()) throw std::runtime_error("cannot write to standard output");
}

ElapsedLine::ElapsedLine(std::string what, std::chrono::milliseconds pipedPeriod)
    : what_(std::move(what)), thread_([this, pipedPeriod] { run(pipedPeriod); }) {}

ElapsedLine::~ElapsedLine() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        isEnded_ = true;
    }
    ended_.notify_one();
    thread_.join();
}

void ElapsedLine::tell(std::string what) {
    const std::lock_guard<std::mutex> lock(mutex_);
    what_ = std::move(what);
}

void ElapsedLine::run(std::chrono::milliseconds pipedPeriod) {
    const bool isTerminal = isatty(STDERR_FILENO);
    const std::chrono::milliseconds period = isTerminal ? std::chrono::seconds(1) : pipedPeriod;
    std::unique_lock<std::mutex> lock(mutex_);
    for (auto time = period; !ended_.wait_for(lock, period, [this] { return isEnded_; }); time += period) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time).count();
        if (isTerminal)
            std::cerr << '\r' << what_ << ' ' << seconds << " s\033[K" << std::flush;
        else
            std::cerr << what_ << ' ' << seconds << " s" << std::endl;
    }
    if (isTerminal) std::cerr << "\r\033[K" << std::flush;
}

}  // namespace clearway::cli
