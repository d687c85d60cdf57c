#include "program/bench/kept_runs.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "core/replace_file.h"

namespace clearway::study {

KeptRuns::KeptRuns(const std::string& folder, const Settings& settings) : folder_(folder) {
    makeFolder(folder);
    lock_.emplace(folder);
    requireSettings(settings, folder, "benchmark",
                    "the command that it was begun with, another --log, or that folder removed");
}

std::optional<std::string> KeptRuns::read(std::size_t run) const {
    const std::string file = fileOf(run);
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (in.bad()) throw std::runtime_error(file + " cannot be read");
    return text;
}

void KeptRuns::keep(std::size_t run, const std::string& text) const {
    replaceText(fileOf(run), text);
}

void KeptRuns::remove() const {
    std::error_code ignored;  // what stays is refused or used by the next benchmark
    std::filesystem::remove_all(folder_, ignored);
}

std::string KeptRuns::fileOf(std::size_t run) const {
    return folder_ + "/" + std::to_string(run) + ".json";
}

}  // namespace clearway::study
