// Where and when a study runs.
#pragma once

#include <string>

namespace clearway::study {

/// "unknown" when the system does not tell.
std::string processorName();

/// Local date and time, as OMPL's logs have them: 2026-01-31T12:00:00.
std::string timeNow();

}  // namespace clearway::study
