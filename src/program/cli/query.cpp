// clearway query: asks one question at every pose of a file; writes the answers as a table, and their cost.
#include "clearway/query.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>
#include <stdexcept>

#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/targets.h"
#include "core/number.h"
#include "core/text.h"
#include "mesh/components.h"
#include "program/cli/query_answers.h"
#include "program/options/facts.h"
#include "program/options/load_guard.h"
#include "program/options/print.h"
#include "program/options/shared_options.h"

namespace clearway::cli {

namespace {

constexpr std::size_t kMostShown = 20;  ///< answers on screen

/// Shuffles by Fisher-Yates on the engine itself, because std::shuffle and the standard's distributions
/// differ between libraries.
std::vector<std::size_t> orderOf(std::size_t count, std::optional<std::uint64_t> shuffleSeed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!shuffleSeed) return order;
    std::mt19937_64 random(*shuffleSeed);
    for (std::size_t left = count; left > 1; --left) std::swap(order[left - 1], order[random() % left]);
    return order;
}

Answer askOnce(const Question& question, const Model& part, const Model& environment,
               const Pose& X_environmentPart, Workspace& workspace) {
    Answer answer;
    const auto begin = std::chrono::steady_clock::now();
    switch (question.kind) {
        case Question::Kind::kDistance:
            answer.distance = distance(part, environment, X_environmentPart, question.distance, workspace);
            break;
        case Question::Kind::kCollide:
            answer.verdict = collides(part, environment, X_environmentPart, workspace);
            break;
        case Question::Kind::kWithin:
            answer.verdict = isWithin(part, environment, X_environmentPart, question.within, workspace);
            break;
    }
    const auto end = std::chrono::steady_clock::now();
    answer.nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(end - begin).count();
    return answer;
}

/// Asks once. A refusal names the pose, counted as in the table.
Answer askAbout(std::size_t pose, const Question& question, const Model& part, const Model& environment,
                const Pose& X_environmentPart, Workspace& workspace) {
    try {
        return askOnce(question, part, environment, X_environmentPart, workspace);
    } catch (const std::invalid_argument& refusal) {
        throw std::invalid_argument("pose " + std::to_string(pose) + ": " + refusal.what());
    }
}

std::string outOf(std::size_t count, const QueryRun& run) {
    return fmt::format("{} of {}", count, run.answers.size());
}

std::string quotedNameAt(const Model& model, std::int64_t component) {
    const std::string name = nameAt(model, component);
    return name.empty() ? "" : "'" + name + "' ";
}

/// The answer in words: the distance, and the two closest points with their triangles.
std::string describe(const Question& question, const Answer& answer, const Model& part,
                     const Model& environment) {
    if (question.kind != Question::Kind::kDistance) return answer.verdict ? "yes" : "no";
    const DistanceResult& found = answer.distance;
    if (!found.witness) return "beyond the cap";
    return fmt::format("{}, on the part {}triangle {} at {}, on the environment {}triangle {} at {}",
                       readable(found.distance), quotedNameAt(part, found.witness->partComponent),
                       found.witness->partTriangle, readable(found.witness->pointOnPart),
                       quotedNameAt(environment, found.witness->environmentComponent),
                       found.witness->environmentTriangle, readable(found.witness->pointOnEnvironment));
}

void printFirst(const Question& question, const QueryRun& run, const Model& part, const Model& environment) {
    const std::size_t shown = std::min(run.answers.size(), kMostShown);
    for (std::size_t i = 0; i < shown; ++i)
        printRow("pose " + std::to_string(i), describe(question, run.answers[i], part, environment));
    if (question.kind == Question::Kind::kDistance && shown > 0)
        printRow("", "(closest points in the environment's frame; poses and triangles count from 0)");
    if (shown < run.answers.size())
        printRow("", fmt::format("{} more poses; --csv or --json writes all", run.answers.size() - shown));
}

/// Asks at every pose, in the file's order or shuffled, with one workspace.
QueryRun ask(const Question& question, const Model& part, const Model& environment,
             const std::vector<Pose>& poses) {
    QueryRun run;
    run.answers.resize(poses.size());
    Workspace workspace;
    for (const std::size_t pose : orderOf(poses.size(), question.shuffleSeed)) {
        if (question.isCold) workspace.forgetWarmStart();
        run.answers[pose] = askAbout(pose, question, part, environment, poses[pose], workspace);
        run.counters += workspace.counters();
    }
    return run;
}

/// How many answers are yes; for distances, what they are like.
Facts answersFacts(const Question& question, const QueryRun& run) {
    if (question.kind != Question::Kind::kDistance) {
        const std::size_t yes = countYes(run);
        if (question.kind == Question::Kind::kCollide)
            return {{"colliding", outOf(yes, run), "colliding", yes}};
        return {{"within " + readable(question.within), outOf(yes, run), "within", yes}};
    }
    const DistanceStatistics all = statisticsOf(run.answers);
    const auto at = [&](const char* label, const char* name, const std::optional<std::size_t>& pose) -> Fact {
        if (!pose) return kept(name, {});
        const double distance = run.answers[*pose].distance.distance;
        return {label,
                fmt::format("{} at pose {}", readable(distance), *pose),
                name,
                {{"distance", toJson(distance)}, {"pose", *pose}}};
    };
    return {{"colliding", outOf(all.colliding, run), "colliding", all.colliding},
            shownIf(all.beyond > 0, {"beyond the cap", outOf(all.beyond, run), "beyond_cap", all.beyond}),
            at("least distance", "least", all.least),
            at("most distance", "most", all.most),
            shownIf(all.least.has_value(),
                    {"widest interval", readable(all.widest), "widest_interval", toJson(all.widest)})};
}

void printCosts(const QueryRun& run, const Model& part, const Model& environment) {
    const BuildReport &ofPart = part.report(), &ofEnvironment = environment.report();
    const auto perQuery = [&](std::uint64_t count) {
        return readable(static_cast<double>(count) / static_cast<double>(run.answers.size()));
    };
    const double bytes = static_cast<double>(ofPart.tree.bytes + ofEnvironment.tree.bytes);
    const double triangles = static_cast<double>(ofPart.triangles + ofEnvironment.triangles);
    printRows({{"volume tests per query", perQuery(run.counters.volumeTests)},
               {"triangle tests per query", perQuery(run.counters.triangleTests)},
               {"pairs in double per query", perQuery(run.counters.refinedPairs)},
               {"  in double-double", perQuery(run.counters.doubleDoublePairs)},
               {"  exact", perQuery(run.counters.exactPairs)},
               {"bytes per triangle", readable(bytes / triangles)},
               {"build seconds", readable(ofPart.seconds + ofEnvironment.seconds)}});
}

struct QueryArguments {
    std::string part, environment, poses, csv;
    LoadOptions load;
    Question question;
    TreeChoice trees;
};

/// Reads "distance", "collide" or "within=D".
void readQuestion(const std::string& text, Question& question) {
    const bool isWithin = text.rfind("within=", 0) == 0;
    if (isWithin) {
        question.kind = Question::Kind::kWithin;
        question.within = parseNumber(text.substr(7)).value_or(-1);
    } else if (text == "collide") {
        question.kind = Question::Kind::kCollide;
    }
    if (isWithin ? question.within < 0 : text != "distance" && text != "collide") {
        throw Expected{"distance, collide or within=D with a number D of at least 0" +
                       didYouMean(text.substr(0, text.find('=')), {"distance", "collide", "within"})};
    }
}

bool readArguments(const Arguments& arguments, QueryArguments& given) {
    constexpr auto kRequired = CommandLine::Count::kRequired;
    Question& question = given.question;
    CommandLine line(
        "clearway query --part MESH --environment MESH --poses FILE --query distance|collide|within=D "
        "[options]",
        "Asks one question about the part at every pose (environment coordinates of the part's). A pose is "
        "one line\n"
        "of 12 numbers (rotation row-major, translation) or 7 (x y z qx qy qz qw, w last). Meshes are read "
        "as "
        "stored.");
    line.option("--part MESH", "mesh of the moving part", to(given.part), kRequired);
    line.option("--environment MESH", "mesh of the obstacles, which stand still", to(given.environment),
                kRequired);
    line.option("--poses FILE", "the poses, one a line; - is standard input", input(given.poses), kRequired);
    line.option(
        "--query Q", "distance, collide, or within=D: is the distance at most D?",
        [&](const std::string& text) { readQuestion(text, question); }, kRequired);
    line.option("--csv FILE", "writes the answers, one row a pose in the file's order", to(given.csv));
    line.option("--scale F", "factor for both meshes' coordinates, not for the poses (1)",
                positive(given.load.scale));
    const auto distanceOnly = [&](auto& to) {
        return [&](const std::string& value) {
            if (question.kind != Question::Kind::kDistance) throw Expected{"only with --query distance"};
            to = nonNegativeNumber(value);
        };
    };
    line.option("--cap C", "reports a distance above C as inf, with triangles -1",
                distanceOnly(question.distance.cap));
    line.option("--relative-error E", "allows an interval of E times its lower end (0)",
                distanceOnly(question.distance.relativeError));
    line.option("--absolute-error E", "allows an interval of width E; the wider of the two counts (0)",
                distanceOnly(question.distance.absoluteError));
    addTarget(line);
    addJson(line);
    line.flag("--cold", "forgets the closest pairs of earlier queries before every query", question.isCold);
    line.option("--shuffle SEED", "asks in a random order; the answers keep the file's order",
                integer<std::uint64_t>(question.shuffleSeed, 0, INT64_MAX));
    addTreeOptions(line, given.trees.options);
    addCache(line, given.trees);
    return line.parse(arguments);
}

void describeMesh(const char* label, const Model& model) {
    printRow(label, counted(model.report().triangles, "triangle"));
    for (const auto& [name, text] : readingRows(model.origin())) printRow("  " + name, text);
}

}  // namespace

