// This program in another process, which does one piece of work and prints its result.
#pragma once

#include <sys/types.h>

#include <array>
#include <string>
#include <vector>

namespace clearway::study {

class ChildProcess {
  public:
    /// Starts this program with these words after its name. It is no rank, whatever this process is, and finds no input.
    /// Throws std::runtime_error when no process can be started.
    explicit ChildProcess(const std::vector<std::string>& words);
    ~ChildProcess();  ///< kills the process unless it has ended
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Takes what the process has printed so far, and waits for more or for its end, but at most so long. Returns whether it
    /// has ended. Throws std::runtime_error when its output cannot be read.
    bool hasEnded(int milliseconds);
    void waitForEnd();

    // After the end:
    bool isDone() const;                                ///< ended by itself with exit code 0
    int signal() const;                                 ///< that ended the process; 0 if none did
    const std::string& output() const { return out_; }  ///< complete if the process isDone()
    std::string fault()
        const;  ///< how the process ended, with its last line on stderr: "exit code 2: no room"

  private:
    void closeAll();

    pid_t process_ = -1;
    bool hasEnded_ = false;
    int status_ = 0;
    std::array<int, 2> pipes_ = {-1, -1};  ///< its standard output and stderr; -1 where closed
    std::string out_, err_;
};

/// For a child: from now on the system kills this process when its parent ends, however it ends.
void endWithParent();

}  // namespace clearway::study
