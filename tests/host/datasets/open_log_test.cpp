// SPDX-License-Identifier: MIT
#include "host/datasets/open_log.hpp"

#include <gmock/gmock.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class OpenLogTest : public ::testing::Test {
 protected:
  std::optional<std::string_view> recognised(const std::string& file, const std::string& text) {
    files::write_text_file(folder_ / file, text);
    return recognised_format(folder_ / file);
  }
  std::string error_of(const std::string& file, std::string_view format) {
    return tests::thrown_text<files::FileError>([&] { open_log(folder_ / file, format); });
  }

  tests::ScratchFolder folder_;
};

TEST_F(OpenLogTest, NamesOrFirstLinesSayTheFormatWhereTheySayItPlainly) {
  EXPECT_EQ(recognised("a.log", "FLASER 1 1 0 0 0 0 0 0 1 h 1\n"), "carmen");
  EXPECT_EQ(recognised("b.log", "O 1 2 3 4\n"), "wean");
  EXPECT_EQ(recognised("robot4_scan.txt", ""), "brenner");
  EXPECT_EQ(recognised("poses.csv", ""), "run");
  EXPECT_EQ(recognised_format(folder_.path()), "run");
  EXPECT_EQ(recognised("drive.mcap", ""), "ros2-bag");
  EXPECT_EQ(recognised("c.txt", "1 2 3\n"), std::nullopt);
  EXPECT_EQ(recognised("d.txt", ""), std::nullopt);
}

TEST_F(OpenLogTest, AnUnknownFormatIsAnsweredWithTheNearestOne) {
  EXPECT_THAT(error_of("a", "carman"), HasSubstr("did you mean 'carmen'?"));
}

TEST_F(OpenLogTest, WhereNothingIsPlainTheFormatsAreListed) {
  files::write_text_file(folder_ / "c.txt", "1 2 3\n");
  const std::string error = error_of("c.txt", "");
  EXPECT_THAT(error, HasSubstr("--format"));
  for (const auto& format : log_formats()) {
    EXPECT_THAT(error, HasSubstr(std::string(format.name)));
  }
  EXPECT_THAT(error_of("none", ""), HasSubstr("cannot read"));
}

/// Null where the format wants another name of a file.
std::unique_ptr<LogReader> opened(const LogFormat& format, const std::filesystem::path& file) {
  try {
    return format.open(file);
  } catch (const files::FileError& refused) {
    if (std::string(refused.what()).find("ends in") == std::string::npos) {
      throw;
    }
  }
  return nullptr;
}

TEST_F(OpenLogTest, EveryFormatRefusesBinary) {
  for (const auto& format : log_formats()) {
    for (const char* file : {"a_LASER.txt",
                             "a_scan.txt",
                             "R_Odometry.dat",
                             "measurement.txt",
                             "poses.csv",
                             "a_ODO.txt",
                             "a_motors.txt",
                             "R_Measurement.dat",
                             "Barcodes.dat",
                             "poses.txt",
                             "points.csv"}) {
      files::write_text_file(folder_ / file, std::string("\x7f\x45\x4c\x46\0\x01\xff\xfe\n", 9));
    }
    const std::string error = tests::thrown_text<files::FileError>([&] {
      for (const char* file :
           {"a_LASER.txt", "a_scan.txt", "R_Odometry.dat", "measurement.txt", "poses.csv"}) {
        // Formats of several files want their own name; the first that opens is read.
        if (const auto log = opened(format, folder_ / file)) {
          tests::records_of(*log);
        }
      }
    });
    const char* what = format.name == "ros2-bag" ? "MCAP" : ":1: the line contains a zero byte";
    EXPECT_THAT(error, HasSubstr(what)) << format.name;
  }
}

TEST(RealLogs, SayTheirFormatWhereTheirReadmeNeedNotBeAsked) {
  struct Case {
    const char* file;
    const char* format;
  };
  for (const auto& [file, format] :
       {Case{"edmonton/dataset_edmonton.rawlog_LASER.txt.gz", "edmonton"},
        Case{"edmonton/edmonton-corrected.log.gz", "carmen"},
        Case{"carmen_corrected/aces-corrected.log.gz", "carmen"},
        Case{"carmen_raw/csail.log.gz", "carmen"},
        Case{"wean_mcl/robotdata1.log.gz", "wean"},
        Case{"wean_mcl/robotdata4.log.gz", "wean"},
        Case{"lego_brenner/robot4_scan.txt.gz", "brenner"},
        Case{"carl_gopigo3_panrange/20200705-092613.txt", "carl"},
        Case{"roomba_ci_clemson/2018_Summer_DataTest1a.txt.gz", "roomba-ci"},
        Case{"udacity_8sonar/measurement.txt", "udacity"},
        Case{"utias_mrclam/MRCLAM_Dataset6/Robot1_Odometry.dat.gz", "mrclam"}}) {
    const auto path = tests::real_data(file);
    ECHOMAP_SKIP_WITHOUT(path);
    EXPECT_EQ(recognised_format(path), format) << file;
  }
}

}  // namespace
}  // namespace echomap::datasets
