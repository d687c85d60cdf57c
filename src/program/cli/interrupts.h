// Ctrl-C ends the work at hand, not the program: what is done is still written.
#pragma once

namespace clearway::cli {

/// From now on the first interrupt (SIGINT, SIGTERM) is only noted; the second one has its usual effect.
void heedInterrupts();

bool isInterrupted();

}  // namespace clearway::cli
