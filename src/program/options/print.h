// How the program shows its work: labelled rows on standard output; warnings and a running clock on stderr.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <streambuf>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "clearway/problem.h"
#include "clearway/scene.h"

namespace clearway::cli {

/// Four significant digits, but whole numbers keep all of theirs. For what is to be computed with, there is --json.
std::string readable(double value);
std::string readable(const Vector3& v);  ///< (x, y, z)
std::string readable(const Box& box);    ///< (x, y, z) to (x, y, z)

/// Rounds down to so many digits, because a certified lower bound must not be shown as more than it is.
std::string shortened(double value, int digits = 4);
std::string shortenedUp(double value);  ///< rounds up to four digits: for upper bounds

/// The unit of the lengths that are shown from now on; empty at first: lengths are plain numbers.
void useUnit(const std::string& unit);
const std::string& usedUnit();

/// "12.5 mm": a text that shows a length or a place, and the unit in use.
std::string inUnit(const std::string& shown);
std::string shownLength(double value);           ///< readable(value), and the unit
std::string shownPlace(const Vector3& place);    ///< readable(place), and the unit
std::string statedLength(double value);          ///< with all digits that the user stated
std::string shownState(const PartState& state);  ///< position and quaternion, each named

/// "1 triangle", "5 triangles"; pass the plural when it is irregular.
std::string counted(std::size_t count, const std::string& singular, const std::string& plural = "");

/// Prints the padded label and the value to standard output. Without a label the value goes on with the row above.
void printRow(const std::string& label, const std::string& value);

using Rows = std::vector<std::pair<std::string, std::string>>;  ///< labels and values
void printRows(const Rows& rows);

/// "mm" for 0.001; "0.3 m" for a unit that problems cannot state.
std::string unitName(double metres);

/// Rows about how the mesh's file was read: turned axes, the unit and axis that it states, notes and warnings.
Rows readingRows(const MeshOrigin& origin);

/// "checked", or "unchecked" for a mesh that assimp alone read.
std::string readingWord(const MeshOrigin& origin);

/// Whether all meshes of the scene are checked.
bool isChecked(const Scene& scene);

/// Ends a certificate's row: empty when all meshes of the scene are checked.
std::string certificateScope(const Scene& scene);

/// Sets the deflection of the meshes whose clearances are shown from now on, in the unit in use; 0 if none is known. isInMargin: whether the
/// margin is at least twice as large.
void useDeflection(double deflection, bool isInMargin);

/// Says what certificates do not promise about the surfaces that the meshes were made for; no row if no deflection is known.
Rows deflectionRows();

/// Prints one line each on stderr.
void printWarnings(const std::vector<std::string>& warnings);

/// The message as one line of plain characters, whatever it quotes from a file or a library.
std::string oneLine(std::string message);

/// Drops all output written to it.
class Sink : public std::streambuf {
  protected:
    int overflow(int character) override { return character; }
    std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

/// Gives standard output to the option's file, which is `-`: from now on rows are not printed. Throws
/// std::invalid_argument when another option has it already.
void claimStandardOutput(const std::string& option);

/// Writes a file under a temporary name and renames it; writes to standard output if the file is `-`, which must be
/// claimed. Throws as replaceFile does.
void writeOut(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Flushes standard output. Throws std::runtime_error when what was printed could not be written.
void requirePrinted();

/// While an ElapsedLine lives, a line on stderr counts the seconds: "planning 12 s". Where stderr is no terminal, a new line every ten
/// seconds does.
class ElapsedLine {
  public:
    /// pipedPeriod: between two lines where stderr is no terminal.
    explicit ElapsedLine(std::string what, std::chrono::milliseconds pipedPeriod = std::chrono::seconds(10));
    ~ElapsedLine();               ///< wipes the line
    void tell(std::string what);  ///< from now on the line says this
    ElapsedLine(const ElapsedLine&) = delete;
    ElapsedLine& operator=(const ElapsedLine&) = delete;

  private:
    void run(std::chrono::milliseconds pipedPeriod);

    std::string what_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool isEnded_ = false;
    std::thread thread_;  ///< last: starts when the other members are ready
};

}  // namespace clearway::cli
