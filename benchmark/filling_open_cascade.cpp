// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filling.h"

// Not BRep_Tool.hxx: Debian has a part of it in another package, with the graphics.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepOffsetAPI_MakeFilling.hxx>
#include <Geom_BezierSurface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

// Open CASCADE's filling of a hole with n sides: each is an edge of a face, whose tangent planes
// the filling is to have along the edge.

namespace bench {

namespace {

gp_Pnt to_occt(const Point_3& p) {
  return gp_Pnt(p.x(), p.y(), p.z());
}

// The neighbour beyond a ribbon: from its boundary curve, at v = 0, straight on outwards.
Handle(Geom_BezierSurface) neighbour(const Ribbon& ribbon) {
  const int columns = static_cast<int>(ribbon.degree()) + 1;
  TColgp_Array2OfPnt poles(1, columns, 1, 2);
  for (int j = 0; j < columns; ++j) {
    const Point_3 &boundary = ribbon.control_point(std::size_t(j), 0),
                  &inner = ribbon.control_point(std::size_t(j), 1);
    poles.SetValue(j + 1, 1, to_occt(boundary));
    poles.SetValue(j + 1, 2, to_occt(boundary + (boundary - inner)));
  }
  return new Geom_BezierSurface(poles);
}

// The edge of a face along its ribbon.
TopoDS_Edge edge_along(const TopoDS_Face& face, const Ribbon& ribbon) {
  const gp_Pnt middle = to_occt(ribbon.boundary_point(0.5));
  TopoDS_Edge nearest;
  double smallest = std::numeric_limits<double>::infinity();
  for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(explorer.Current());
    const BRepAdaptor_Curve curve(edge);
    const double s = (curve.FirstParameter() + curve.LastParameter()) / 2;
    const double distance = curve.Value(s).Distance(middle);
    if (distance < smallest) {
      smallest = distance;
      nearest = edge;
    }
  }
  return nearest;
}

BRepOffsetAPI_MakeFilling make_filling(bool fine) {
  if (!fine)
    return BRepOffsetAPI_MakeFilling();
  // Twice as many points on edges, another iteration, tolerances that are 10 times smaller, and as
  // many spline segments as they need.
  return BRepOffsetAPI_MakeFilling(3, 30, 3, false, 1e-6, 1e-5, 1e-3, 0.1, 8, 50);
}

TopoDS_Face fill(const Loop& loop, bool fine) {
  constexpr double face_tolerance = 1e-7;
  BRepOffsetAPI_MakeFilling filling = make_filling(fine);
  for (const Ribbon& ribbon : loop.ribbons()) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(neighbour(ribbon), face_tolerance).Face();
    filling.Add(edge_along(face, ribbon), face, GeomAbs_G1);
  }
  filling.Build();
  if (!filling.IsDone())
    throw std::runtime_error("not done");
  return TopoDS::Face(filling.Shape());
}

// Where a surface comes closest to a point of the boundary, with derivatives.
class Closest_point {
public:
  Closest_point(const TopoDS_Face& face, const Loop& loop)
      : loop_(loop), surface_(BRepAdaptor_Surface(face).Surface().Surface()) {
    // The parameters of the surface may be clockwise; the sides tell.
    double agreement = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Ribbon& ribbon = loop[i];
      const Kernel::Vector_3 wanted =
          CGAL::cross_product(ribbon.boundary_derivative(0.5), ribbon.cross_derivative(0.5));
      const Surface_jet jet = (*this)(i, 0.5);
      const auto derivative = [&](std::size_t k) {
        return Kernel::Vector_3(jet[0][k], jet[1][k], jet[2][k]);
      };
      const Kernel::Vector_3 normal = CGAL::cross_product(derivative(1), derivative(2));
      agreement += wanted * normal / std::sqrt(wanted.squared_length() * normal.squared_length());
    }
    swap_ = agreement < 0;
  }

  Surface_jet operator()(std::size_t side, double s) const {
    constexpr double tolerance = 1e-9;
    ShapeAnalysis_Surface analysis(surface_);
    const gp_Pnt2d uv = analysis.ValueOfUV(to_occt(loop_[side].boundary_point(s)), tolerance);
    gp_Pnt p;
    gp_Vec u, v, uu, vv, mixed;
    surface_->D2(uv.X(), uv.Y(), p, u, v, uu, vv, mixed);
    if (swap_) {
      std::swap(u, v);
      std::swap(uu, vv);
    }
    Surface_jet jet;
    for (int c = 0; c < 3; ++c) {
      auto& x = jet[std::size_t(c)];
      x[0] = p.Coord(c + 1);
      x[1] = u.Coord(c + 1);
      x[2] = v.Coord(c + 1);
      x[3] = uu.Coord(c + 1);
      x[4] = mixed.Coord(c + 1);
      x[5] = vv.Coord(c + 1);
    }
    return jet;
  }

private:
  const Loop& loop_;
  Handle(Geom_Surface) surface_;
  bool swap_ = false;
};

} // namespace

Filling_outcome fill_with_open_cascade(const Hole& hole, bool fine) {
  const Loop& loop = hole.model.loop;
  try {
    Filling_outcome outcome;
    const double begin = cpu_seconds();
    const TopoDS_Face face = fill(loop, fine);
    outcome.seconds = cpu_seconds() - begin;
    measure_boundary(Boundary_surface(loop, Closest_point(face, loop)), outcome);
    return outcome;
  } catch (const Standard_Failure& failure) { // which is no std::exception
    throw std::runtime_error(std::string(failure.DynamicType()->Name()) + ": " +
                             failure.GetMessageString());
  }
}

} // namespace bench
