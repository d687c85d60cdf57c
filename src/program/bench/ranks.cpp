#include "program/bench/ranks.h"

#include <cstdlib>
#include <stdexcept>

#ifdef CLEARWAY_WITH_MPI
#include <mpi.h>
#endif

namespace clearway::study {
namespace {

bool has(const char* variable) {
    return std::getenv(variable) != nullptr;
}

/// A shell that srun started as a single task, and what is started in it, are in no company.
bool isSlurmsOnlyTask() {
    const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
    return tasks != nullptr && std::string(tasks) == "1";
}

}  // namespace

bool isRank() {
    if (has("OMPI_COMM_WORLD_RANK")) return true;  // Open MPI's mpirun
    // Open MPI under srun; MPICH and Intel MPI.
    return (has("PMIX_RANK") || has("PMI_RANK")) && !isSlurmsOnlyTask();
}

#ifdef CLEARWAY_WITH_MPI

Ranks::Ranks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);  // only the main thread uses MPI
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

// MPI ends the whole job when a call fails, so that no result of a call is looked at.

void Ranks::send(int to, const std::string& text) {
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, /*tag*/ 0, MPI_COMM_WORLD);
}

std::optional<Ranks::Message> Ranks::receive() {
    int hasCome = 0, length = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, /*tag*/ 0, MPI_COMM_WORLD, &hasCome, &status);
    if (!hasCome) return std::nullopt;
    MPI_Get_count(&status, MPI_CHAR, &length);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
    MPI_Recv(message.text.data(), length, MPI_CHAR, message.from, /*tag*/ 0, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
}

void Ranks::leave() {
    hasLeft_ = true;
    MPI_Finalize();
}

#else

Ranks::Ranks() {
    throw std::runtime_error(
        "this program was started by mpirun or srun as one of several, and built without MPI, expected one "
        "process alone or a build with -DCLEARWAY_MPI=ON");
}

void Ranks::send(int, const std::string&) {}
std::optional<Ranks::Message> Ranks::receive() {
    return std::nullopt;
}
void Ranks::leave() {}

#endif

}  // namespace clearway::study
