#include "cad/solids.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <IGESControl_Writer.hxx>
#include <Precision.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

namespace clearway::testing {

namespace {

const gp_Ax2 kUpright(gp::Origin(), gp::DZ());

TopoDS_Wire circle(double radius, const gp_Ax2& axes) {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius)));
}

TopoDS_Edge spline(const std::vector<gp_Pnt>& points) {
    TColgp_Array1OfPnt array(1, static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) array.SetValue(static_cast<int>(i) + 1, points[i]);
    return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(array).Curve());
}

TopoDS_Shape loft() {
    BRepOffsetAPI_ThruSections sections(true);
    sections.AddWire(circle(10, kUpright));
    sections.AddWire(circle(4, gp_Ax2(gp_Pnt(3, 0, 15), gp::DZ())));
    sections.AddWire(circle(8, gp_Ax2(gp_Pnt(-2, 4, 30), gp_Dir(0.2, 0, 1))));
    return sections.Shape();
}

/// A ridge of triangular section that winds three times around a cylinder.
TopoDS_Shape thread() {
    const Handle(Geom_CylindricalSurface) surface = new Geom_CylindricalSurface(gp_Ax3(kUpright), 10);
    const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(2 * M_PI, 3));
    const double length = 3 * std::hypot(2 * M_PI, 3);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, surface, 0, length);
    BRepLib::BuildCurves3d(edge);
    BRepOffsetAPI_MakePipeShell sweep(BRepBuilderAPI_MakeWire(edge).Wire());
    sweep.SetMode(gp::DZ());
    sweep.Add(
        BRepBuilderAPI_MakePolygon(gp_Pnt(9.5, 0, -1), gp_Pnt(11.5, 0, 0), gp_Pnt(9.5, 0, 1), true).Wire());
    sweep.Build();
    sweep.MakeSolid();
    return sweep.Shape();
}

TopoDS_Shape pipe() {
    const TopoDS_Wire spine =
        BRepBuilderAPI_MakeWire(spline({{0, 0, 0}, {5, 0, 15}, {20, 5, 20}, {25, 20, 30}}));
    return BRepOffsetAPI_MakePipe(spine, BRepBuilderAPI_MakeFace(circle(3, kUpright))).Shape();
}

TopoDS_Shape vase() {
    const TopoDS_Edge profile = spline({{8, 0, 0}, {12, 0, 8}, {5, 0, 18}, {9, 0, 25}});
    const TopoDS_Edge rest[] = {BRepBuilderAPI_MakeEdge(gp_Pnt(9, 0, 25), gp_Pnt(0, 0, 25)),
                                BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 25), gp_Pnt(0, 0, 0)),
                                BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(8, 0, 0))};
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(profile, rest[0], rest[1], rest[2]);
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire).Face(), gp::OZ());
}

TopoDS_Shape filletedBox() {
    const TopoDS_Shape box = boxSolid(30, 20, 10);
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
        fillet.Add(2, TopoDS::Edge(edge.Current()));
    return fillet.Shape();
}

TopoDS_Shape ellipsoid() {
    gp_GTrsf stretch;
    stretch.SetValue(1, 1, 3);
    stretch.SetValue(2, 2, 0.5);
    return BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(8).Shape(), stretch);
}

Handle(TDocStd_Document) newDocument() {
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    return document;
}

void setName(const TDF_Label& label, const std::string& name) {
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
}

void writeStep(const std::string& file, const Handle(TDocStd_Document) & document) {
    STEPCAFControl_Writer writer;
    writer.SetNameMode(true);
    BOOST_REQUIRE(writer.Transfer(document));
    BOOST_REQUIRE(writer.Write(file.c_str()) == IFSelect_RetDone);
}

}  // namespace

std::vector<NamedSolid> curvedSolids() {
    return {{"sphere", BRepPrimAPI_MakeSphere(10).Shape()},
            {"torus", BRepPrimAPI_MakeTorus(20, 5).Shape()},
            {"cylinder", BRepPrimAPI_MakeCylinder(8, 30).Shape()},
            {"cone", BRepPrimAPI_MakeCone(10, 0, 25).Shape()},
            {"filleted box", filletedBox()},
            {"block with crossing holes", cutBlock()},
            {"loft of three circles", loft()},
            {"pipe along a spline", pipe()},
            {"revolved spline", vase()},
            {"ellipsoid of splines", ellipsoid()},
            {"thread", thread()}};
}

TopoDS_Shape boxSolid(double x, double y, double z) {
    return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

TopoDS_Shape cutBlock() {
    const TopoDS_Shape once = BRepAlgoAPI_Cut(
        boxSolid(30, 20, 20), BRepPrimAPI_MakeCylinder(gp_Ax2({15, 10, -1}, gp::DZ()), 6, 22).Shape());
    return BRepAlgoAPI_Cut(once, BRepPrimAPI_MakeCylinder(gp_Ax2({-1, 10, 10}, gp::DX()), 4, 32).Shape());
}

void writeStep(const std::string& file, const std::string& name, const std::vector<PlacedSolid>& placed) {
    const Handle(TDocStd_Document) document = newDocument();
    const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label assembly = tool->NewShape();
    setName(assembly, name);
    for (const PlacedSolid& one : placed) {
        TDF_Label part;
        if (!tool->FindShape(one.solid.shape, part)) part = tool->AddShape(one.solid.shape, false);
        setName(part, one.solid.name);
        tool->AddComponent(assembly, part, one.place);
    }
    tool->UpdateAssemblies();
    writeStep(file, document);
}

void writeStep(const std::string& file, const NamedSolid& solid) {
    const Handle(TDocStd_Document) document = newDocument();
    const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    setName(tool->AddShape(solid.shape, false), solid.name);
    writeStep(file, document);
}

void writeIges(const std::string& file, const NamedSolid& solid, bool asSolid) {
    IGESControl_Writer writer("MM", asSolid ? 1 : 0);
    BOOST_REQUIRE(writer.AddShape(solid.shape));
    writer.ComputeModel();
    BOOST_REQUIRE(writer.Write(file.c_str()));
}

double exactVolume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

double exactArea(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    return properties.Mass();
}

std::vector<Vector3> surfacePoints(const TopoDS_Shape& shape, int count) {
    int faces = 0;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) ++faces;
    const int n = static_cast<int>(std::ceil(std::sqrt(double(count) / faces)));
    std::vector<Vector3> points;
    for (TopExp_Explorer explorer(shape, TopAbs_FACE); explorer.More(); explorer.Next()) {
        const TopoDS_Face& face = TopoDS::Face(explorer.Current());
        double u[2], v[2];
        BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
        const BRepAdaptor_Surface surface(face);
        const BRepTopAdaptor_FClass2d within(face, Precision::PConfusion());
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n; ++j) {
                const gp_Pnt2d at(u[0] + (u[1] - u[0]) * i / n, v[0] + (v[1] - v[0]) * j / n);
                if (within.Perform(at) == TopAbs_OUT) continue;
                const gp_Pnt point = surface.Value(at.X(), at.Y());
                points.emplace_back(point.X(), point.Y(), point.Z());
            }
        }
    }
    return points;
}

}  // namespace clearway::testing
