// Runs a fuzz target without libFuzzer: first on its seeds, then on random mutations of them.
//   replay_X [--runs N] [--seed S] [--seconds S]   N mutations (1000) from seed S (1), for at most S seconds
//   replay_X FILE...                                these inputs only
//   replay_X --write FOLDER                         writes the seeds, as libFuzzer's first corpus
// It writes an input that ends the program to crash-X in the current folder.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "fuzz/bytes.h"
#include "support/random_meshes.h"

namespace clearway::testing {
namespace {

std::string program;
std::string current;

extern "C" void keepCurrent(int) {
    // The process ends anyway; at worst this write fails too.
    std::ofstream("crash-" + program, std::ios::binary) << current;
    std::cerr << "the input is in crash-" << program << std::endl;
    std::signal(SIGABRT, SIG_DFL);
    std::abort();
}

void runOne(std::string input) {
    current = std::move(input);
    // A copy of exactly this size, so that reading past its end is reading past the end of a block.
    const std::vector<char> exact(current.begin(), current.end());
    fuzzOne({exact.data(), exact.size()});
}

/// Changes, inserts, cuts out or repeats bytes, or writes an edge value of a number over them.
void edit(Random& random, std::string& text) {
    constexpr std::int64_t kEdges[] = {0, 1, -1, INT32_MAX, INT32_MIN, INT64_MAX, INT64_MIN, 1 << 16};
    const int size = static_cast<int>(text.size());
    const auto at = static_cast<std::size_t>(random.below(size + 1));
    const auto length = static_cast<std::size_t>(1 + random.below(16));
    switch (random.below(7)) {
        case 0:
            text.insert(at, 1, static_cast<char>(random.bits()));
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, text.substr(static_cast<std::size_t>(random.below(size + 1)), length));
            break;
        case 3: {
            const std::int64_t edge = kEdges[random.below(8)];
            const std::size_t bytes = std::size_t(1) << random.below(4);
            text.replace(at, bytes, reinterpret_cast<const char*>(&edge), bytes);
            break;
        }
        default:
            if (at < text.size()) text[at] = static_cast<char>(random.bits());
    }
}

std::string mutated(Random& random, const std::vector<std::string>& starts) {
    std::string text = starts[static_cast<std::size_t>(random.below(static_cast<int>(starts.size())))];
    if (random.below(16) == 0) {  // nothing but noise
        text.resize(static_cast<std::size_t>(random.below(600)));
        for (char& character : text) character = static_cast<char>(random.bits());
    }
    for (int edits = 1 + random.below(8); edits > 0; --edits) edit(random, text);
    return text;
}

std::string contentOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error(file + ": cannot be read, expected an input");
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeSeeds(const std::string& folder) {
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : seeds()) {
        std::ofstream(folder + "/seed" + std::to_string(number++), std::ios::binary) << seed;
    }
}

void runMutations(std::uint64_t seed, int runs, double seconds) {
    const auto start = std::chrono::steady_clock::now();
    const auto isTimeLeft = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds;
    };
    const std::vector<std::string> starts = seeds();
    for (const std::string& input : starts) runOne(input);
    Random random(seed);
    int run = 0;
    for (; run < runs && isTimeLeft(); ++run) runOne(mutated(random, starts));
    std::cout << program << ": " << starts.size() << " seeds, " << run << " mutations from seed " << seed
              << "\n";
}

int run(const std::vector<std::string>& words) {
    int runs = 1000;
    std::uint64_t seed = 1;
    double seconds = 1e9;
    std::vector<std::string> files;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word = words[i];
        const bool isOption = word.compare(0, 2, "--") == 0;
        if (isOption && i + 1 == words.size()) throw std::invalid_argument(word + " has no value");
        if (!isOption)
            files.push_back(word);
        else if (word == "--write")
            return writeSeeds(words[i + 1]), 0;
        else if (word == "--runs")
            runs = std::stoi(words[++i]);
        else if (word == "--seed")
            seed = std::stoull(words[++i]);
        else if (word == "--seconds")
            seconds = std::stod(words[++i]);
        else
            throw std::invalid_argument(word + " is unknown, expected --runs, --seed, --seconds or --write");
    }
    for (const std::string& file : files) runOne(contentOf(file));
    if (files.empty()) runMutations(seed, runs, seconds);
    return 0;
}

}  // namespace
}  // namespace clearway::testing

int main(int argc, char** argv) {
    using namespace clearway::testing;
    program = std::filesystem::path(argv[0]).filename().string();
    std::signal(SIGABRT, keepCurrent);
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << program << ": " << error.what() << "\n";
        return 2;
    }
}
