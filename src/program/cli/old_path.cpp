#include "program/cli/old_path.h"

#include <exception>
#include <optional>
#include <utility>

#include "core/replace_file.h"
#include "program/options/print.h"

namespace clearway::cli {

void OldPath::leave() {
    if (file_.empty()) return;
    try {
        const std::optional<std::string> name = setAside(std::exchange(file_, {}));
        if (name) printRow("old path", "moved to " + *name + ", because there is no new one");
    } catch (const std::exception& error) {
        printWarnings({std::string("the old path is still there: ") + error.what()});
    }
}

}  // namespace clearway::cli
