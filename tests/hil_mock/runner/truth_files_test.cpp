// SPDX-License-Identifier: MIT
#include "hil_mock/runner/truth_files.hpp"

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/world/rooms.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class TruthFiles : public testing::Test {
 protected:
  TruthFiles() {
    board.duty = {0.4, 0.6};
    simulation.advance_to(1'000'000'000);
  }

  std::string written(const std::string& name, const TruthSummary& summary = {}) {
    write_truth_files(folder / "truth", simulation, summary);
    return files::read_text_file(folder / "truth" / name);
  }

  tests::ScratchFolder folder;
  FakeBoard board;
  world::RobotWorld robot_world{
      world::box_room({{world::rectangle(1.0, 1.0, 1.5, 1.4), {{world::Material::kRough}}}}),
      {},
      1};
  RobotSimulation simulation{board, robot_world};
};

TEST_F(TruthFiles, TrajectoryHasEightColumnsAndUnitQuaternions) {
  std::istringstream file(written("truth.tum"));
  std::string line;
  int lines = 0;
  while (std::getline(file, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ' '), 7) << line;
    std::istringstream numbers(line);
    double t = 0, x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 0;
    ASSERT_TRUE(numbers >> t >> x >> y >> z >> qx >> qy >> qz >> qw) << line;
    EXPECT_NEAR(t, 0.02 * lines, 1e-9);
    EXPECT_NEAR(qz * qz + qw * qw, 1.0, 1e-8);
    const geometry::Pose2& truth =
        simulation.trajectory()[static_cast<std::size_t>(lines)].T_world_robot;
    EXPECT_NEAR(2.0 * std::atan2(qz, qw), truth.heading_rad(), 1e-8);
    EXPECT_NEAR(x, truth.x_m(), 1e-6);
    ++lines;
  }
  EXPECT_EQ(lines, 51);
}

TEST_F(TruthFiles, TrajectoryEndsWithTheRunBetweenTwoSamples) {
  constexpr std::int64_t kEndNs = 1'011'000'000;
  simulation.advance_to(kEndNs);
  const std::string text = written("truth.tum");
  const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_THAT(last, testing::StartsWith("1.011000 "));
}

TEST_F(TruthFiles, MapIsAPgmOfItsSizeByTheRulesOfRos) {
  const std::string pgm = written("truth_map.pgm");
  const std::string header = "P5\n420 320\n255\n";
  ASSERT_EQ(pgm.substr(0, header.size()), header);
  ASSERT_EQ(pgm.size(), header.size() + 420U * 320U);
  const auto pixel = [&](double x_m, double y_m) {
    const auto column = static_cast<std::size_t>((x_m + 0.1) / 0.01);
    const auto row_from_top = 319U - static_cast<std::size_t>((y_m + 0.1) / 0.01);
    return static_cast<unsigned char>(pgm[header.size() + row_from_top * 420U + column]);
  };
  EXPECT_EQ(pixel(2.505, 2.505), 254);
  EXPECT_EQ(pixel(1.255, 1.205), 205) << "inside of the obstacle";
  EXPECT_EQ(pixel(1.255, 1.405), 0) << "its upper side";
  EXPECT_EQ(pixel(-0.055, 1.005), 205) << "outside";
  const std::string yaml = written("truth_map.yaml");
  EXPECT_THAT(yaml, HasSubstr("image: truth_map.pgm\n"));
  EXPECT_THAT(yaml, HasSubstr("resolution: 0.01\norigin: [-0.1, -0.1, 0]\n"));
  EXPECT_THAT(yaml, HasSubstr("free_thresh: 0.196\n"));
}

TEST_F(TruthFiles, WallsAreLineStrings) {
  const json walls = json::parse(written("truth_walls.geojson"));
  EXPECT_EQ(walls["type"], "FeatureCollection");
  ASSERT_EQ(walls["features"].size(), 8U);
  const json& first = walls["features"][0]["geometry"];
  EXPECT_EQ(first["type"], "LineString");
  EXPECT_EQ(first["coordinates"], json::parse("[[0.0, 0.0], [4.0, 0.0]]"));
}

