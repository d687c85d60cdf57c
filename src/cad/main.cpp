// The program clearway-cad: makes meshes of STEP and IGES files with OpenCASCADE, for clearway, which knows nothing of it.
#include <fmt/format.h>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "cad/cad_file.h"
#include "clearway/version.h"
#include "core/replace_file.h"
#include "core/text.h"
#include "mesh/clean.h"
#include "mesh/components.h"
#include "mesh/topology.h"
#include "program/options/command_line.h"
#include "program/options/load_guard.h"
#include "program/options/print.h"

namespace clearway::cad {
namespace {

/// Reads and tessellates behind the guard: OpenCASCADE writes to the standard streams, and crashes on some damaged files.
Mesh guardedMesh(CadFile& cad, const std::string& file, std::optional<double> deflection) {
    const cli::LoadGuard guard(file, 3600, {"clearway-cad", "file", "OpenCASCADE"});
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    try {
        cad = readCadFile(file);
        return tessellate(cad, deflection, std::filesystem::path(file).stem().string());
    } catch (const Standard_Failure& failure) {
        throw std::runtime_error(quote(file) + ": OpenCASCADE fails: " + failure.GetMessageString());
    }
}

void tell(const CadFile& file, const Mesh& mesh) {
    std::size_t closed = 0;
    double least = mesh.components[0].deflection;
    for (std::size_t i = 0; i < mesh.components.size(); ++i) {
        closed += checkEdges(clean(meshOfComponents(mesh, {i})).triangles).isClosed();
        least = std::min(least, mesh.components[i].deflection);
    }
    const double most = deflectionOf(mesh);
    cli::printRow("parts", fmt::format("{}, {} of them closed", mesh.components.size(), closed));
    if (file.withoutFaces > 0)
        cli::printRow("left out",
                      cli::counted(file.withoutFaces, "part") + " without a surface, of points and curves");
    cli::printRow("triangles", std::to_string(mesh.triangles.size()));
    cli::printRow("deflection", (least < most ? cli::readable(least) + " to " : "") + cli::readable(most) +
                                    " mm, aimed at by OpenCASCADE, not proved");
    cli::printRow("unit", "mm" + (file.unit.empty() ? "" : "; the file's own is " + quote(file.unit)));
}

int run(const cli::Arguments& words) {
    if (!words.empty() && words[0] == "--version")
        return std::cout << "clearway-cad " CLEARWAY_VERSION "\n", cli::kDone;
    std::string file, out;
    std::optional<double> deflection;
    cli::CommandLine line(
        "clearway-cad FILE.step --out FILE.3mf [--deflection LENGTH]",
        "Makes triangles of the surfaces in a STEP or IGES file, for clearway. The 3MF file is in "
        "millimetres and has a\n"
        "component for each part in its place. OpenCASCADE aims at the deflection; it does not prove it.");
    line.argument("FILE.step", cli::to(file));
    line.option("--out FILE", "the 3MF file", cli::to(out), cli::CommandLine::Count::kRequired);
    line.option(
        "--deflection LENGTH",
        "how far triangles may be from the surface, in millimetres (a thousandth of each part's diagonal)",
        cli::positive(deflection));
    if (!line.parse(words)) return cli::kDone;
    if (!std::filesystem::is_regular_file(file))
        throw std::invalid_argument(quote(file) + (std::filesystem::is_directory(file)
                                                       ? " is a folder, expected a file"
                                                       : ": there is no such file"));
    if (!boost::iends_with(out, ".3mf"))
        throw std::invalid_argument("--out is " + quote(out) + ", expected a name that ends in .3mf");
    requireReplaceable(out);
    CadFile cad;
    const Mesh mesh = guardedMesh(cad, file, deflection);
    saveMesh(mesh, out);
    tell(cad, mesh);
    cli::printRow("mesh", out);
    cli::requirePrinted();
    return cli::kDone;
}

}  // namespace
}  // namespace clearway::cad

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return clearway::cad::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cout.flush();
        std::cerr << "clearway-cad: " + clearway::cli::oneLine(error.what()) + "\n";
        return clearway::cli::kBadInput;
    }
}
