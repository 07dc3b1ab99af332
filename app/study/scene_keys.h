// The keys of a scene file, one table for each kind of thing: reading, writing, the suggestions for mistyped
// keys and docs/scene.md all follow them. The defaults are those of the structs in scene_description.h.
#pragma once

#include <span>

#include "app/study/key.h"
#include "app/study/scene_description.h"

namespace dougong::app {

/// The words that `shape` may be, for a body, a terrain and a part of a compound.
struct ShapeWord {
  std::string word;
  bool of_body, of_terrain, of_part;
  std::vector<std::string> needs;   // keys that must be given
  std::vector<std::string> allows;  // keys that may be given too
};
std::span<const ShapeWord> shape_words();
const ShapeWord* find_shape_word(const std::string& word);

/// The keys of one kind of thing, in the order in which they are written.
template <class Owner>
std::span<const Key<Owner>> keys_of();
template <>
std::span<const Key<SceneHead>> keys_of<SceneHead>();
template <>
std::span<const Key<MaterialChoice>> keys_of<MaterialChoice>();
template <>
std::span<const Key<MaterialPairChoice>> keys_of<MaterialPairChoice>();
template <>
std::span<const Key<BodyChoice>> keys_of<BodyChoice>();
template <>
std::span<const Key<PartChoice>> keys_of<PartChoice>();
template <>
std::span<const Key<TerrainChoice>> keys_of<TerrainChoice>();
template <>
std::span<const Key<MotionChoice>> keys_of<MotionChoice>();
template <>
std::span<const Key<HarmonicChoice>> keys_of<HarmonicChoice>();
template <>
std::span<const Key<JointChoice>> keys_of<JointChoice>();
template <>
std::span<const Key<BondChoice>> keys_of<BondChoice>();
template <>
std::span<const Key<StoreyChoice>> keys_of<StoreyChoice>();
template <>
std::span<const Key<engine::Fields>> keys_of<engine::Fields>();
template <>
std::span<const Key<engine::ContactOptions>> keys_of<engine::ContactOptions>();
template <>
std::span<const Key<SceneSolve>> keys_of<SceneSolve>();
template <>
std::span<const Key<SceneOutput>> keys_of<SceneOutput>();

/// A key as the document lists it.
struct DocumentedKey {
  std::string section;  // "[[body]]"
  std::string name, kind, standard, range, meaning;
};
std::vector<DocumentedKey> documented_scene_keys();

}  // namespace dougong::app
