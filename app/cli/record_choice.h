// What a person means by the name of a record: a file if there is one, else an entry of the catalogue.
#pragma once

#include <string>

#include "app/study/scenario.h"

namespace dougong::app {

/// record.file or record.name, whichever `text` is. A text that is neither, or looks like a path, is taken
/// for a file: reading it says what is wrong.
Override record_override(const std::string& text);

}  // namespace dougong::app
