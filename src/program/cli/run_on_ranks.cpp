#include "program/cli/run_on_ranks.h"

#include <exception>
#include <iostream>

#include "program/options/command_line.h"
#include "program/options/facts.h"
#include "program/options/print.h"

namespace clearway::cli {

int runOnRanks(const std::function<int(study::Ranks*)>& run) {
    if (!study::isRank()) return run(nullptr);
    study::Ranks ranks;
    int code = kDone;
    if (ranks.rank() == 0) {
        code = run(&ranks);
    } else {
        static Sink& sink = *new Sink;  // streams are flushed after statics are gone
        std::cout.rdbuf(&sink);
        std::cerr.rdbuf(&sink);
        heedInterrupts();
        try {
            run(&ranks);
        } catch (const std::exception& error) {
            ranks.fail(error.what());
        }
        dropFacts();
    }
    ranks.leave();
    return code;
}

}  // namespace clearway::cli
