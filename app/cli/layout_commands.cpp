#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/cli/commands.h"
#include "app/cli/model_picture.h"
#include "app/cli/output_folder.h"
#include "app/cli/terminal.h"
#include "app/report/gnuplot.h"
#include "app/report/layouts_page.h"
#include "app/report/model_dxf.h"
#include "app/report/model_svg.h"
#include "app/report/modes_report.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "app/report/weight_joints_report.h"
#include "app/study/building_scene.h"
#include "app/study/import_outlines.h"
#include "app/study/prepare.h"
#include "app/study/quantity.h"
#include "app/study/scene_file.h"
#include "app/study/weight_joints.h"

namespace dougong::app {
namespace {

std::string printed(const structures::Parameter& p, const structures::ParameterValue& value) {
  const bool number = p.choices.empty() && !p.is_text();
  return number ? print_quantity(value.number, p.dimension) : print_value(p, value);
}

std::string range_of(const structures::Parameter& p) {
  if (p.is_text()) return "text";
  return p.choices.empty() ? printed(p, p.least) + " .. " + printed(p, p.most)
                           : fmt::format("{}", fmt::join(p.choices, ", "));
}

void print_parameters(const structures::Layout& layout, const structures::ParameterMap& values) {
  std::vector<std::array<std::string, 4>> rows{{"parameter", "value", "default", "range"}};
  std::array<std::size_t, 4> width{};
  for (const structures::Parameter& p : layout.parameters)
    rows.push_back({p.name, printed(p, values.at(p.name)), printed(p, standard_of(p)), range_of(p)});
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    fmt::print("{:<{}}  {:>{}}  {:>{}}   {:<{}}  {}\n", rows[i][0], width[0], rows[i][1], width[1],
               rows[i][2], width[2], rows[i][3], width[3],
               i == 0 ? "meaning" : layout.parameters[i - 1].meaning);
}

Scenario scenario_of(const LayoutOptions& options, const std::string& command) {
  const bool by_hand = options.name.ends_with(".toml");
  std::vector<Override> overrides{{by_hand ? "layout.file" : "layout.name", options.name, command}};
  for (const std::string& text : options.set) overrides.push_back(parse_override(text));
  return scenario_from(overrides, RecordRule::optional);
}

std::filesystem::path out_of(const LayoutOptions& options, const std::string& extension) {
  if (!options.out.empty()) return options.out;
  return std::filesystem::path(options.name).stem().string() + extension;
}

int print_findings(const structures::Building& building) {
  int errors = 0;
  for (const structures::Finding& finding : structures::check_model(building)) {
    errors += finding.severity == structures::Severity::error;
    fmt::print("{}: {}\n", to_string(finding.severity), finding.message);
  }
  return errors;
}

/// A building at rest under its weight.
struct Rest {
  engine::Model model;
  engine::State state;
  engine::SettleReport report;
};

Rest settled(const structures::Building& building) {
  engine::Model model = engine::compile(building.scene);
  engine::State state = engine::initial_state(model, building.scene);
  const engine::SettleReport report = engine::settle(model, state);
  return {std::move(model), std::move(state), report};
}

/// Of the mode that carries most of the mass; "-" without one.
std::string period_of(const Rest& rest) {
  const engine::Mode* main = nullptr;
  const std::vector<engine::Mode> modes = engine::horizontal_modes(rest.model, rest.state);
  for (const engine::Mode& mode : modes)
    if (mode.period() > 0.0 && (!main || mode.participation > main->participation)) main = &mode;
  return main ? significant(main->period(), 3) + " s" : "-";
}

LayoutEntry entry_of(const structures::Layout& layout) {
  const structures::Building building = structures::build_layout(layout.name);
  LayoutEntry entry{model_sheet(building), period_of(settled(building)), layout.counting, {}};
  for (const structures::Parameter& p : layout.parameters)
    entry.parameters.push_back({p.name, printed(p, standard_of(p)), range_of(p), p.meaning});
  return entry;
}

void refuse_page(const LayoutsOptions& options) {
  const std::filesystem::path path = options.page;
  if (path.empty()) return;
  if (path.extension() != ".html")
    throw FileError(path, "write the page", "expected a name that ends in .html");
  if (!options.force && std::filesystem::exists(path))
    throw FileError(path, "write the page", "the file exists; give --force or another --page");
}

std::string summary_line(const ModelSheet& sheet) {
  return fmt::format("{} blocks, {} bonds, {} joints, {}, {} storeys", sheet.blocks.size(),
                     sheet.bonded.size(), sheet.links.size(), mass_text(sheet.mass), sheet.storeys.size());
}

/// What bears the weight, the most used first.
void print_joints(const std::vector<WeightJoint>& joints) {
  constexpr std::size_t told = 5;
  fmt::print("greatest compression {}; the most used of {} joints:\n", greatest_compression(joints),
             joints.size());
  fmt::print("{:>8}{:>10}{:>10}{:>8}{:>14}{:>13}   {}\n", "used (%)", "of", "N (kN)", "2 e/L", "compr. (kPa)",
             "tens. (kPa)", "joint");
  for (const auto& cells : weight_rows(joints, told))
    fmt::print("{:>8}{:>10}{:>10}{:>8}{:>14}{:>13}   {}\n", cells[7], cells[8], cells[2], cells[4], cells[5],
               cells[6], cells[0]);
}

}  // namespace

int layouts_command(const LayoutsOptions& options) {
  refuse_page(options);
  std::vector<LayoutEntry> entries;
  fmt::print("{:<20}{:>7}{:>7}{:>9}{:>10}{:>13}   {}\n", "layout", "blocks", "bonds", "storeys", "mass",
             "period", "what it is");
  for (const structures::Layout& layout : structures::layouts()) {
    entries.push_back(entry_of(layout));
    const ModelSheet& sheet = entries.back().model;
    fmt::print("{:<20}{:>7}{:>7}{:>9}{:>10}{:>13}   {}\n", layout.name, sheet.blocks.size(),
               sheet.bonded.size(), sheet.storeys.size(), mass_text(sheet.mass), entries.back().period,
               layout.summary);
  }
  fmt::print(
      "\nPeriod: small vibrations after settling, every contact stuck.\n"
      "Parameters and a picture of one: dougong layout show NAME; of all: dougong layouts --page "
      "FILE.html\n");
  if (!options.page.empty()) {
    write_file(options.page, layouts_page(entries));
    fmt::print("page: {}\n", options.page);
  }
  return exit_survived;
}

int layout_show_command(const LayoutOptions& options) {
  const Scenario scenario = scenario_of(options, "layout show");
  const std::filesystem::path path = out_of(options, ".png");
  refuse_picture(path, "--out", options.force);
  const structures::Building building = building_of(scenario);
  const ModelSheet sheet = model_sheet(building);
  fmt::print("{}: {}\n", building.layout, sheet.title);
  if (scenario.layout.file.empty()) {
    const structures::Layout& layout = structures::find_layout(scenario.layout.name);
    fmt::print("{}\n\n", layout.counting);
    print_parameters(layout, scenario.layout.parameters);
  }
  fmt::print("\n{}\n", summary_line(sheet));
  print_findings(building);
  write_model_picture(sheet, path);
  fmt::print("picture: {}\n", path.string());
  return exit_survived;
}

int layout_draw_command(const LayoutOptions& options) {
  const Scenario scenario = scenario_of(options, "layout draw");
  const std::filesystem::path path = out_of(options, ".png");
  refuse_picture(path, "--out", options.force);
  write_model_picture(model_sheet(building_of(scenario)), path);
  fmt::print("picture: {}\n", path.string());
  return exit_survived;
}

int layout_check_command(const LayoutOptions& options) {
  if (!options.out.empty()) refuse_picture(options.out, "--out", options.force);
  const structures::Building building = building_of(scenario_of(options, "layout check"));
  fmt::print("{}: {}\n", building.layout, summary_line(model_sheet(building)));
  if (print_findings(building) > 0) return exit_bad_input;
  const Rest rest = settled(building);
  fmt::print("{} after {} s simulated; {} moved most, by {} mm; {} of {} bond points broken\n",
             rest.report.settled ? "settled" : "did not settle", significant(rest.report.duration, 3),
             rest.report.moved_most.empty() ? "nothing" : rest.report.moved_most,
             significant(1e3 * rest.report.greatest_movement, 3), rest.state.bonds.broken,
             rest.model.bond_points.size());
  if (!rest.report.settled) return exit_bad_input;
  fmt::print("period {}\n", period_of(rest));
  const std::vector<WeightJoint> joints =
      weight_joints(building.scene, rest.model, structures::face_loads(rest.model, rest.state));
  print_joints(joints);
  if (options.out.empty()) return exit_survived;
  const DrawnFigure drawn = draw(weight_figure(model_sheet(building), joints));
  write_file(options.out, options.out.ends_with(".svg") ? drawn.svg : drawn.png);
  fmt::print("picture: {}\n", options.out);
  return exit_survived;
}

int layout_modes_command(const LayoutOptions& options) {
  const Scenario scenario = scenario_of(options, "layout modes");
  require_gnuplot();
  const OutputFolder folder(out_of(options, "-modes"), options.force);
  const ModesResult found = modes_of(scenario, options.count);
  fmt::print("{}: {}\n", found.model.layout, summary_line(found.model));
  if (!found.settle.settled) throw ModelError("the building does not come to rest under its weight");
  fmt::print("{:>5}{:>13}{:>16}{:>18}{:>10}\n", "mode", "period (s)", "frequency (Hz)", "effective mass (%)",
             "sum (%)");
  for (const auto& row : mode_rows(found))
    fmt::print("{:>5}{:>13}{:>16}{:>18}{:>10}\n", row[0], row[1], row[2], row[3], row[4]);
  const auto files = write_modes(found, options.command, folder.path());
  fmt::print("report: {}\n", (folder.path() / files.front()).string());
  return exit_survived;
}

int layout_export_command(const LayoutOptions& options) {
  const Scenario scenario = scenario_of(options, "layout export");
  const std::filesystem::path path = out_of(options, ".toml");
  const std::string extension = path.extension().string();
  if (extension != ".toml" && extension != ".svg" && extension != ".dxf")
    throw FileError(path, "export the layout", "expected a name that ends in .toml, .svg or .dxf");
  if (!options.force && std::filesystem::exists(path))
    throw FileError(path, "export the layout", "the file exists; give --force or another --out");
  const structures::Building building = building_of(scenario);
  if (extension == ".toml") write_file(path, to_toml(description_of(building)));
  if (extension == ".svg") write_file(path, model_svg(model_sheet(building)));
  if (extension == ".dxf") write_file(path, model_dxf(model_sheet(building)));
  fmt::print("{}: {}\n", path.string(), summary_line(model_sheet(building)));
  return exit_survived;
}

int layout_import_command(const ImportOptions& options) {
  const std::filesystem::path file = options.file, path = options.out;
  const bool dxf = file.extension() == ".dxf";
  if (!dxf && file.extension() != ".csv")
    throw FileError(file, "import outlines", "expected a name that ends in .dxf or .csv");
  if (path.extension() != ".toml")
    throw FileError(path, "import outlines", "expected a name that ends in .toml");
  if (!options.force && std::filesystem::exists(path))
    throw FileError(path, "import outlines", "the file exists; give --force or another --out");
  const double unit = options.units == "m" ? 1.0 : options.units == "cm" ? 0.01 : 0.001;
  const Outlines outlines = dxf ? read_dxf_outlines(file, unit) : read_csv_outlines(file);
  const SceneDescription description = building_from(outlines, options.file, options.material);
  const structures::Building building =
      building_of(read_scene(to_toml(description), options.file), options.file);
  write_file(path, to_toml(description));
  fmt::print("{}: {}\n", path.string(), summary_line(model_sheet(building)));
  if (outlines.left_out > 0)
    fmt::print("left out: {} entities that are no closed polyline\n", outlines.left_out);
  print_findings(building);
  return exit_survived;
}

}  // namespace dougong::app
