// The processes that mpirun, or Slurm's srun, started together, told apart by numbers, their ranks. Rank 0 shares jobs out and
// gathers their results. No other file sees MPI.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace clearway::study {

/// Whether mpirun or srun started this process to work together with others. Decided from environment variables, before
/// MPI_Init.
bool isRank();

/// Does a job and returns its result. Returns nothing when the job was stopped.
using DoJob = std::function<std::optional<std::string>(const std::string& job)>;

class Ranks {
  public:
    /// Joins the other processes. At most one object may ever exist in a process. A process that ends without leave() ends all
    /// of them, because an error made it do so. Throws std::runtime_error when this program was built without MPI.
    Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int rank() const { return rank_; }  ///< counted from 0
    int count() const { return count_; }

    /// For rank 0: job i is for the rank i modulo count(), which may be this one, so jobs of one kind should follow each other.
    /// Each rank does its jobs in their order, and none after one that was stopped. Calls `take` for each result, and `pause`
    /// after each job here and often while others still work. Throws std::runtime_error when another rank failed.
    void share(const std::vector<std::string>& jobs, const DoJob& doJob,
               const std::function<void(const std::string& result)>& take,
               const std::function<void()>& pause);

    /// For the other ranks: does what rank 0 shares out, until it leaves.
    void serve(const DoJob& doJob);

    /// For the other ranks: makes rank 0's share() throw.
    void fail(const std::string& why);

    /// Calls MPI_Finalize, for which the other ranks wait for rank 0. Afterwards the process may go on alone. A second call does
    /// nothing.
    void leave();

  private:
    int rank_ = 0, count_ = 1;
    bool isDismissed_ = false, hasLeft_ = false;
};

}  // namespace clearway::study
