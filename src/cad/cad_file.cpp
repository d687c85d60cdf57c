#include "cad/cad_file.h"

#include <fmt/format.h>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESToBRep.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepGeom_GeometricRepresentationItem.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "core/number.h"
#include "core/text.h"

namespace clearway::cad {
namespace {

constexpr double kSewn = 1e-3;  ///< mm; by as much the edges of loose faces may differ
constexpr double kFarthest =
    1e9;  ///< mm from the origin; beyond it OpenCASCADE's tolerance, 1e-7 mm, is less than the last digit of a double
constexpr std::int64_t kInfiniteExponent = 100;  ///< OpenCASCADE takes 1e100 for infinite

[[noreturn]] void refuse(const std::string& file, const std::string& reason) {
    throw std::runtime_error(quote(file) + ": " + reason);
}

/// Refuses numbers that OpenCASCADE takes for infinite, on some of which it works for hours.
void requireFiniteNumbers(const std::string& file, bool isIges) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    constexpr const char* kDigits = "0123456789";
    bool isInQuotes = false;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (!isIges && !isInQuotes && text.compare(i, 2, "/*") == 0) {
            i = std::min(text.find("*/", i + 2), text.size());  // apostrophes of a comment open no name
            continue;
        }
        if (text[i] == '\'' && !isIges) isInQuotes = !isInQuotes;
        if (isInQuotes || std::string_view("EeDd").find(text[i]) == std::string_view::npos) continue;
        const std::size_t begin = text.find_last_not_of(std::string(kDigits) + ".", i - 1) + 1,
                          exponent = i + 1 + (text.compare(i + 1, 1, "+") == 0),
                          end = std::min(text.find_first_not_of(kDigits, exponent), text.size());
        if (text.find('.', begin) >= i || end <= exponent) continue;
        if (parseInteger(text.substr(exponent, end - exponent)).value_or(kInfiniteExponent) <
            kInfiniteExponent)
            continue;
        refuse(file, fmt::format("it holds the number {}, expected numbers below 1e{}",
                                 quote(text.substr(begin, end - begin)), kInfiniteExponent));
    }
}

/// Refuses parts whose triangles OpenCASCADE cannot make.
void requireNear(const CadFile& cad, const std::string& file) {
    for (const CadPart& part : cad.parts) {
        Bnd_Box box;
        BRepBndLib::Add(part.shape, box, false);
        if (box.IsVoid()) continue;
        const Bnd_Box placed = box.Transformed(part.X_filePart);
        double farthest = 0;
        for (const gp_Pnt& corner : {placed.CornerMin(), placed.CornerMax()}) {
            for (int axis = 1; axis <= 3; ++axis) farthest = std::max(farthest, std::abs(corner.Coord(axis)));
        }
        if (!(farthest <= kFarthest))
            refuse(file, fmt::format("{}has coordinates up to {} mm, expected at most {} mm",
                                     part.name.empty() ? "it " : "part " + quote(part.name) + " ",
                                     roundedNumber(farthest), roundedNumber(kFarthest)));
    }
}

/// The label's name, on one line; empty without one.
std::string nameOf(const TDF_Label& label) {
    Handle(TDataStd_Name) attribute;
    if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) return "";
    std::string name = TCollection_AsciiString(attribute->Get()).ToCString();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return std::string(trimmed(name));
}

/// Whether a program made the name of an instance up: "=>[0:1:1:2]", "NAUO12" or "3".
bool isMadeUp(const std::string& name) {
    const std::string rest = name.substr(boost::istarts_with(name, "nauo") ? 4 : 0);
    return boost::starts_with(name, "=>") || rest.find_first_not_of("0123456789") == std::string::npos;
}

