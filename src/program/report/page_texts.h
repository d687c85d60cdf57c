// The files of the report page, which the build embeds in the program.
#pragma once

namespace clearway::report {

extern const char kPageHtml[];       ///< page/page.html, a template with {{places}}
extern const char kPageViewer[];     ///< page/viewer.js, a module
extern const char kThreeModule[];    ///< three.js
extern const char kOrbitControls[];  ///< its controls, a separate module

}  // namespace clearway::report
