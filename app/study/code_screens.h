// The limits of standards: read from the program's own files (structures/screens/), chosen by a scenario.
//
// A file has id, standard, edition, note and a list [[row]] of subject, clause, status, structures, limits
// (names), drift (as "1/550", ascending) and, where there is one, residual, with "" for a limit without.
#pragma once

#include "app/study/run_result.h"
#include "app/study/scenario.h"
#include "structures/code_screen.h"

namespace dougong::app {

/// Throws std::invalid_argument naming the file, the row and what is wrong.
structures::CodeScreen read_code_screen(const std::string& text);
/// Of the program, in the order of their ids.
const std::vector<structures::CodeScreen>& code_screens();

/// "gb50011, fema356" as screens; "automatic": all, "none": none. Throws std::invalid_argument for an id that
/// is none, naming the nearest.
std::vector<structures::CodeScreen> chosen_screens(const std::string& codes);

/// By the scenario's choice, or by the building's structural type. Without checks where no limit is for it
/// or the numbers failed, and the note says why.
ScreeningSheet screening_of(const ScreeningChoice& choice, const structures::Building& building,
                            const structures::Response& response, const structures::Verdict& verdict);

}  // namespace dougong::app
