// Times how a mesh file becomes a Mesh, by clearway's readers and by assimp alone. Each load runs in a process of its own, whose
// memory shows what the load took.
//   benchmarks loading [--triangles N] [--formats stl,obj,...] [--repetitions N] [--cpu N] [--out DIR]
// Ends with exit code 1 when a reader misses a triangle.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "bench/linked_rings.h"
#include "bench/pinned.h"
#include "bench/series.h"
#include "bench/task_options.h"
#include "clearway/mesh.h"
#include "core/clock.h"
#include "mesh/read/assimp.h"
#include "support/temporary_folder.h"

namespace clearway::testing::loading {

struct Load {
    double seconds = 0, megabytes = 0;  ///< memory beyond that of the process before it
    std::size_t triangles = 0;
};

double megabytesSoFar() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

Mesh read(const std::string& file, bool byAssimp) {
    return byAssimp ? readByAssimp(file, MeshReading::kAsStored).mesh : loadMesh(file);
}

/// Does the work in a child process on this CPU, so that its memory is not that of earlier work, and returns its result.
Load inChild(int cpu, const std::function<Load()>& work) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("a pipe could not be made");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("a process could not be made");
    if (child == 0) {
        Load load;
        runPinned(cpu, [&] { load = work(); });
        _exit(write(ends[1], &load, sizeof load) == ssize_t(sizeof load) ? 0 : 1);
    }
    close(ends[1]);
    Load load;
    const bool isTold = ::read(ends[0], &load, sizeof load) == ssize_t(sizeof load);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!isTold || status != 0) throw std::runtime_error("a child process failed");
    return load;
}

Load writeRing(std::size_t triangles, const std::string& file) {
    const Mesh mesh = ring(triangles);
    saveMesh(mesh, file);
    return {0, 0, mesh.triangles.size()};
}

Load loadOnce(const std::string& file, bool byAssimp) {
    const double before = megabytesSoFar();
    const auto begin = Clock::now();
    const Mesh mesh = read(file, byAssimp);
    return {secondsSince(begin), megabytesSoFar() - before, mesh.triangles.size()};
}

int run(int count, char** words) {
    int triangles = 1'700'000, repetitions = 5, cpu = -1;
    std::string formats = "stl,obj,glb,ply", out;
    cli::CommandLine line("benchmarks loading [options]",
                          "Times how mesh files are read, by clearway and by assimp.");
    line.option("--triangles N", "triangles of the mesh (1700000)",
                cli::integer<int>(triangles, 100, 100'000'000));
    line.option("--formats LIST", "endings of the files (stl,obj,glb,ply)", cli::to(formats));
    line.option("--repetitions N", "loads of each file by each reader (5)",
                cli::integer<int>(repetitions, 1, 1000));
    line.option("--cpu N", "the processor that loads run on", cli::integer<int>(cpu, 0, 1 << 20));
    line.option("--out DIR", "writes loading.csv there", cli::to(out));
    if (!line.parse({words + 1, words + count})) return 0;
    const TemporaryFolder folder;
    std::ostringstream table;
    table << "format,triangles,reader,megabytes_of_file,seconds,megabytes,wrong\n" << std::setprecision(4);
    bool isWrong = false;
    for (const std::string& format : splitAtCommas(formats)) {
        const std::string file = folder.file("ring." + format);
        const std::size_t expected =
            inChild(cpu, [&] { return writeRing(std::size_t(triangles), file); }).triangles;
        std::array<std::vector<Load>, 2> loads;
        for (int i = 0; i < repetitions; ++i) {
            for (const bool byAssimp : {false, true})
                loads[byAssimp].push_back(inChild(cpu, [&] { return loadOnce(file, byAssimp); }));
        }
        for (const bool byAssimp : {false, true}) {
            std::vector<double> seconds, megabytes;
            std::size_t wrong = 0;
            for (const Load& load : loads[byAssimp]) {
                seconds.push_back(load.seconds);
                megabytes.push_back(load.megabytes);
                wrong += load.triangles != expected;
            }
            isWrong = isWrong || wrong > 0;
            table << format << ',' << expected << ',' << (byAssimp ? "assimp" : "clearway") << ','
                  << double(std::filesystem::file_size(file)) * 1e-6 << ',' << median(seconds) << ','
                  << median(megabytes) << ',' << wrong << '\n';
        }
    }
    std::cout << table.str();
    writeTable(out, "loading.csv", table.str());
    return isWrong ? 1 : 0;
}

}  // namespace clearway::testing::loading