/// Adds the parts below a label. outer: names the assemblies around it, but for the whole.
void addParts(CadFile& file, const TDF_Label& label, const TopLoc_Location& X_fileOuter,
              const std::string& outer) {
    TDF_Label definition = label;
    std::string name = nameOf(label);
    const bool isPlaced = XCAFDoc_ShapeTool::GetReferredShape(label, definition);
    if (isPlaced && isMadeUp(name)) name = nameOf(definition);
    const TopLoc_Location place =
        isPlaced ? X_fileOuter * XCAFDoc_ShapeTool::GetLocation(label) : X_fileOuter;
    if (XCAFDoc_ShapeTool::IsAssembly(definition)) {
        TDF_LabelSequence children;
        XCAFDoc_ShapeTool::GetComponents(definition, children);
        const std::string inner = isPlaced && !name.empty() ? outer + name + "/" : outer;
        for (const TDF_Label& child : children) addParts(file, child, place, inner);
        return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(definition);
    const bool hasFace = TopExp_Explorer(shape, TopAbs_FACE).More();
    file.withoutFaces += !hasFace;
    if (hasFace) file.parts.push_back({name.empty() ? "" : outer + name, shape, place.Transformation()});
}

/// Refuses a file that is not whole, or of which an element was not translated.
template <class Reader>
void requireWhole(Reader& reader, const std::string& file) {
    const Handle(Interface_InterfaceModel) model = reader.WS()->Model();
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    for (int i = 1; i <= model->GlobalCheck()->NbFails(); ++i) {
        const std::string fault = model->GlobalCheck()->CFail(i);
        if (fault.find(" for file_") == fault.npos)  // which is the header: who wrote the file, and when
            refuse(file, "it is damaged: " + fault);
    }
    int damaged = 0, lost = 0;
    const auto isLost = [&](const auto& e) { return TransferBRep::ShapeResult(process, e).IsNull(); };
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const Handle(Standard_Transient) entity = model->Value(i);
        damaged += model->IsErrorEntity(i) &&
                   (entity->IsKind(STANDARD_TYPE(StepShape_TopologicalRepresentationItem)) ||
                    entity->IsKind(STANDARD_TYPE(StepGeom_GeometricRepresentationItem)));
        lost += entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface)) && isLost(entity);
    }
    for (int i = 1; i <= reader.NbRootsForTransfer(); ++i) {
        const auto iges = Handle(IGESData_IGESEntity)::DownCast(reader.RootForTransfer(i));
        lost += !iges.IsNull() && (IGESToBRep::IsTopoSurface(iges) || IGESToBRep::IsBRepEntity(iges)) &&
                isLost(iges);
    }
    if (damaged + lost > 0)
        refuse(file, fmt::format("{} of its shapes are damaged or lost, expected none", damaged + lost));
}

/// Reads the file into a document.
template <class Reader>
void readInto(Handle(TDocStd_Document) & document, Reader& reader, const std::string& file) {
    reader.SetNameMode(true);
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
        refuse(file, "it is damaged, or of another format");
    if (reader.NbRootsForTransfer() == 0 || !reader.Transfer(document)) refuse(file, "it holds no shape");
}

/// One part of all parts that have no solid: programs without solids write each face by itself.
void sewLooseFaces(CadFile& file) {
    const auto isSolid = [](const CadPart& part) { return TopExp_Explorer(part.shape, TopAbs_SOLID).More(); };
    const auto loose = std::stable_partition(file.parts.begin(), file.parts.end(), isSolid);
    if (loose == file.parts.end()) return;
    const std::string name = file.parts.end() - loose == 1 ? loose->name : "";
    BRepBuilderAPI_Sewing sewing(kSewn);
    for (auto part = loose; part != file.parts.end(); ++part)
        sewing.Add(part->shape.Moved(TopLoc_Location(part->X_filePart)));
    sewing.Perform();
    const TopoDS_Shape sewn = sewing.SewedShape();
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (TopExp_Explorer shells(sewn, TopAbs_SHELL); shells.More(); shells.Next()) {
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, shells.Current());
        BRepLib::OrientClosedSolid(solid);  // an open one stays as it is
        builder.Add(compound, solid);
    }
    TopExp_Explorer faces(sewn, TopAbs_FACE, TopAbs_SHELL);
    for (; sewn.ShapeType() != TopAbs_SHELL && faces.More(); faces.Next())
        builder.Add(compound, faces.Current());
    file.parts.erase(loose, file.parts.end());
    file.parts.push_back({name, compound, gp_Trsf()});
}

}  // namespace

CadFile readCadFile(const std::string& file) {
    const bool isIges = boost::iends_with(file, ".iges") || boost::iends_with(file, ".igs");
    if (!isIges && !boost::iends_with(file, ".step") && !boost::iends_with(file, ".stp"))
        refuse(file, "expected a name that ends in .step, .stp, .iges or .igs");
    requireFiniteNumbers(file, isIges);
    CadFile result;
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    if (isIges) {
        IGESCAFControl_Reader reader;
        readInto(document, reader, file);
        requireWhole(reader, file);
    } else {
        STEPCAFControl_Reader reader;
        readInto(document, reader, file);
        requireWhole(reader.ChangeReader(), file);
        TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
        reader.ChangeReader().FileUnits(lengths, angles, solidAngles);
        if (!lengths.IsEmpty()) result.unit = lengths.First().ToCString();
    }
    TDF_LabelSequence roots;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
    for (const TDF_Label& root : roots) addParts(result, root, {}, "");
    requireNear(result, file);
    if (isIges) sewLooseFaces(result);
    if (result.parts.empty()) refuse(file, "it holds no face, expected a part with a surface");
    return result;
}

}  // namespace clearway::cad
