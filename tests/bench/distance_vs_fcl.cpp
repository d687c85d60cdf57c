// Distance queries of clearway and of FCL 0.7's RSS on the same meshes, poses, process and repetitions.
//   bench_distance_vs_fcl [--part F --environment F --poses F] [--csv F] ...      see --help
// Each repetition runs all poses with one library, then all with the next, so that each finds its own tree in
// the caches; a pose's time is its median over the repetitions. Ends with 1 when an answer of clearway is
// wrong.
#include <algorithm>
#include <boost/program_options.hpp>
#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <utility>

#include "bench/fcl_rss.h"
#include "clearway/model.h"
#include "clearway/problem.h"
#include "clearway/query.h"
#include "clearway/targets.h"
#include "core/number.h"
#include "core/replace_file.h"
#include "scenes/tunnel_console.h"
#include "support/oracle.h"
#include "support/random_meshes.h"

namespace {

using namespace clearway;
using namespace clearway::testing;
namespace options = boost::program_options;

constexpr double kAgreement = 1e-9;  // of the scene size

struct Task {
    Mesh part;
    Mesh environment;
    std::vector<Pose> poses;
};

struct Row {
    DistanceResult result;
    QueryCounters coldCounters;
    double fclDistance = 0;
    std::optional<double> truth;          // the oracle's, where it was asked
    std::vector<double> warm, cold, fcl;  // nanoseconds, one a repetition
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// Half of the poses lie on the path, evenly by its states; half beside it, some of them by a lot: most of
// those collide.
std::vector<Pose> posesAlong(const std::vector<PartState>& path, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Pose> poses;
    for (int i = 0; i < count; ++i) {
        const double place = (path.size() - 1) * (i + 0.5) / count;
        const auto segment = std::min(static_cast<std::size_t>(place), path.size() - 2);
        const PartState &from = path[segment], &to = path[segment + 1];
        const double share = place - static_cast<double>(segment);
        PartState state;
        state.position = (1 - share) * from.position + share * to.position;
        state.rotation = from.rotation.slerp(share, to.rotation);
        const double astray = i % 2 == 0 ? 0 : std::pow(10.0, random.uniform(1, 2.3));  // 10 to 200 mm
        const Matrix3 turn =
            Eigen::AngleAxisd(astray * 1e-3 * random.normal(), random.direction()).toRotationMatrix();
        const Pose pose = poseOf(state);
        poses.push_back(nearestPose({pose.rotation * turn, pose.translation + astray * random.direction()}));
    }
    return poses;
}

Task taskOf(const options::variables_map& given) {
    if (given.count("part") != 0) {
        return {loadMesh(given["part"].as<std::string>()), loadMesh(given["environment"].as<std::string>()),
                readPoses(given["poses"].as<std::string>()).poses};
    }
    SceneOptions scene = kTunnelConsole;
    scene.partTriangles = given["part-triangles"].as<std::size_t>();
    scene.environmentTriangles = given["environment-triangles"].as<std::size_t>();
    GeneratedScene made = makeTunnelConsole(scene);
    const std::vector<Pose> poses =
        posesAlong(made.path, given["pose-count"].as<int>(), given["seed"].as<std::uint64_t>());
    return {std::move(made.part), std::move(made.environment), poses};
}

double timedDistance(const Model& part, const Model& environment, const Pose& pose, Workspace& workspace,
                     DistanceResult& result) {
    const auto start = std::chrono::steady_clock::now();
    result = distance(part, environment, pose, {}, workspace);
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

void runOnce(std::vector<Row>& rows, const Task& task, const Model& part, const Model& environment,
             const FclRssPair& fcl) {
    Workspace workspace;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].warm.push_back(timedDistance(part, environment, task.poses[i], workspace, rows[i].result));
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const FclRssPair::Answer answer = fcl.distance(task.poses[i]);
        rows[i].fcl.push_back(answer.nanoseconds);
        rows[i].fclDistance = answer.distance;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        workspace.forgetWarmStart();
        DistanceResult result;
        rows[i].cold.push_back(timedDistance(part, environment, task.poses[i], workspace, result));
        rows[i].coldCounters = result.counters;
    }
}

void writeRows(const std::vector<Row>& rows, const std::string& file) {
    replaceFile(file, [&](std::ostream& out) {
        out << "pose,distance,lower,upper,fcl_distance,oracle_distance,warm_ns,cold_ns,fcl_ns,warm_node_"
               "visits,"
               "cold_node_visits,cold_volume_tests,cold_triangle_tests\n";
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Row& row = rows[i];
            out << i << ',' << formatNumber(row.result.distance) << ',' << formatNumber(row.result.lower)
                << ',' << formatNumber(row.result.upper) << ',' << formatNumber(row.fclDistance) << ','
                << (row.truth ? formatNumber(*row.truth) : "") << ',' << formatNumber(median(row.warm)) << ','
                << formatNumber(median(row.cold)) << ',' << formatNumber(median(row.fcl)) << ','
                << row.result.counters.nodeVisits << ',' << row.coldCounters.nodeVisits << ','
                << row.coldCounters.volumeTests << ',' << row.coldCounters.triangleTests << '\n';
        }
    });
}

