#include "app/report/comparison_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/comparison_csv.h"
#include "app/report/comparison_events.h"
#include "app/report/comparison_figures.h"
#include "app/report/comparison_legend.h"
#include "app/report/comparison_page.h"
#include "app/report/report_output.h"
#include "app/report/safe_file.h"

namespace dougong::app {
namespace {

constexpr std::size_t told_records = 3;    // with histories, failures and film strips; the tables have all
constexpr std::size_t told_failures = 10;  // of each run
constexpr std::size_t strip_frames = 6;

/// Draws everything, and remembers what the page says of it.
class Writer {
 public:
  Writer(const Comparison& comparison, const RunLoader& load, const std::filesystem::path& folder)
      : c_(comparison), load_(load), output_(folder) {}

  std::vector<std::string> write() {
    const auto differences = differences_of(c_);
    const auto collapses = collapses_of(c_);
    output_.write("compare.csv", comparison_csv(c_));
    output_.write("differences.csv", differences_csv(c_, differences, collapses));
    for (const View view : c_.views) draw_view(view, differences);
    const ComparisonPage page{c_,      differences, collapses, pictures_, std::move(stories_),
                              layout_, command_,    version_};
    output_.write("compare.html", comparison_page(page));
    std::vector<std::string> names = output_.names();
    std::rotate(names.begin(), names.end() - 1, names.end());
    return names;
  }

 private:
  void draw_view(View view, const std::vector<Difference>& differences) {
    for (const NamedFigure& figure : difference_figure(c_, view, differences)) add(figure);
    for (std::size_t record = 0; record < std::min(c_.records.size(), told_records); ++record) {
      const std::vector<RunResult> runs = described(view, record);
      if (record == 0)
        for (const NamedFigure& figure : profile_figure(c_, view, runs)) add(figure);
      tell(view, record, runs);
    }
  }

  // By variant; without a trajectory where the view has no run of it.
  std::vector<RunResult> described(View view, std::size_t record) {
    std::vector<RunResult> runs(drawn_variants(c_));
    for (std::size_t v = 0; v < runs.size(); ++v) {
      const ComparedRun* run = c_.find(view, v, record);
      if (!run) continue;
      runs[v] = load_(*run);
      if (v == 0) note_reference(runs[v]);
      runs[v].model.layout += ", " + letter(v) + "  " + c_.variants[v].name;
    }
    return runs;
  }

  void note_reference(const RunResult& run) {
    layout_ = run.model.layout;
    command_ = run.reproducibility.command;
    version_ = fmt::format("dougong {} ({}, {})", run.reproducibility.version, run.reproducibility.git_hash,
                           run.reproducibility.compiler);
  }

  void tell(View view, std::size_t record, const std::vector<RunResult>& runs) {
    RecordStory story;
    story.view = view, story.record = record;
    const NamedFigure histories = overlaid_histories(c_, view, record, runs);
    story.histories = "figures/" + histories.name + ".svg";
    add(histories);
    const std::vector<double> times = common_moments(runs, strip_frames);
    const SceneView scene = common_view(runs, times);
    for (std::size_t v = 0; v < runs.size(); ++v) {
      if (!c_.find(view, v, record)) continue;
      story.variants.push_back(v);
      story.failures.push_back(collapse_sequence(runs[v]));
      story.failures.back().resize(std::min(story.failures.back().size(), told_failures));
      story.verdicts.push_back(runs[v].verdict.headline);
      story.strips.push_back(draw_strip(story, v, runs[v], times, scene));
    }
    stories_.push_back(std::move(story));
  }

  std::string draw_strip(const RecordStory& story, std::size_t variant, const RunResult& run,
                         const std::vector<double>& times, const SceneView& scene) {
    const std::vector<Frame> frames = frames_at(run, times);
    if (frames.empty()) return "";
    const std::string name =
        fmt::format("figures/film_strip_{}_{}{}.png", folder_name(c_.records[story.record]), letter(variant),
                    story.view == View::same_sa ? "_same_sa" : "");
    write_image(
        name, draw_film_strip(run, frames, scene), scene.scale,
        fmt::format("{} at {} moments: {}", c_.variants[variant].name, frames.size(), run.verdict.headline),
        output_, pictures_);
    return name;
  }

  void add(const NamedFigure& figure) { write_figure(figure, output_, pictures_); }

  const Comparison& c_;
  const RunLoader& load_;
  Output output_;
  std::vector<Picture> pictures_;
  std::vector<RecordStory> stories_;
  std::string layout_, command_, version_;
};

}  // namespace

std::vector<std::string> write_comparison(const Comparison& comparison, const RunLoader& load,
                                          const std::filesystem::path& folder) {
  make_directory(folder / "figures");
  return Writer(comparison, load, folder).write();
}

}  // namespace dougong::app
