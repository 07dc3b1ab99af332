// Small prepared runs for the tests: one drum or one storey, a second of motion.
#pragma once

#include "app/study/execute.h"

namespace dougong::app::testing {

/// A scenario of the shipped record, from "key=value" words of the command line.
inline Scenario scenario_with(const std::vector<std::string>& words) {
  std::vector<Override> overrides{{"record.name", "wenchuan", "test"}};
  for (const std::string& word : words) overrides.push_back(parse_override(word));
  return scenario_from(overrides);
}

inline Preparation prepared(const std::vector<std::string>& words) {
  return prepare(scenario_with(words), DOUGONG_RECORDS_DIRECTORY);
}

/// A single stone drum, rocked for a second by the start of the record.
inline Preparation prepared_drum(const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"layout=column", "drums=1", "duration=1 s", "pga=0.5 g"};
  words.insert(words.end(), more.begin(), more.end());
  return prepared(words);
}

}  // namespace dougong::app::testing
