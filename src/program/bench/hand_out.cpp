#include "program/bench/hand_out.h"

#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "program/bench/child_process.h"

namespace clearway::study {
namespace {

/// Between two looks at the process and at messages. Runs take seconds, so that this costs them nothing.
constexpr int kMilliseconds = 10;

// A message is a letter and a text. Rank 0 sends the first two, the others send the rest.
constexpr char kJob = 'j';      ///< the job's words, each with a 0 after it
constexpr char kDismiss = 'd';  ///< no text
constexpr char kDone = 'o';     ///< what the job's process printed
constexpr char kLost = 'l';     ///< how the job's process ended
constexpr char kStopped = 's';  ///< no text

std::string messageOf(const Job& job) {
    std::string text(1, kJob);
    for (const std::string& word : job.words) text += word + '\0';
    return text;
}

std::vector<std::string> wordsIn(const std::string& message) {
    std::vector<std::string> words;
    for (std::size_t begin = 1; begin < message.size();) {
        const std::size_t end = message.find('\0', begin);
        words.push_back(message.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

/// The process of one rank's job, if it has one.
class Worker {
  public:
    void begin(const std::vector<std::string>& words) {
        try {
            process_ = std::make_unique<ChildProcess>(words);
        } catch (const std::runtime_error& error) {
            failure_ = error.what();
        }
    }

    void drop() { process_.reset(); }

    /// Returns the job's end as a message. Waits for it a little.
    std::optional<std::string> end() {
        if (failure_) {
            const std::string text = kLost + *failure_;
            failure_.reset();
            return text;
        }
        if (!process_) {
            std::this_thread::sleep_for(std::chrono::milliseconds(kMilliseconds));
            return std::nullopt;
        }
        if (!process_->hasEnded(kMilliseconds)) return std::nullopt;
        const std::string text = process_->isDone() ? kDone + process_->output() : kLost + process_->fault();
        process_.reset();
        return text;
    }

  private:
    std::unique_ptr<ChildProcess> process_;
    std::optional<std::string> failure_;
};

/// Rank 0's side.
class Distributor {
  public:
    Distributor(Ranks& ranks, const std::vector<Job>& jobs, const Meanwhile& meanwhile)
        : ranks_(ranks),
          jobs_(jobs),
          meanwhile_(meanwhile),
          jobOf_(static_cast<std::size_t>(ranks.count())) {}

    bool run() {
        while (ended_ < jobs_.size()) {
            if (isStopped_ || meanwhile_.isStopped()) return false;
            giveJobs();
            if (const auto message = own_.end()) take(0, *message);
            while (const auto message = ranks_.receive()) take(message->from, message->text);
        }
        return true;
    }

  private:
    void giveJobs() {
        for (std::size_t rank = 0; rank < jobOf_.size() && next_ < jobs_.size(); ++rank) {
            if (jobOf_[rank]) continue;
            jobOf_[rank] = next_;
            if (meanwhile_.begin) meanwhile_.begin(next_, static_cast<int>(rank));
            if (rank == 0) {
                own_.begin(jobs_[next_].words);
            } else {
                ranks_.send(static_cast<int>(rank), messageOf(jobs_[next_]));
            }
            ++next_;
        }
    }

    void take(int from, const std::string& message) {
        if (message.at(0) == kStopped) {
            isStopped_ = true;
            return;
        }
        std::optional<std::size_t>& job = jobOf_[static_cast<std::size_t>(from)];
        ++ended_;
        meanwhile_.end({job.value(), message[0] == kDone, message.substr(1)});
        job.reset();
    }

    Ranks& ranks_;
    const std::vector<Job>& jobs_;
    const Meanwhile& meanwhile_;
    Worker own_;
    std::vector<std::optional<std::size_t>> jobOf_;  ///< what each rank does; empty: nothing
    std::size_t next_ = 0, ended_ = 0;
    bool isStopped_ = false;
};

}  // namespace

bool handOut(Ranks& ranks, const std::vector<Job>& jobs, const Meanwhile& meanwhile) {
    return Distributor(ranks, jobs, meanwhile).run();
}

void dismiss(Ranks& ranks) {
    if (ranks.hasLeft()) return;
    for (int rank = 1; rank < ranks.count(); ++rank) ranks.send(rank, std::string(1, kDismiss));
    // Messages that dropped jobs still send must be received, or MPI may wait for it for ever. A rank's last message is kDismiss.
    for (int left = ranks.count() - 1; left > 0;) {
        const auto message = ranks.receive();
        if (message && message->text.at(0) == kDismiss) --left;
        if (!message) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ranks.leave();
}

void serve(Ranks& ranks, const std::function<bool()>& isStopped) {
    Worker worker;
    bool isStoppedTold = false;
    for (bool isDismissed = false; !isDismissed;) {
        if (const auto ended = worker.end()) ranks.send(0, *ended);
        if (!isStoppedTold && isStopped()) {
            isStoppedTold = true;
            worker.drop();
            ranks.send(0, std::string(1, kStopped));
        }
        while (const auto message = ranks.receive()) {
            if (message->text.at(0) == kJob) worker.begin(wordsIn(message->text));
            isDismissed = isDismissed || message->text.at(0) == kDismiss;
        }
    }
    worker.drop();
    ranks.send(0, std::string(1, kDismiss));
    ranks.leave();
}

}  // namespace clearway::study
