// The processes that mpirun, or Slurm's srun, started together, and the texts that they send each other. They are told apart by
// numbers, their ranks. No other file sees MPI.
#pragma once

#include <optional>
#include <string>

namespace clearway::study {

/// Whether mpirun or srun started this process to work together with others. MPI is not asked: the environment tells.
bool isRank();

class Ranks {
  public:
    struct Message {
        int from = 0;
        std::string text;
    };

    /// Joins the other processes. At most one object may ever exist in a process. Throws std::runtime_error when this program
    /// was built without MPI.
    Ranks();

    /// Does not take leave of the others. A process that ends without leave() ends all of them, which is what an error asks for.
    ~Ranks() = default;
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int rank() const { return rank_; }  ///< counted from 0
    int count() const { return count_; }

    void send(int to, const std::string& text);

    /// Takes the next message if one has come. Does not wait: MPI's own waiting uses up a processor.
    std::optional<Message> receive();

    /// Takes leave of the others, which must do so too. After this nothing can be sent, and the process may go on alone.
    void leave();
    bool hasLeft() const { return hasLeft_; }

  private:
    int rank_ = 0, count_ = 1;
    bool hasLeft_ = false;
};

}  // namespace clearway::study
