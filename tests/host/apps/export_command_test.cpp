// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/apps/commands.hpp"
#include "host/apps/saved_map.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/support/played_recording.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ExportCommandTest : public ::testing::Test {
 protected:
  ExportCommandTest() {
    options.run = scratch / "kitchen";
    fs::create_directories(options.run);
    tests::WrittenRecording recording(profile);
    recording.begin(recorded);
    recording.add_stop(1.0);
    recording.add_stop(1.2);
    recording.save(recorded);
    tests::play_recording(recorded, atlas, &atlas);
    exports::RunSummary summary;
    summary.robot = profile.name;
    summary.slam = "multiscan";
    save_map(atlas.pipeline(), profile, options.run, summary);
  }
  std::string exported(const std::string& format) {
    options.to = format;
    options.out = scratch / ("out." + format);
    EXPECT_EQ(run_export(options), ExitCode::kOk);
    return files::read_text_file(options.out);
  }

  const tests::ScratchFolder scratch;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  pipeline::RobotAtlas atlas = session::atlas_for(profile, "multiscan");
  ExportOptions options;
  const fs::path recorded = scratch / "kitchen" / recording::kSessionFileName;
};

TEST_F(ExportCommandTest, DrawsTheRunsFilesAgainToTheBit) {
  for (const auto& [format, file] : {std::pair("pgm", "map.pgm"),
                                     std::pair("png", "map.png"),
                                     std::pair("svg", "map.svg"),
                                     std::pair("geojson", "outline.geojson"),
                                     std::pair("tum", "trajectory.tum"),
                                     std::pair("g2o", "pose_graph.g2o")}) {
    EXPECT_EQ(exported(format), files::read_text_file(options.run / file)) << format;
  }
  EXPECT_THAT(files::read_text_file(scratch / "out.yaml"), HasSubstr("image: out.pgm"));
}

TEST_F(ExportCommandTest, WritesWhatOtherProgramsTake) {
  const std::string table = exported("csv");
  EXPECT_THAT(table, StartsWith("kind,stamp_us,values\nodometry,"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 69) << "two of odometry and 62 pings";
  EXPECT_THAT(exported("carmen"), HasSubstr("\nROBOTLASER1 "));
  EXPECT_THAT(exported("json"), HasSubstr("\"trajectory\""));
  EXPECT_THAT(exported("gif"), StartsWith("GIF89a"));
}

TEST_F(ExportCommandTest, OfTheFileAloneIsTheSame) {
  const std::string map = exported("svg");
  fs::copy_file(recorded, scratch / "lone.mcap");
  options.run = scratch / "lone.mcap";
  options.force = true;
  EXPECT_EQ(exported("pgm"), files::read_text_file(scratch / "kitchen" / "map.pgm"));
}

TEST_F(ExportCommandTest, EndsWhereItIsAskedTo) {
  options.until_s = 0.05;
  EXPECT_NE(exported("tum"), files::read_text_file(options.run / "trajectory.tum"));
}

TEST_F(ExportCommandTest, OverwritesNothingUnasked) {
  exported("json");
  EXPECT_THAT(tests::thrown_text<CommandError>([&] { run_export(options); }),
              AllOf(HasSubstr("out.json exists"), HasSubstr("--force")));
  options.force = true;
  EXPECT_EQ(run_export(options), ExitCode::kOk);
}

TEST_F(ExportCommandTest, OverwritesNoFileBesideAPgmAndNotTheRecording) {
  options.to = "pgm";
  options.out = scratch / "map.txt";
  EXPECT_THAT(tests::thrown_text<CommandError>([&] { run_export(options); }),
              HasSubstr("does not end with .pgm"));
  options.out = scratch / "map.pgm";
  files::write_text_file(scratch / "map.yaml", "mine");
  EXPECT_THAT(tests::thrown_text<CommandError>([&] { run_export(options); }),
              HasSubstr("map.yaml exists"));
  options.to = "csv";
  options.out = recorded;
  options.force = true;
  EXPECT_THAT(tests::thrown_text<CommandError>([&] { run_export(options); }),
              HasSubstr("is the recording itself"));
}

TEST_F(ExportCommandTest, OfNothingIsAnError) {
  options.to = "png";
  options.out = scratch / "empty.png";
  options.until_s = 1e-6;
  EXPECT_THAT(tests::thrown_text<CommandError>([&] { run_export(options); }),
              HasSubstr("nothing was recorded from 0 s"));
  EXPECT_FALSE(exists(options.out));
}

TEST_F(ExportCommandTest, SaysWhatIsMissing) {
  options.to = "png";
  options.out = scratch / "other.png";
  fs::remove(recorded);
  EXPECT_THAT(tests::thrown_text<CommandError>([&] { run_export(options); }),
              AllOf(HasSubstr("kitchen is no recording of a run"), HasSubstr("next: ")));
  EXPECT_FALSE(exists(options.out));
}

TEST_F(ExportCommandTest, OfADamagedRecordingHasWhatComesBefore) {
  std::string bytes = files::read_text_file(recorded);
  const std::size_t place = bytes.find("zstd", bytes.find("zstd") + 1) + 200;
  bytes[place] = static_cast<char>(bytes[place] ^ 1);
  files::write_text_file(recorded, bytes);
  options.to = "tum";
  options.out = scratch / "part.tum";
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { run_export(options); }),
              AllOf(HasSubstr("part.tum holds what comes before"), HasSubstr("byte ")));
  EXPECT_TRUE(exists(options.out));
}

}  // namespace
}  // namespace echomap::apps
