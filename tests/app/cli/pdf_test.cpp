// The report as PDF: by whatever prints pages here, and where nothing does.
#include "app/report/pdf.h"
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Pdf : public ProgramTest {
 protected:
  /// The run of whose results the pages are printed.
  void SetUp() override { ASSERT_EQ(run(short_run("out"), with_quick_plots()).exit_code, 0); }
};

TEST_F(Pdf, IsPrintedByAProgramThatIsInstalled) {
  if (page_printer().empty()) GTEST_SKIP() << "neither chromium nor weasyprint is installed here";
  const Ran ran = run({"report", "out", "--pdf"}, with_quick_plots());
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_THAT(ran.out, HasSubstr("PDF          out/report.pdf"));
  EXPECT_THAT(read("out/report.pdf"), StartsWith("%PDF-"));
}

TEST_F(Pdf, IsOfThePage) {
  with_quick_plots();
  const Surroundings around =
      with_only("chromium", "for page; do :; done; read first < \"$page\"; echo \"$first\" > page.pdf\n");
  EXPECT_EQ(run({"report", "out", "--pdf"}, around).exit_code, 0);
  EXPECT_EQ(read("out/report.pdf"), "<!doctype html>\n");
}

TEST_F(Pdf, ThatFailsLeavesThePageAndSaysWhy) {
  with_quick_plots();
  const Ran failed = run({"report", "out", "--pdf"}, with_only("chromium", "echo no display; exit 1\n"));
  EXPECT_EQ(failed.exit_code, 0);
  EXPECT_THAT(failed.out, HasSubstr("chromium could not print it: no display"));
  EXPECT_FALSE(exists("out/report.pdf"));
  EXPECT_TRUE(exists("out/report.html"));
}

TEST_F(Pdf, WithoutAPrinterSaysWhatIsMissing) {
  with_quick_plots();
  const Ran none = run({"report", "out", "--pdf"}, with_only("chromium", ""));
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_THAT(none.out, HasSubstr("neither chromium nor weasyprint is installed"));
}

// It would be of another run.
TEST_F(Pdf, DoesNotStandBesideLaterResults) {
  write("out/report.pdf", "of the run before");
  EXPECT_EQ(run(short_run("out", {"--force"}), with_quick_plots()).exit_code, 0);
  EXPECT_FALSE(exists("out/report.pdf"));
}

}  // namespace
}  // namespace dougong::app
