// Shapes of bodies and terrain, in their own frame, with exact mass properties.
//
// A polygon is convex, anticlockwise, without repeated or collinear vertices, and its centroid is the
// origin of its frame. Mass properties are integrals over the area (Green's theorem), computed about
// a local origin so that a far-away polygon loses no digits.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/vec2.h"

namespace dougong::engine {

struct Circle {
  double radius = 0.0;  // m
};

class ConvexPolygon {
 public:
  const std::vector<Vec2>& vertices() const { return vertices_; }
  std::size_t size() const { return vertices_.size(); }
  Vec2 vertex(std::size_t i) const { return vertices_[i % vertices_.size()]; }
  /// Outward unit normal of the edge from vertex i to vertex i + 1.
  Vec2 normal(std::size_t i) const { return normals_[i]; }
  /// An edge inside a compound: it bounds the polygon, but nothing touches it.
  bool is_inner(std::size_t i) const { return !inner_.empty() && inner_[i]; }

  bool has_inner_edges() const { return !inner_.empty(); }

  /// The same polygon turned, then moved, in another frame: its centroid is no longer the origin.
  ConvexPolygon moved(Vec2 position, double angle) const;
  ConvexPolygon with_inner_edges(std::vector<bool> inner) const;

 private:
  friend struct PlacedPolygon make_polygon(std::span<const Vec2> points);
  std::vector<Vec2> vertices_;
  std::vector<Vec2> normals_;
  std::vector<bool> inner_;  // empty: none
};

/// All that lies below y = 0 of its frame. Terrain only.
struct HalfPlane {};

struct Part;
/// Circles and polygons that move as one; the centroid of them all is the origin of its frame. Edges that
/// lie on an edge of another part are inner edges: nothing touches them.
struct Compound {
  std::vector<Part> parts;
};

using Shape = std::variant<Circle, ConvexPolygon, HalfPlane, Compound>;

struct Part {
  std::variant<Circle, ConvexPolygon> shape;
  Vec2 position;       // m, of the part's centroid in the compound's frame
  double angle = 0.0;  // rad
};

/// A compound moved to its centroid frame, and where that centroid was.
struct PlacedCompound {
  Compound compound;
  Vec2 centroid;
};

/// Throws std::invalid_argument with the reason for no parts, or parts that overlap (their mass would count
/// twice).
PlacedCompound make_compound(std::vector<Part> parts);
/// Ground under a line of points from left to right, `depth` thick: one quadrilateral under each segment.
/// Throws std::invalid_argument for fewer than two points, or points that do not go to the right.
PlacedCompound make_polyline_ground(std::span<const Vec2> points, double depth);

/// A polygon moved to its centroid frame, and where that centroid was.
struct PlacedPolygon {
  ConvexPolygon polygon;
  Vec2 centroid;
};

/// Takes points in either sense of rotation, drops repeated and collinear ones.
/// Throws std::invalid_argument with the reason for fewer than three corners, zero area, non-finite,
/// non-convex or self-crossing outlines.
PlacedPolygon make_polygon(std::span<const Vec2> points);
/// Rectangle of the given full width (x) and height (y). Throws std::invalid_argument unless both > 0.
ConvexPolygon make_rectangle(double width, double height);
/// Throws std::invalid_argument unless radius > 0.
Circle make_circle(double radius);

struct AreaProperties {
  double area = 0.0;           // m2
  double second_moment = 0.0;  // m4, polar, about the centroid
};
struct MassProperties {
  double mass = 0.0;     // kg
  double inertia = 0.0;  // kg m2, about the centroid
};

AreaProperties area_properties(const Shape& shape);
MassProperties mass_properties(const Shape& shape, double density, double thickness);
/// Radius of the smallest circle about the centroid that holds the shape (m).
double bounding_radius(const Shape& shape);
/// Smallest distance between two parallel supporting lines: what an overlap is compared with (m).
double minimum_width(const Shape& shape);

}  // namespace dougong::engine
