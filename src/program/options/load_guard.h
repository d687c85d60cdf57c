// Protects programs from the library that reads their files: assimp crashes on some damaged files, never
// ends on others, and writes to the standard streams.
#pragma once

#include <csignal>
#include <streambuf>
#include <string>
#include <vector>

#include "clearway/mesh.h"

namespace clearway::cli {

/// Who reads what: "clearway: cannot read mesh 'FILE': the reader (assimp) crashed".
struct GuardedReader {
    const char* program = "clearway";
    const char* kind = "mesh";
    const char* library = "assimp";
};

/// While a LoadGuard lives, the program ends with exit code 2 and one line on stderr that names the file, if
/// it crashes (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, also from a full stack) or takes more than `seconds`
/// of processor time. Output to std::cout and std::cerr is dropped. A guard protects the thread that makes
/// it; only one guard may live at a time. The destructor restores handlers, timer and streams.
class LoadGuard {
  public:
    LoadGuard(const std::string& file, int seconds, const GuardedReader& reader = {});
    ~LoadGuard();
    LoadGuard(const LoadGuard&) = delete;
    LoadGuard& operator=(const LoadGuard&) = delete;

  private:
    void setTimer(int seconds);
    struct Previous {
        int signal;
        struct sigaction action;
    };
    std::vector<Previous> previous_;
    std::vector<char> stack_;  ///< the handler's stack: the usual one may be full
    stack_t previousStack_;
    std::streambuf* out_;
    std::streambuf* err_;
};

/// Processor time that reading the file may take: 20 s for small files, always far more than is needed.
int secondsToLoad(const std::string& file);

/// Calls loadMesh behind a LoadGuard. The program reads all meshes with this MeshReader.
Mesh guardedLoadMesh(const std::string& file, const LoadOptions& options);

}  // namespace clearway::cli