// Total over the rows of one repetition.
double total(const std::vector<Row>& rows, std::vector<double> Row::*times, std::size_t repetition) {
    double sum = 0;
    for (const Row& row : rows) sum += (row.*times)[repetition];
    return sum;
}

void printTimes(const std::string& name, const std::vector<Row>& rows, std::vector<double> Row::*times) {
    std::vector<double> ofPoses, ratios;
    for (const Row& row : rows) ofPoses.push_back(median(row.*times));
    for (std::size_t r = 0; r < rows.front().fcl.size(); ++r) {
        ratios.push_back(total(rows, &Row::fcl, r) / total(rows, times, r));
    }
    double sum = 0;
    for (const double time : ofPoses) sum += time;
    std::cout << name << ": mean " << sum / rows.size() / 1000 << " us, median " << median(ofPoses) / 1000
              << " us, " << 1e9 * rows.size() / sum << " queries/s, " << median(ratios) << " times FCL ("
              << *std::min_element(ratios.begin(), ratios.end()) << " to "
              << *std::max_element(ratios.begin(), ratios.end()) << ")\n";
}

void printAllTimes(const std::vector<Row>& rows) {
    std::vector<Row> free, colliding;
    for (const Row& row : rows) (row.result.collides() ? colliding : free).push_back(row);
    for (const auto& [name, group] :
         {std::pair("all", rows), std::pair("free", free), std::pair("colliding", colliding)}) {
        if (group.empty()) continue;
        std::cout << name << ", " << group.size() << " poses\n";
        printTimes("  clearway warm", group, &Row::warm);
        printTimes("  clearway cold", group, &Row::cold);
        printTimes("  FCL RSS      ", group, &Row::fcl);
    }
}

// Where the two differ, or everywhere, the oracle decides. Returns how many answers of clearway are wrong.
int judge(std::vector<Row>& rows, const Task& task, bool everywhere) {
    const MeshOracle oracle(task.part, task.environment);
    const double tolerance = kAgreement * oracle.sceneSize();
    int differ = 0, fclWrong = 0, wrong = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Row& row = rows[i];
        const double fclDistance = std::max(row.fclDistance, 0.0);
        const bool agree = std::abs(row.result.distance - fclDistance) <= tolerance;
        differ += !agree;
        if (agree && !everywhere) continue;
        row.truth = oracle.distance(task.poses[i]).distance;
        fclWrong += std::abs(fclDistance - *row.truth) > tolerance;
        if (std::abs(row.result.distance - *row.truth) > tolerance) {
            ++wrong;
            std::cout << "pose " << i << ": clearway " << row.result.distance << ", oracle " << *row.truth
                      << '\n';
        }
    }
    std::cout << "answers that differ by more than " << tolerance << ": " << differ
              << "; by the oracle, wrong are " << fclWrong << " of FCL's and " << wrong << " of clearway's\n";
    return wrong;
}

