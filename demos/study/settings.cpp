#include "demos/study/settings.h"

#include <stdexcept>

#include "program/bench/table.h"

namespace clearway::study {
namespace {

const Columns<Setting> kSettingColumns = {{"setting", &Setting::name}, {"value", &Setting::value}};

}  // namespace

void requireSettings(Settings settings, const std::string& folder, const std::string& results,
                     const std::string& expected) {
    for (auto& [name, value] : settings) {
        for (char& c : value) {
            if (c == ',' || c == '\n' || c == '\r') c = ' ';
        }
    }
    GrowingTable<Setting> kept(folder + "/settings.csv", kSettingColumns);
    if (kept.rows().empty()) {
        kept.append(settings);
        return;
    }
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const auto& [name, value] = settings[i];
        const bool isThere = i < kept.rows().size() && kept.rows()[i].name == name;
        const std::string before = isThere ? kept.rows()[i].value : "not there";
        if (before == value) continue;
        throw std::invalid_argument("the " + results + " in '" + folder + "' has " + name + " '" + before +
                                    "', not '" + value + "', expected " + expected);
    }
    if (kept.rows().size() > settings.size())
        throw std::invalid_argument("the " + results + " in '" + folder + "' has more settings, the last '" +
                                    kept.rows().back().name + "', expected " + expected);
}

}  // namespace clearway::study
