#include "program/bench/ranks.h"

#include <chrono>
#include <cstdlib>
#include <list>
#include <sstream>
#include <stdexcept>
#include <thread>

#ifdef CLEARWAY_WITH_MPI
#include <mpi.h>
#endif

namespace clearway::study {
namespace {

// Rank 0 sends messages of the first two kinds, the other ranks send the rest.
enum Kind { kJobs, kDismissal, kResult, kEnd, kFailure };

struct Message {
    int rank = 0;  ///< the other one
    int kind = kEnd;
    std::string text;
};

// MPI ends all processes when a call fails, so no result of a call is looked at.
#ifdef CLEARWAY_WITH_MPI

/// A message on its way. MPI moves long ones only while both sides call MPI, so neither side waits for them.
struct Transfer {
    Message message;
    MPI_Request request = MPI_REQUEST_NULL;

    bool isDone() {
        int isDone = 0;
        MPI_Test(&request, &isDone, MPI_STATUS_IGNORE);
        return isDone != 0;
    }
};
std::list<Transfer> outgoing, incoming;

void send(Message message) {
    Transfer& sent = outgoing.emplace_back(Transfer{std::move(message)});
    MPI_Isend(sent.message.text.data(), static_cast<int>(sent.message.text.size()), MPI_CHAR,
              sent.message.rank, sent.message.kind, MPI_COMM_WORLD, &sent.request);
}

/// Moves what is on its way.
bool isAllSent() {
    outgoing.remove_if([](Transfer& sent) { return sent.isDone(); });
    return outgoing.empty();
}

/// Takes the messages in the order in which they were announced.
std::optional<Message> receive() {
    int isThere = 0, length = 0;
    MPI_Status status;
    while (MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &isThere, &status), isThere != 0) {
        MPI_Get_count(&status, MPI_CHAR, &length);
        const std::string room(static_cast<std::size_t>(length), ' ');
        Transfer& next = incoming.emplace_back(Transfer{{status.MPI_SOURCE, status.MPI_TAG, room}});
        MPI_Irecv(next.message.text.data(), length, MPI_CHAR, next.message.rank, next.message.kind,
                  MPI_COMM_WORLD, &next.request);
    }
    if (incoming.empty() || !incoming.front().isDone()) return std::nullopt;
    Message message = std::move(incoming.front().message);
    incoming.pop_front();
    return message;
}

#else

void send(const Message&) {}
bool isAllSent() {
    return true;
}
std::optional<Message> receive() {
    return std::nullopt;
}
#endif

/// Between two looks for messages. MPI's own waiting would use up a processor.
void sleepABit() {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

Message receiveNext() {
    std::optional<Message> message;
    for (; !message; message = receive()) sleepABit();
    return *message;
}

}  // namespace

bool isRank() {
    const auto has = [](const char* variable) { return std::getenv(variable) != nullptr; };
    if (has("OMPI_COMM_WORLD_RANK")) return true;  // Open MPI's mpirun
    // srun sets the others in a shell that is its only task, too, and so for all programs that the shell starts.
    const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
    if (tasks != nullptr && std::string(tasks) == "1") return false;
    return has("PMIX_RANK") || has("PMI_RANK");  // Open MPI under srun; MPICH and Intel MPI
}

Ranks::Ranks() {
#ifdef CLEARWAY_WITH_MPI
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);  // only the main thread uses MPI
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    std::atexit([] {  // mpirun ends the other processes by itself, srun does not
        int hasLeft = 0;
        MPI_Finalized(&hasLeft);
        if (!hasLeft) MPI_Abort(MPI_COMM_WORLD, /*exit code*/ 2);
    });
#else
    throw std::runtime_error(
        "this program was started by mpirun or srun as one of several, and built without MPI, expected one "
        "process alone or a build with -DCLEARWAY_MPI=ON");
#endif
}

void Ranks::share(const std::vector<std::string>& jobs, const DoJob& doJob,
                  const std::function<void(const std::string& result)>& take,
                  const std::function<void()>& pause) {
    const auto all = static_cast<std::size_t>(count_);
    for (std::size_t rank = 1; rank < all; ++rank) {
        std::string lines;
        for (std::size_t i = rank; i < jobs.size(); i += all) lines += jobs[i] + "\n";
        send({static_cast<int>(rank), kJobs, lines});
    }
    while (!isAllSent()) sleepABit();

    int working = count_ - 1;
    const auto gather = [&] {
        while (const auto message = receive()) {
            if (message->kind == kResult) take(message->text);
            if (message->kind == kEnd) --working;
            if (message->kind == kFailure)
                throw std::runtime_error("rank " + std::to_string(message->rank) + ": " + message->text);
        }
        pause();
    };
    for (std::size_t i = 0; i < jobs.size(); i += all) {
        const auto result = doJob(jobs[i]);
        if (!result) break;
        take(*result);
        gather();
    }
    for (; working > 0; gather()) sleepABit();
}

void Ranks::serve(const DoJob& doJob) {
    for (;;) {
        const Message message = receiveNext();
        if (message.kind == kDismissal) break;
        std::istringstream jobs(message.text);
        for (std::string job; std::getline(jobs, job); isAllSent()) {
            const auto result = doJob(job);
            if (!result) break;
            send({0, kResult, *result});
        }
        send({0, kEnd, ""});
    }
    isDismissed_ = true;
}

void Ranks::fail(const std::string& why) {
    send({0, kFailure, why});
}

void Ranks::leave() {
    if (hasLeft_) return;
    for (int rank = 1; rank_ == 0 && rank < count_; ++rank) send({rank, kDismissal, ""});
    while (rank_ > 0 && !isDismissed_) isDismissed_ = receiveNext().kind == kDismissal;
    while (!isAllSent()) sleepABit();
#ifdef CLEARWAY_WITH_MPI
    MPI_Finalize();
#endif
    hasLeft_ = true;
}

}  // namespace clearway::study
