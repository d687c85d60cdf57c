// What stands between the program and the library that reads mesh files: assimp crashes on some damaged ones,
// does not end on others, and writes to the standard streams.
#pragma once

#include <csignal>
#include <streambuf>
#include <string>
#include <vector>

#include "clearway/mesh.h"
#include "clearway/problem.h"

namespace clearway::cli {

/// While it lives, a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT; a full stack as well), and more than
/// `seconds` of the processor's time, end the program with exit code 2 and one line on standard error that
/// names the file. What is written to std::cout and std::cerr is dropped. For the thread it is made in, one
/// at a time; the destructor puts back what was there.
class LoadGuard {
  public:
    LoadGuard(const std::string& file, int seconds);
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
    std::vector<char> stack_;  ///< the handler's own: the usual one may be what is full
    stack_t previousStack_;
    std::streambuf* out_;
    std::streambuf* err_;
};

/// Of the processor's time: far more than a file of that size takes to read, 20 for small ones.
int secondsToLoad(const std::string& file);

/// loadMesh, loadPart and loadWorlds behind a LoadGuard.
Mesh guardedLoadMesh(const std::string& file, const LoadOptions& options);
Mesh guardedLoadPart(const Problem& problem);
std::vector<Mesh> guardedLoadWorlds(const Problem& problem);

}  // namespace clearway::cli
