#include "program/options/help.h"

#include <assimp/version.h>
#include <fmt/format.h>
#include <ompl/config.h>

#if __has_include(<embree4/rtcore_config.h>)
#include <embree4/rtcore_config.h>
#else
#include <embree3/rtcore_config.h>
#endif

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <iostream>

#include "core/text.h"

namespace clearway::cli {

namespace {

struct Topic {
    const char* name;
    const char* text;
};

constexpr Topic kTopics[] = {
    {"keys",
     R"(Keys of a problem file. docs/problem_files.md explains each.

[problem]
  robot, world                 mesh files of the part and of what stands still (several with commas between)
  start.x .y .z                position of the part's origin, in the meshes' unit
  start.axis.x .y .z           axis of its rotation (SE(2): no z, no axis)
  start.theta                  angle of its rotation, radians
  goal.x ...                   as for start; not with goal = outside
  volume.min.x .. volume.max.z bounds of the position (derived from the environment, start and goal)
  objective, objective.threshold, sampler, threshold, name

[clearway]
  part = NAME, NAME            what moves of an assembly: all other components stand still
  reading = stored | omplapp   coordinates as the files hold them, or moved as OMPL.app moves them
  goal = outside               any pose outside of the surroundings' box; outside = +x, -x, ... says which side
  start.degrees, goal.degrees  in place of theta
  unit = mm                    of all lengths, shown beside them: um, mm, cm, m, km, in or ft
  robot.scale, world.scale     factors for the meshes' coordinates (1)
  margin, margin.NAME          distance to keep from all obstacles, from one (0)
  overlap, overlap.NAME        how deep obstacles may reach into the part, an open part into them (0)
  ignore, solid = NAME, ...    obstacles to leave out; obstacles whose inside is not free
  contact.start = NAME, D      ignored near the start; contact.goal: near the goal
  deflection                   how far the triangles may be from the CAD surfaces: shown beside clearances (0);
                               margin = deflection keeps both surfaces clear, 2 x as far
  fineness                     how fine the scene is: planners' edges are 20 times as long

[planner], [benchmark]         as in OMPL.app's files
)"},
    {"formats",
     R"(Formats of files.

Meshes     stl, obj, ply, off, 3mf, glb, gltf and dae; others are read by assimp alone, and not checked. STEP and
           IGES files become 3MF files by the program clearway-cad; CAD programs' own files hold surfaces, not
           triangles: export one of these.
Problems   .cfg, as OMPL.app's, with a section [clearway]: clearway help keys
Paths      one state a line: x y z qx qy qz qw, the quaternion's w last (SE(2): x y yaw, radians)
Poses      one a line: x y z qx qy qz qw, or 12 numbers: the rotation's rows and the translation of each
           (r00 r01 r02 r10 ... r22 x y z)
- stands for standard input, or for standard output in --csv, --path and --json
)"},
};

std::string version(unsigned major, unsigned minor, unsigned patch) {
    return fmt::format("{}.{}.{}", major, minor, patch);
}

/// The text for man: a hyphen is a minus, a line that begins with a dot is no macro.
std::string roff(std::string text) {
    boost::replace_all(text, "\\", "\\e");
    boost::replace_all(text, "-", "\\-");
    boost::replace_all(text, "\n.", "\n\\&.");
    return text;
}

/// Without its full stop, on one line.
std::string firstSentence(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::size_t end = text.find(". ");
    text = text.substr(0, end);
    if (!text.empty() && text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

std::vector<std::string> topicNames() {
    return namesOf(kTopics);
}

const char* topicNamed(const std::string& name) {
    for (const Topic& topic : kTopics) {
        if (name == topic.name) return topic.text;
    }
    return nullptr;
}

std::vector<std::pair<std::string, std::string>> libraryVersions() {
    return {{"OMPL", version(OMPL_MAJOR_VERSION, OMPL_MINOR_VERSION, OMPL_PATCH_VERSION)},
            {"assimp", version(aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())},
            {"Embree", RTC_VERSION_STRING}};
}

std::string completionScript(const std::vector<std::string>& subcommands) {
    return R"(# Completes the words of clearway, clearway-cad, clearway-scene and clearway-study in bash: . <(clearway --completion)
_clearway() {
    local word=${COMP_WORDS[COMP_CWORD]} subcommands=")" +
           joined(subcommands, " ") + R"( help" command=("$1" "${COMP_WORDS[1]}")
    COMPREPLY=()
    [ "${1##*/}" = clearway ] || command=("$1")
    if [ "$COMP_CWORD" -lt "${#command[@]}" ]; then
        COMPREPLY=($(compgen -W "$subcommands --help --man --version --completion" -- "$word"))
    elif [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$("${command[@]}" --list-options 2>/dev/null) --help --man" -- "$word"))
    elif [ "${COMP_WORDS[1]}" = help ]; then
        COMPREPLY=($(compgen -W "$subcommands )" +
           joined(topicNames(), " ") + R"(" -- "$word"))
    fi
}
complete -o default -F _clearway clearway clearway-cad clearway-scene clearway-study
)";
}

void printManPage(const ManPage& page) {
    std::cout << ".TH " << boost::to_upper_copy(page.name) << " 1 \"\" \"clearway\"\n"
              << ".SH NAME\n"
              << roff(page.name) << " \\- " << roff(firstSentence(page.purpose)) << "\n"
              << ".SH SYNOPSIS\n"
              << roff(page.usage) << "\n"
              << ".SH DESCRIPTION\n"
              << roff(page.purpose) << "\n";
    if (!page.rows.empty()) std::cout << ".SH " << page.heading << "\n";
    for (const auto& [words, help] : page.rows)
        std::cout << ".TP\n.B " << roff(words) << "\n" << roff(help) << "\n";
    std::cout
        << ".SH EXIT STATUS\n0: done; 1: the answer is no; 2: bad input or usage, with one line on standard "
           "error.\n";
}

}  // namespace clearway::cli
