// Where two shapes can touch: at most two features, each with an identity that lasts as long as the
// same corner faces the same edge.
//
// Two polygons: the edge of greatest separation is the reference, the edge of the other polygon that
// faces it most is the incident one. Clipping one against the other leaves an interval of length L;
// each end of it is a corner of one polygon against the edge of the other. So a feature is always
// "this corner, that edge", whichever polygon was the reference: its gap is a smooth function of the
// two poses, and its force has a potential.
// A circle touches an edge with its rim (a corner at the centre, rounded by the radius), or a corner or
// another circle along the line of centres. A half-plane is an edge without ends.
#pragma once

#include <array>

#include "engine/frame.h"

namespace dougong::engine {

enum class FeatureKind : std::uint8_t { corner_edge, round };

/// Corner (or centre) of `corner_body` against an edge of `edge_body` (corner_edge), or against a
/// point of it (round). Points and normals are in the frames of their bodies.
struct Feature {
  FeatureKind kind = FeatureKind::corner_edge;
  Index corner_body = 0;
  Index edge_body = 0;
  Vec2 corner;                // m, in corner_body's frame
  Vec2 edge_point;            // m, in edge_body's frame
  Vec2 edge_normal;           // -, in edge_body's frame; unused for round
  double radius = 0.0;        // m, rounding of the corner (round: sum of both radii)
  double other_radius = 0.0;  // m, round only: the edge body's share of radius
  std::uint64_t identity = 0;
  // Of two faces: the edge reaches from edge_point by edge_length along the turned normal; the corner's own
  // face reaches from the corner by facing, along or against it. 0: round, or a face without ends.
  double edge_length = 0.0, facing = 0.0;  // m
};

/// The reference edge chosen last time: kept while it is as good as the best, so that two equally deep
/// axes do not alternate.
struct ReferenceEdge {
  Index owner = 0;  // collider
  Index edge = 0;
  bool known = false;
};

struct Manifold {
  std::array<Feature, 2> features;
  Index count = 0;
  double length = 0.0;   // m, of the clipped interval; 0 for circles
  double depth_a = 0.0;  // m, from the centre of a to its own face
  double depth_b = 0.0;  // m, likewise for b
  bool at_seam = false;  // an end of the interval is no corner: the face goes on in the next piece
  ReferenceEdge reference;
};

/// Features of the pair of colliders (a, b), a < b, none if they are further apart than `margin`. `previous`
/// is the pair's last manifold: its choices are kept where the geometry is undecided.
Manifold find_manifold(const Model& model, std::span<const Frame> frames, Index a, Index b, double margin,
                       const Manifold& previous);

}  // namespace dougong::engine
