// The film of a building's run that a command was asked for.
#pragma once

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "app/study/run_result.h"

namespace dougong::app {

/// Before a long run: throws FileError for a path that does not end in .mp4, that something stands at
/// already, unless forced, or whose folder does not exist.
void require_film_path(const FilmChoice& film, bool force);

/// The film, or its frames in a folder beside it where ffmpeg is not installed; says which. What keeps it
/// from being made is said too: the results stand.
void film_aloud(const RunResult& run, const FilmChoice& film, const Terminal& terminal);

}  // namespace dougong::app
