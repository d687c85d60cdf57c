// The settings that the results in a folder were begun with, kept with them: results of different settings are never mixed.
#pragma once

#include <string>
#include <vector>

namespace clearway::study {

struct Setting {
    std::string name, value;
};
using Settings = std::vector<Setting>;

/// Keeps the settings in FOLDER/settings.csv, where none are kept. Commas in values become spaces. Otherwise compares them
/// with the kept ones and throws std::invalid_argument, which names the setting, both values, `results` ("study") and what was
/// expected.
void requireSettings(Settings settings, const std::string& folder, const std::string& results,
                     const std::string& expected);

}  // namespace clearway::study