void printWork(const std::vector<Row>& rows) {
    double visits = 0, coldVisits = 0, volumes = 0, triangles = 0;
    int touching = 0;
    for (const Row& row : rows) {
        visits += static_cast<double>(row.result.counters.nodeVisits);
        coldVisits += static_cast<double>(row.coldCounters.nodeVisits);
        volumes += static_cast<double>(row.coldCounters.volumeTests);
        triangles += static_cast<double>(row.coldCounters.triangleTests);
        touching += row.result.collides();
    }
    const auto n = static_cast<double>(rows.size());
    std::cout << rows.size() << " poses, " << touching << " colliding; a query visits " << visits / n
              << " nodes warm, " << coldVisits / n << " cold, and tests cold " << volumes / n << " volumes, "
              << triangles / n << " triangle pairs\n";
}

options::options_description allOptions() {
    options::options_description all("options");
    auto add = all.add_options();
    add("help", "print this");
    add("part", options::value<std::string>(), "mesh file; then also --environment and --poses");
    add("environment", options::value<std::string>(), "mesh file");
    add("poses", options::value<std::string>(), "poses file");
    add("part-triangles", options::value<std::size_t>()->default_value(73000),
        "of the generated tunnel-console");
    add("environment-triangles", options::value<std::size_t>()->default_value(300000), "likewise");
    add("pose-count", options::value<int>()->default_value(200), "along and beside its path");
    add("seed", options::value<std::uint64_t>()->default_value(1), "of those poses");
    add("repetitions", options::value<int>()->default_value(5), "of every pose");
    add("general-split", options::value<std::string>()->default_value(BuildOptions().generalSplit),
        "strategy");
    add("leaf-split", options::value<std::string>()->default_value(BuildOptions().leafSplit), "strategy");
    add("leaf-size", options::value<int>()->default_value(BuildOptions().leafSize), "triangles");
    add("node-width", options::value<int>()->default_value(BuildOptions().nodeWidth), "children");
    add("target", options::value<std::string>()->default_value("best"), "instruction set");
    add("verify", "asks the oracle about every pose, not only where the two differ");
    add("csv", options::value<std::string>(), "writes one row a pose");
    return all;
}

int run(const options::variables_map& given) {
    useTarget(given["target"].as<std::string>());
    const Task task = taskOf(given);
    if (task.poses.empty()) throw std::invalid_argument("there are 0 poses, expected at least 1");
    BuildOptions build;
    build.generalSplit = given["general-split"].as<std::string>();
    build.leafSplit = given["leaf-split"].as<std::string>();
    build.leafSize = given["leaf-size"].as<int>();
    build.nodeWidth = given["node-width"].as<int>();
    const Model part = Model::build(task.part, build), environment = Model::build(task.environment, build);
    const FclRssPair fcl(task.part, task.environment);
    std::cout << task.part.triangles.size() << " / " << task.environment.triangles.size() << " triangles, "
              << build.generalSplit << '/' << build.leafSplit << ", leaves of " << build.leafSize
              << ", width " << build.nodeWidth << ", " << currentTarget() << "; built in "
              << part.report().seconds + environment.report().seconds << " s, FCL " << fcl.buildSeconds()
              << " s\n";

    std::vector<Row> rows(task.poses.size());
    runOnce(rows, task, part, environment, fcl);  // meets everything once; not counted
    for (Row& row : rows) row.warm.clear(), row.cold.clear(), row.fcl.clear();
    const int repetitions = std::max(1, given["repetitions"].as<int>());
    for (int i = 0; i < repetitions; ++i) runOnce(rows, task, part, environment, fcl);

    printWork(rows);
    printAllTimes(rows);
    const int wrong = judge(rows, task, given.count("verify") != 0);
    if (given.count("csv") != 0) writeRows(rows, given["csv"].as<std::string>());
    return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        options::variables_map given;
        options::store(options::parse_command_line(argc, argv, allOptions()), given);
        if (given.count("help") != 0) {
            std::cout << allOptions();
            return 0;
        }
        const std::size_t files = given.count("part") + given.count("environment") + given.count("poses");
        if (files != 0 && files != 3) {
            throw std::invalid_argument("--part, --environment and --poses are given together or not at all");
        }
        return run(given);
    } catch (const std::exception& error) {
        std::cerr << "bench_distance_vs_fcl: " << error.what() << '\n';
        return 2;
    }
}
