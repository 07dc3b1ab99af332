// Screening of a response by the drift limits of standards. It is no check of compliance: the model is plane
// and of rigid blocks, and one motion is no design action.
//
//   found     greatest interstorey drift ratio of any storey, of either sign, before any loss; greatest
//             residual drift ratio of a storey that stands where the limit is one of permanent drift
//   exceeded  found > limit, or a storey was lost
//
// The limits are data, one file a standard in structures/screens/, each row with its clause and with how well
// its numbers are known ("status"): 2 seen in two independent places, 1 in one, d derived from another row;
// others are not shipped. app/study/code_screens.h reads the files.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "structures/response.h"

namespace dougong::structures {

struct DriftLimit {
  std::string name;                // "IO", "elastic limit"
  double drift = 0.0;              // -
  std::optional<double> residual;  // -, of permanent drift
};

struct ScreenRow {
  std::string subject;                  // what it holds for: structure, level of shaking, category
  std::string clause;                   // with its table
  std::string status;                   // "2", "1", "d"
  std::vector<std::string> structures;  // structural types; "any" for all
  std::vector<DriftLimit> limits;       // ascending
};

struct CodeScreen {
  std::string id;        // "gb50011"
  std::string standard;  // "GB 50011-2010"
  std::string edition;
  std::string note;  // what its limits are for
  std::vector<ScreenRow> rows;
};

struct CodeCheck {
  std::string standard, clause, subject, status;
  std::string limit_name;
  std::string measure;  // "peak drift", "residual drift"
  double limit = 0.0;   // -
  double found = 0.0;   // -, without sign
  bool exceeded = false;
};

/// The structural types that rows are for: "rc frame", "masonry" ...
std::span<const std::string_view> structural_types();
/// That of the building's layout; empty where no standard's limits are for it: assemblies of dry blocks, and
/// buildings by hand.
std::string structural_type_of(const Building& building);

/// The rows for that type; none for an empty one.
std::vector<CodeCheck> screen(const CodeScreen& code, const std::string& structural_type,
                              const Response& response);

/// The files of structures/screens/, as they are part of the program.
std::span<const std::string_view> code_screen_texts();

}  // namespace dougong::structures
