// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/exports/geojson.hpp"
#include "host/exports/map_gif.hpp"
#include "host/exports/map_style.hpp"
#include "host/exports/pose_graph_g2o.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/panned_stops.hpp"
#include "tests/support/png_picture.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

/// A small run, exported, and what other programs say of its files.
class ExportReaders : public ::testing::Test {
 protected:
  void SetUp() override { write_run_directory(folder_.path(), snapshot_, {}); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// What a command prints; the test fails where it does.
  std::string output_of(const std::string& command) const {
    const std::string said = path("said");
    EXPECT_EQ(std::system(("timeout 60 " + command + " > " + said + " 2>&1").c_str()), 0)
        << command << ": " << files::read_text_file(said);
    return files::read_text_file(said);
  }

  /// What Chromium shows of a file, on a background that no picture of ours has.
  tests::PngPicture shown_by_chromium(const std::string& name) const {
    output_of(
        "chromium --headless --no-sandbox --disable-gpu --no-first-run "
        "--force-color-profile=srgb --hide-scrollbars --window-size=900,700 "
        "--default-background-color=ff00ffff --user-data-dir=" +
        path("profile") + " --screenshot=" + path("shot.png") + " file://" + path(name));
    return tests::PngPicture(path("shot.png"));
  }

  tests::ScratchFolder folder_;
  pipeline::Snapshot snapshot_ = tests::run_of_two_stops();
};

std::ptrdiff_t pixels_of(const tests::PngPicture& picture, Colour colour) {
  return std::count(picture.pixels.begin(),
                    picture.pixels.end(),
                    colour.red << 16 | colour.green << 8 | colour.blue);
}

double number_after(const std::string& text, const std::string& key) {
  std::smatch match;
  EXPECT_TRUE(std::regex_search(text, match, std::regex(key + "([-0-9.e]+)"))) << text;
  return match.empty() ? std::nan("") : std::stod(match[1]);
}

TEST_F(ExportReaders, ImageMagickReadsThePgmOfTheMap) {
  if (!is_installed("identify")) {
    GTEST_SKIP() << "identify of Debian's imagemagick is not installed";
  }
  // Touched cells with a margin of one; the values of ROS: occupied, unknown and free.
  EXPECT_EQ(output_of("identify -format '%m %w x %h, %z bits, %k values' " + path("map.pgm")),
            "PGM 52 x 23, 8 bits, 3 values");
}

TEST_F(ExportReaders, ImageMagickReadsEveryFrameOfTheGif) {
  if (!is_installed("identify")) {
    GTEST_SKIP() << "identify of Debian's imagemagick is not installed";
  }
  MapAnimation animation({.frame_ms = 500, .last_frame_ms = 2000});
  animation.add(snapshot_, std::nullopt, "1 stop");
  animation.add(snapshot_, std::nullopt, "2 stops");
  animation.save(path("map.gif"));
  EXPECT_THAT(output_of("identify -format '%m %T;' " + path("map.gif")), "GIF 50;GIF 200;");
}

TEST_F(ExportReaders, GdalMeasuresTheAreaOfTheOutline) {
  if (!is_installed("ogrinfo")) {
    GTEST_SKIP() << "ogrinfo of Debian's gdal-bin is not installed";
  }
  const auto outline = read_outline_geojson(path("outline.geojson"));
  ASSERT_TRUE(outline.has_value());
  const std::string said = output_of(
      "ogrinfo -ro -dialect OGRSQL -sql 'SELECT name, area_m2, OGR_GEOM_AREA AS area FROM "
      "outline' " +
      path("outline.geojson"));
  EXPECT_THAT(said, HasSubstr("Feature Count: 1"));
  EXPECT_THAT(said, HasSubstr("name (String) = outline"));
  EXPECT_NEAR(number_after(said, "area \\(Real\\) = "), outline->area_m2(), 1e-6);
  EXPECT_NEAR(number_after(said, "area_m2 \\(Real\\) = "), outline->area_m2(), 1e-6);
}

TEST_F(ExportReaders, ChromiumDrawsTheSvg) {
  if (!is_installed("chromium")) {
    GTEST_SKIP() << "Debian's chromium is not installed";
  }
  const tests::PngPicture shot = shown_by_chromium("map.svg");
  for (const Colour colour : {kFloorColour, kWallColour, kUnknownColour, kOutlineColour}) {
    EXPECT_GT(pixels_of(shot, colour), 200)
        << fmt::format("{}, {}, {}", colour.red, colour.green, colour.blue);
  }
  EXPECT_GT(pixels_of(shot, kRobotColour), 20);
}

TEST_F(ExportReaders, ChromiumShowsTheGif) {
  if (!is_installed("chromium")) {
    GTEST_SKIP() << "Debian's chromium is not installed";
  }
  MapAnimation animation;
  animation.add(snapshot_, read_outline_geojson(path("outline.geojson")), "2 stops");
  animation.save(path("map.gif"));
  const tests::PngPicture shot = shown_by_chromium("map.gif");
  for (const Colour colour : {kFloorColour, kWallColour, kUnknownColour, kOutlineColour}) {
    EXPECT_GT(pixels_of(shot, colour), 200)
        << fmt::format("{}, {}, {}", colour.red, colour.green, colour.blue);
  }
}

/// The rules of evo 1.x for files of this format: eight columns with one blank between and none at
/// the end, numbers all of them, and stamps that rise; it then wants unit quaternions.
TEST_F(ExportReaders, TheTrajectoryFollowsTheRulesOfEvo) {
  std::istringstream lines(files::read_text_file(path("trajectory.tum")));
  double last_s = -1.0;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    ASSERT_THAT(line, MatchesRegex("[-0-9.e]+( [-0-9.e]+){7}"));
    std::istringstream fields(line);
    std::vector<double> values(8);
    for (double& value : values) {
      ASSERT_TRUE(fields >> value) << line;
    }
    EXPECT_GT(values[0], last_s);
    last_s = values[0];
    EXPECT_NEAR(Eigen::Map<const Eigen::Vector4d>(&values[4]).norm(), 1.0, 1e-6);
  }
  EXPECT_EQ(count, snapshot_.trajectory->size());
}

