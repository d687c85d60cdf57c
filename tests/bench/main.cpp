// Runs a benchmark: benchmarks NAME [ARGUMENT...]. README.md in this folder describes each.
#include <algorithm>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>

namespace clearway::testing {

// The benchmarks, one file each. words: the benchmark's name and its arguments. Each returns the program's exit code: 1 when an
// answer is wrong, 2 when it is used wrongly; `public` 77, with which a test is skipped, when there is nothing to measure. Each throws
// std::exception when it cannot run.
// clang-format off
namespace anytime_clearance { int run(int count, char** words); }
namespace certified_motions { int run(int count, char** words); }
namespace fcl_continuous { int run(int count, char** words); }
namespace fcl_first_path { int run(int count, char** words); }
namespace fcl_motions { int run(int count, char** words); }
namespace from_files { int run(int count, char** words); }
namespace growth { int run(int count, char** words); }
namespace kernels { int run(int count, char** words); }
namespace ladder { int run(int count, char** words); }
namespace loading { int run(int count, char** words); }
namespace motions { int run(int count, char** words); }
namespace overlaps { int run(int count, char** words); }
namespace plan_success { int run(int count, char** words); }
namespace public_problems { int run(int count, char** words); }
namespace queries { int run(int count, char** words); }
namespace samplers { int run(int count, char** words); }
namespace speed_error { int run(int count, char** words); }
namespace strategies { int run(int count, char** words); }
// clang-format on

namespace {

struct Benchmark {
    const char* name;
    int (*run)(int count, char** words);
};

constexpr Benchmark kBenchmarks[] = {
    {"anytime_clearance", anytime_clearance::run},
    {"certified_motions", certified_motions::run},
    {"fcl_continuous", fcl_continuous::run},
    {"fcl_first_path", fcl_first_path::run},
    {"fcl_motions", fcl_motions::run},
    {"from_files", from_files::run},
    {"growth", growth::run},
    {"kernels", kernels::run},
    {"ladder", ladder::run},
    {"loading", loading::run},
    {"motions", motions::run},
    {"overlaps", overlaps::run},
    {"plan_success", plan_success::run},
    {"public", public_problems::run},
    {"queries", queries::run},
    {"samplers", samplers::run},
    {"speed_error", speed_error::run},
    {"strategies", strategies::run},
};

int tellNames(std::ostream& out, int code) {
    out << "Usage: benchmarks NAME [ARGUMENT...]\n\nNames:\n";
    for (const Benchmark& each : kBenchmarks) out << "  " << each.name << '\n';
    return code;
}

int runNamed(int count, char** words) {
    if (count < 2) return tellNames(std::cerr, 2);
    const std::string name = words[1];
    if (name == "--help") return tellNames(std::cout, 0);
    const auto found = std::find_if(std::begin(kBenchmarks), std::end(kBenchmarks),
                                    [&](const Benchmark& each) { return each.name == name; });
    if (found == std::end(kBenchmarks)) {
        std::cerr << "benchmarks: there is no benchmark '" << name << "', expected one of:\n";
        return tellNames(std::cerr, 2);
    }
    try {
        return found->run(count - 1, words + 1);
    } catch (const std::exception& error) {
        std::cerr << "benchmarks " << name << ": " << error.what() << '\n';
        return 2;
    }
}

}  // namespace
}  // namespace clearway::testing

int main(int count, char** words) {
    return clearway::testing::runNamed(count, words);
}
