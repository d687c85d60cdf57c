// The files the report page is made of, as the build put them into the program.
#pragma once

namespace clearway::report {

extern const char kPageHtml[];       ///< page/page.html, with {{places}} to fill
extern const char kPageViewer[];     ///< page/viewer.js, a module
extern const char kThreeModule[];    ///< three.js
extern const char kOrbitControls[];  ///< its controls, a module of its own

}  // namespace clearway::report