TEST_F(ExportReaders, MrptSolvesThePoseGraph) {
  if (!is_installed("graph-slam")) {
    GTEST_SKIP() << "graph-slam of Debian's mrpt-apps is not installed";
  }
  const Eigen::Matrix3d information = Eigen::Vector3d(1e4, 1e4, 4e4).asDiagonal();
  write_pose_graph_g2o(
      path("pose_graph.g2o"),
      {{{}, {1.2, 0.3, 0.4}, {2.2, 1.3, 0.9}},
       {},
       {{0, 1, {1.0, 0.0, 0.5}, information, false}, {1, 2, {1.0, 0.0, 0.5}, information, false}},
       {}});
  output_of("graph-slam --2d --levmarq -q -i " + path("pose_graph.g2o") + " -o " +
            path("solved.graph"));
  const std::string solved = files::read_text_file(path("solved.graph"));
  EXPECT_NEAR(number_after(solved, "VERTEX_SE2 1 "), 1.0, 1e-4);
  EXPECT_NEAR(number_after(solved, "VERTEX_SE2 1 \\S+ \\S+ "), 0.5, 1e-4);
  EXPECT_NEAR(number_after(solved, "VERTEX_SE2 2 "), 1.0 + std::cos(0.5), 1e-4);
  EXPECT_NEAR(number_after(solved, "VERTEX_SE2 2 \\S+ "), std::sin(0.5), 1e-4);
}

TEST_F(ExportReaders, MrptPassesOverTheLandmarksOfAPoseGraph) {
  if (!is_installed("graph-slam")) {
    GTEST_SKIP() << "graph-slam of Debian's mrpt-apps is not installed";
  }
  write_pose_graph_g2o(path("pose_graph.g2o"),
                       {{{}, {1.0, 0.0, 0.5}},
                        {{3.0, 4.0}},
                        {{0, 1, {1.0, 0.0, 0.5}, Eigen::Matrix3d::Identity(), false}},
                        {{1, 0, {6.0, 7.0}, Eigen::Matrix2d::Identity()}},
                        {{{0.0, 1.0}, {2.0, 1.0}}}});
  const std::string said = output_of("graph-slam --2d --info -i " + path("pose_graph.g2o"));
  EXPECT_EQ(number_after(said, "Edge count +: "), 1.0);
  EXPECT_EQ(number_after(said, "Nodes count \\(in VERTEX2/3 entries\\) : "), 2.0);
}

}  // namespace
}  // namespace echomap::exports
