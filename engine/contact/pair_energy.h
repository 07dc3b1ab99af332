// What the springs of a pair's contact points store, and how it is kept when other features, or a contact
// instead of a bond, take over what there was.
#pragma once

#include <span>

#include "engine/contact/contact_pair.h"

namespace dougong::engine {

/// A law of so many times the stiffness, with as much damping over critical.
PointStiffness hardened(PointStiffness law, double factor);

/// Of the springs along the normals of a pair's two points (J).
double stored_energy(const ContactPoints& points, std::size_t first, std::span<const Frame> frames);

/// A history of a closed point whose friction spring holds that slip (m).
PointHistory history_with_slip(const ContactPoints& points, std::size_t i, std::span<const Frame> frames,
                               const PointHistory& kept, double slip);

/// What a pair that touches has stored (J) stays when other features take its contact over: a corner in a
/// face bears on as it did, though now another of its own faces turns to it.
void keep_energy(ContactPoints& points, std::span<const Frame> frames, ContactPair& pair, double stored);

/// Gives the contacts of two bodies whose face was joined until now what it had stored (J): closed where they
/// overlap, with relaxed friction springs. Returns what they took of it.
double hand_over(ContactPoints& points, std::span<const Frame> frames, std::span<ContactPair* const> pairs,
                 double energy);

}  // namespace dougong::engine
