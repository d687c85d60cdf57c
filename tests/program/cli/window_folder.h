// A folder with a small problem: a plate that goes through the window of a wall, and touches it there.
#pragma once

#include <string>
#include <utility>

#include "clearway/problem.h"
#include "program/cli/run_program.h"
#include "support/window_scene.h"

namespace clearway::testing {

/// The wall with a window, as files.
struct WindowProblemFolder : TemporaryFolder {
    WindowProblemFolder() {
        saveMesh(window.partMesh, file("plate.obj"));
        saveMesh(window.wallMesh, file("wall.obj"));
        window.problem.meshes.robot = file("plate.obj");
        window.problem.meshes.world = file("wall.obj");
        window.problem.meshes.asOmplApp = false;
        rewrite();
    }
    /// Writes the problem as it is by now.
    void rewrite() const { rewrite(window.problem); }
    void rewrite(const Problem& problem, const std::string& name = "window.cfg") const {
        writeProblem(problem, file(name));
    }

    WindowScene window = windowScene();
};

/// With a path through the window.
struct WindowFolder : WindowProblemFolder {
    WindowFolder() {
        PartState through = window.problem.start;
        through.position.x() = 0;
        writePath({window.problem.start, through, window.problem.goal}, Space::kSe3, file("in.path"));
    }
};

/// Width and height of a PNG file.
inline std::pair<int, int> sizeOfPng(const std::string& png) {
    BOOST_TEST_REQUIRE(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    const auto word = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(png[i]);
        return value;
    };
    return {word(16), word(20)};
}

}  // namespace clearway::testing