int query(const Arguments& arguments) {
    QueryArguments given;
    if (!readArguments(arguments, given)) return kDone;
    OutputFiles files({given.part, given.environment, given.poses});
    files.addOrStandardOutput("--csv", given.csv);
    requireFactsFile(files);
    const PoseFile poses = readPoses(given.poses);
    double deflection = 0;
    const auto load = [&](const std::string& file) {
        const Mesh mesh = guardedLoadMesh(file, given.load);
        deflection = std::max(deflection, deflectionOf(mesh));
        return given.trees.build(mesh, given.trees.options);
    };
    const Model part = load(given.part), environment = load(given.environment);
    if (const std::string note = unitNote(part.box(), environment.box(), ""); !note.empty())
        printWarnings({note});
    const QueryRun run = ask(given.question, part, environment, poses.poses);

    describeMesh("part", part);
    describeMesh("environment", environment);
    printRow("trees", treeDescription(given.trees.options));
    printRow("instruction set", currentTarget());
    printRow("poses", fmt::format("{}, {} of them projected to the nearest rotation", poses.poses.size(),
                                  poses.projected));
    printFirst(given.question, run, part, environment);
    tellDeflection(deflection);
    printRows(deflectionRows());
    Facts statistics = answersFacts(given.question, run);
    const double rate = queriesPerSecond(run);
    statistics.push_back({"queries/s", readable(rate), "queries_per_second", toJson(rate)});
    keepAnswers(given.question, poses.poses, run, part, environment);
    printRows(rowsOf(statistics));
    facts()["statistics"] = toJson(statistics);
    printCosts(run, part, environment);
    requirePrinted();
    if (!given.csv.empty()) writeAnswers(given.question, poses.poses, run, part, environment, given.csv);
    return kDone;
}

}  // namespace clearway::cli
