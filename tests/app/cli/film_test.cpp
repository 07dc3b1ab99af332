// The film of a building's run: with ffmpeg, without, and again from the results.
#include "app/report/film.h"
#include "app/report/subprocess.h"
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using testing::HasSubstr;

// An "ffmpeg" that writes how many frames it was given.
constexpr const char* counts = "n=0; for f in frame*.png; do n=$((n+1)); done; echo $n > film.mp4\n";

class Film : public ProgramTest {
 protected:
  Surroundings with_counting_ffmpeg() const {
    with_quick_plots();
    return with_ffmpeg(counts);
  }
  Surroundings without_ffmpeg() const {
    with_gnuplot(
        "/bin/cat > /dev/null\n"
        "echo '<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\" height=\"1\"/>' > figure.svg\n"
        "echo > figure.png\n");
    return with_ffmpeg("");
  }
};

TEST_F(Film, HasFiftyFramesASecondOfTheRun) {
  EXPECT_EQ(run(short_run("out", {"--film", "film.mp4"}), with_counting_ffmpeg()).exit_code, 0);
  EXPECT_EQ(read("film.mp4"), "51\n");
}

TEST_F(Film, IsAnMp4ThatLastsAsLongAsTheRun) {
  if (!can_film()) GTEST_SKIP() << "ffmpeg is not installed, so no MP4 can be made or read here";
  ASSERT_EQ(run(short_run("out", {"--film", "film.mp4"}), with_quick_plots()).exit_code, 0);
  ASSERT_TRUE(run_in(folder(),
                     {"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                      "stream=codec_name,width,pix_fmt,avg_frame_rate,nb_read_frames,duration", "-of",
                      "default=noprint_wrappers=1", "film.mp4"},
                     "/dev/null"));
  const std::string probed = read(messages_name);
  for (const char* fact : {"codec_name=h264", "width=960", "pix_fmt=yuv420p", "avg_frame_rate=50/1",
                           "duration=1.020000", "nb_read_frames=51"})
    EXPECT_THAT(probed, HasSubstr(fact));
}

TEST_F(Film, IsMadeAgainFromTheResultsAndSlowed) {
  const Surroundings around = with_counting_ffmpeg();
  EXPECT_EQ(run(short_run("out"), around).exit_code, 0);
  const Ran ran = run({"report", "out", "--film", "slow.mp4", "--slow", "4"}, around);
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(read("slow.mp4"), "201\n");
  EXPECT_THAT(
      ran.out,
      HasSubstr("has 50; smoother with --set output.state_rate=\"200 Hz\" --set output.rate=\"200 Hz\""))
      << "100 output times a second are too few";
}

TEST_F(Film, TellsByColourWhatItWasAskedFor) {
  const Surroundings around = without_ffmpeg();
  EXPECT_EQ(run(short_run("out"), around).exit_code, 0);
  for (const std::string colour : {"displacement", "speed", "force", "damage"})
    EXPECT_EQ(run({"report", "out", "--film", colour + ".mp4", "--slow", "0.1", "--colour", colour}, around)
                  .exit_code,
              0);
  EXPECT_NE(read("speed/frame000003.png"), read("displacement/frame000003.png"));
  EXPECT_NE(read("speed/frame000003.png"), read("force/frame000003.png"));
  EXPECT_NE(read("damage/frame000003.png"), read("force/frame000003.png"));
  expect_refusal({"report", "out", "--film", "b.mp4", "--colour", "mood"}, {"--colour", "displacement"},
                 around);
}

TEST_F(Film, WithoutFfmpegLeavesItsFramesAndSaysSo) {
  const Ran ran = run(short_run("out", {"--film", "film.mp4"}), without_ffmpeg());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("ffmpeg is not installed: 51 frames as PNG in film, 50 a second"));
  EXPECT_TRUE(exists("film/frame000000.png"));
  EXPECT_TRUE(exists("film/frame000050.png"));
  EXPECT_FALSE(exists("film.mp4"));
}

TEST_F(Film, ThatFailsCostsNoResults) {
  with_quick_plots();
  const Ran ran = run(short_run("out", {"--film", "film.mp4"}), with_ffmpeg("echo no such codec; exit 1\n"));
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_THAT(ran.out, HasSubstr("no such codec"));
  EXPECT_TRUE(exists("out/report.html"));
}

TEST_F(Film, IsRefusedBeforeTheRunWhereItCannotStand) {
  const Surroundings around = with_counting_ffmpeg();
  expect_refusal(short_run("out", {"--film", "film.gif"}), {"film.gif", "ends in .mp4"}, around);
  write("kept.mp4", "kept");
  expect_refusal(short_run("out", {"--film", "kept.mp4"}), {"kept.mp4", "there already"}, around);
  expect_refusal(short_run("out", {"--film", "nowhere/film.mp4"}), {"nowhere", "no such folder"}, around);
  expect_refusal(short_run("out", {"--slow", "4"}), {"--film"}, around);
  EXPECT_EQ(run(short_run("out", {"--film", "kept.mp4", "--force"}), around).exit_code, 0);
  EXPECT_EQ(read("kept.mp4"), "51\n");
}

}  // namespace
}  // namespace dougong::app