TEST_F(TruthFiles, AllButTheSummaryAreThereBeforeTheEnd) {
  write_truth_so_far(folder / "early", simulation);
  for (const char* name : {"truth.tum", "truth_map.pgm", "truth_map.yaml", "truth_walls.geojson"}) {
    EXPECT_EQ(files::read_text_file(folder / "early" / name), written(name)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "early" / "truth.json"));
}

TEST_F(TruthFiles, ABoxIsInThem) {
  const std::string before = written("truth_map.pgm");
  simulation.put_box(simulation.box_at({1.0, 1.0}, 0.3));
  EXPECT_NE(written("truth_map.pgm"), before);
  EXPECT_EQ(json::parse(written("truth_walls.geojson"))["features"].size(), 12U);
}

TEST(TruthOfSources, SaysWhereTheyAreInTheWorldAndSeenFromTheStart) {
  world::FloorMarks marks;
  marks.sources = {{world::SourceKind::kRadiation, {3.0, 2.5}, 20.0, 0.1}};
  marks.backgrounds.radiation_per_s = 0.4;
  FakeBoard board;
  world::RobotWorld hot(
      {"hot", {world::rectangle(0.0, 0.0, 4.0, 3.0), {}}, {}, {2.0, 1.5, 0.0}, marks}, {}, 1);
  RobotSimulation simulation(board, hot);
  const tests::ScratchFolder folder;
  write_truth_so_far(folder / "truth", simulation);
  const json text = json::parse(files::read_text_file(folder / "truth" / "source.json"));
  EXPECT_EQ(text["background_per_s"], 0.4);
  ASSERT_EQ(text["sources"].size(), 1U);
  EXPECT_EQ(text["sources"][0]["kind"], "radiation");
  EXPECT_EQ(text["sources"][0]["x_m"], 3.0);
  EXPECT_EQ(text["sources"][0]["map_y_m"], 1.0);
  EXPECT_EQ(text["sources"][0]["strength"], 20.0);
}

TEST_F(TruthFiles, IsSilentOfSourcesWhereThereAreNone) {
  written("truth.json");
  EXPECT_FALSE(std::filesystem::exists(folder / "truth" / "source.json"));
}

TEST_F(TruthFiles, SummarySaysWhatRan) {
  const json quiet =
      json::parse(written("truth.json", {.seed = 12, .dropped_bytes = 3, .stop = {}}));
  EXPECT_EQ(quiet["world"], "box");
  EXPECT_EQ(quiet["robot"], "uno_2wd");
  EXPECT_EQ(quiet["seed"], 12);
  EXPECT_EQ(quiet["firmware"], "fake 1.0");
  EXPECT_DOUBLE_EQ(quiet["sim_seconds"].get<double>(), 1.0);
  EXPECT_EQ(quiet["last_driven_ns"], 1'000'000'000);
  EXPECT_EQ(quiet["last_heard_ns"], 0);
  EXPECT_EQ(quiet["left_counts"], board.left_edges.size());
  EXPECT_TRUE(quiet["stop"].is_null());
  const json vanished =
      json::parse(written("truth.json", {1, 0, StopReport{1'000'000, 200'000'000}}));
  EXPECT_EQ(vanished["stop"]["stopped_after_ns"], 200'000'000);
  EXPECT_EQ(vanished["stop"]["stopped_after_cycles"], 3'200'000);
}

TEST(StopReport, SaysWhenTheWheelsStopped) {
  EXPECT_THAT(describe(StopReport{0, 250'000'000}), HasSubstr("0.25"));
  EXPECT_THAT(describe(StopReport{0, 250'000'000}), HasSubstr("4000000 CPU cycles"));
  EXPECT_THAT(describe(StopReport{0, std::nullopt}), HasSubstr("still driven"));
}

}  // namespace
}  // namespace echomap::runner
