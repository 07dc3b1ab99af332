// What one entry of a file or of the command line says, once it is known which key it belongs to. A value
// of the wrong kind throws QuantityError: what was expected, what was found.
#pragma once

#include <string>

#include "app/study/entries.h"
#include "app/study/key.h"

namespace dougong::app {

/// The number in SI. A dimension with units takes text with one, "0.4 g"; on the command line the text
/// may also be a bare count or ratio.
double number_of(const Entry& entry, Dimension dimension);
/// Reads the value into its place.
void set_slot(const KeyFacts& key, const Entry& entry, const Slot& slot);
template <class Owner>
void set_key(const Key<Owner>& key, const Entry& entry, Owner& owner) {
  set_slot(key, entry, key.slot(owner));
}
/// False for an entry that says nothing: empty or "none".
bool is_set(const Entry& entry);

}  // namespace dougong::app
