// C07: the examples that Newmark's method is taught by, integrated until nothing changes.
#include <fmt/format.h>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/newmark_example.h"

namespace dougong::comparisons {
namespace {

struct Row {
  const char* what;
  const std::vector<double>* published;
  double yield;
};

double worst(const std::vector<double>& found, const std::vector<double>& published) {
  double most = 0.0;
  for (std::size_t k = 0; k < published.size(); ++k)
    most = std::max(most, std::abs(found[k + 1] - published[k]));
  return most;
}

}  // namespace

Comparison newmark_tables() {
  Comparison comparison;
  comparison.table =
      "| system | integrator | u at 0.1 ... 1.0 s (in) | worst of ten (in) |\n|---|---|---|---|\n";
  const double endless = std::numeric_limits<double>::infinity();
  const Row rows[] = {{"linear", &scenes::newmark_linear, endless},
                      {"elastoplastic", &scenes::newmark_plastic, 0.75}};
  comparison.figure.script =
      look + "set xlabel 'time (s)'\nset ylabel 'displacement (in)'\nplot 0 lc rgb '#888888' notitle";
  for (std::size_t i = 0; i < 2; ++i) {
    const scenes::NewmarkExample example{rows[i].yield};
    comparison.table += fmt::format("| {} | converged, published | {:.4f} | |\n", rows[i].what,
                                    fmt::join(*rows[i].published, " "));
    for (const char* integrator : {"velocity-verlet", "leapfrog", "rk4"}) {
      auto u = example.displacements(integrator, 0.2, 10);
      const double off = worst(u, *rows[i].published);
      u.erase(u.begin());
      comparison.table += fmt::format("| | {} | {:.4f} | {:.5f} |\n", integrator, fmt::join(u, " "), off);
    }
    const auto fine = example.displacements("velocity-verlet", 0.2, 200);
    std::vector<double> times, marks;
    for (std::size_t k = 0; k < fine.size(); ++k) times.push_back(static_cast<double>(k) / 200.0);
    for (std::size_t k = 0; k < 10; ++k) marks.push_back(0.1 * static_cast<double>(k + 1));
    comparison.figure.data[fmt::format("ours{}", i)] = columns({times, fine});
    comparison.figure.data[fmt::format("published{}", i)] = columns({marks, *rows[i].published});
    comparison.figure.script += fmt::format(
        ", 'ours{0}' with lines lw 1.4 lc rgb '{1}' title '{2}', 'published{0}' with points pt 6 lc rgb "
        "'{1}' title 'converged, published'",
        i, app::to_hex(app::category(i)), rows[i].what);
  }
  comparison.figure.script += "\n";
  return comparison;
}

}  // namespace dougong::comparisons
