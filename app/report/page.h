// report.html: one page that opens offline and prints on A4. The first screen says what stood where,
// what shook it, what happened and how sure that is; the rest follows in the order a reviewer reads.
#pragma once

#include <string>
#include <vector>

#include "app/report/html.h"
#include "app/study/run_result.h"

namespace dougong::app {

/// `pictures` by their names ("figures/drift_profile.svg"); one that is missing is left out of the page.
std::string report_page(const RunResult& run, const std::vector<Picture>& pictures);

// Its parts, in order.
Html page_answer(const RunResult& run, const std::vector<Picture>& pictures);
Html page_model(const RunResult& run, const std::vector<Picture>& pictures);
Html page_motion(const RunResult& run, const std::vector<Picture>& pictures);
Html page_response(const RunResult& run, const std::vector<Picture>& pictures);
/// Limits of standards: screening.
Html page_screening(const RunResult& run);
Html page_damage(const RunResult& run, const std::vector<Picture>& pictures);
Html page_collapse(const RunResult& run, const std::vector<Picture>& pictures);
Html page_spread(const RunResult& run, const std::vector<Picture>& pictures);
Html page_energy(const RunResult& run, const std::vector<Picture>& pictures);
Html page_film(const RunResult& run, const std::vector<Picture>& pictures);
Html page_numerics(const RunResult& run, const std::vector<Picture>& pictures);
Html page_limits(const RunResult& run);
Html page_reproducibility(const RunResult& run);

/// "0.1 % of the input until ..., 0.2 % of the input in all, 0.01 % of the energy turned over".
std::string energy_error_words(const RunResult& run);

/// The figure of that name, or nothing.
Html figure_named(const std::vector<Picture>& pictures, std::string_view name, std::string_view caption,
                  const std::vector<std::string>& links = {});

}  // namespace dougong::app
