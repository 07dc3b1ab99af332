// What a person means by the name of a record: a file if there is one, else an entry of the catalogue.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/cli/commands.h"
#include "app/study/scenario.h"
#include "seismic/read_record.h"

namespace dougong::app {

/// record.file or record.name, whichever `text` is. A text that is neither, or looks like a path, is taken
/// for a file: reading it says what is wrong.
Override record_override(const std::string& text);

/// What the flags of a record command choose. Throws as a scenario does.
RecordChoice record_choice(const RecordInfoOptions& options);

/// The components of the station, of one file or of several. Throws seismic::InputError.
seismic::RecordSet read_asked_record(const RecordInfoOptions& options);

/// Every channel there is, and which of them would drive the ground; none when the file does not tell.
struct AskedChannels {
  seismic::Channels channels;
  std::optional<std::size_t> chosen;
};
/// Throws seismic::InputError.
AskedChannels read_asked_channels(const RecordInfoOptions& options);

}  // namespace dougong::app
