// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/datasets/open_log.hpp"
#include "host/files/atomic_file.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/temporary_folder.hpp"
#include "tests/support/bag_writer.hpp"

namespace {

using echomap::fuzz::require;
namespace datasets = echomap::datasets;
namespace fs = std::filesystem;
namespace sensors = echomap::sensors;

/// Ends one file of an input and begins the next.
constexpr char kNextFile = '\x1e';
constexpr std::size_t kFiles = 4;

/// The names under which a format finds its files, that of the log first.
std::vector<std::string> names_of(std::string_view format) {
  if (format == "edmonton") {
    return {"e_LASER.txt", "e_ODO.txt", "e_TIME_interp.txt", "e_REF.txt"};
  }
  if (format == "brenner") {
    return {"b_scan.txt", "b_motors.txt", "b_reference.txt"};
  }
  if (format == "mrclam") {
    return {"R_Odometry.dat", "R_Measurement.dat", "Barcodes.dat", "R_Groundtruth.dat"};
  }
  if (format == "udacity") {
    return {"measurement.txt", "poses.txt"};
  }
  if (format == "run") {
    return {"poses.csv", "points.csv"};
  }
  return {"log"};
}

/// A folder for each format, whose files are in memory.
class LogFolders {
 public:
  LogFolders() {
    for (const auto& format : datasets::log_formats()) {
      const fs::path logs = folder_.path() / format.name;
      fs::create_directory(logs);
      std::size_t file = 0;
      for (const auto& file_name : names_of(format.name)) {
        fs::create_symlink(files_[file++].path(), logs / file_name);
      }
    }
  }

  fs::path log_of(std::string_view format) const {
    return folder_.path() / format / names_of(format).front();
  }
  void write(std::string_view format, std::span<const std::uint8_t> bytes) {
    if (names_of(format).size() == 1) {
      files_.front().write(bytes);
      return;
    }
    for (auto& file : files_) {
      const auto end = std::find(bytes.begin(), bytes.end(), kNextFile);
      const auto size = static_cast<std::size_t>(end - bytes.begin());
      file.write(bytes.first(size));
      bytes = bytes.subspan(std::min(size + 1, bytes.size()));
    }
  }

 private:
  std::array<echomap::fuzz::MemoryFile, kFiles> files_;
  echomap::fuzz::TemporaryFolder folder_;
};

void check(const sensors::RangeScan& scan) {
  // A line has at most so many numbers; a run directory says so of its own scans.
  constexpr std::size_t kMaxBeams = 100000;
  require(scan.beams.size() <= kMaxBeams, "a scan has no more beams than its text");
  require(std::isfinite(scan.T_robot_sensor.x_m()), "a sensor is somewhere");
  for (const auto& beam : scan.beams) {
    require(std::isfinite(beam.bearing_rad), "a beam looks somewhere");
    require(!beam.range_m || (*beam.range_m >= 0.0 && *beam.range_m <= scan.max_range_m),
            "a return is within reach");
  }
}

void read(const datasets::LogFormat& format, const fs::path& path) {
  const auto log = format.open(path);
  while (const auto record = log->next()) {
    const auto stamp_s = datasets::stamp_s(*record);
    require(!stamp_s || std::isfinite(*stamp_s), "a stamp is a number");
    if (const auto* scan = std::get_if<sensors::RangeScan>(&*record)) {
      check(*scan);
    } else if (const auto* pose = std::get_if<datasets::GivenPose>(&*record)) {
      require(std::isfinite(pose->T_map_robot.x_m()), "a pose is somewhere");
    }
  }
  require(log->progress() >= 0.0 && log->progress() <= 1.0, "progress is a share");
}

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

/// A bag of everything that is read of bags.
std::string small_bag() {
  namespace tests = echomap::tests;
  const echomap::fuzz::TemporaryFolder folder;
  const fs::path path = folder.path() / "log";
  tests::BagWriter bag(path);
  bag.write("/tf_static", tests::ros_transform(0.0, "base_link", "mast", {0.1, 0.0, 0.5}), 1.0);
  bag.write("/tf", tests::ros_transform(1.0, "mast", "sonar", {0.0, 0.0, -0.5}), 1.0);
  bag.write("/odom", tests::ros_odometry(1.0, {0.1, 0.2, 0.3}), 1.0);
  bag.write("/sonar", tests::ros_range(1.1, "sonar", 2.0), 1.1);
  echomap::ros_messages::LaserScan sweep;
  sweep.header = tests::ros_header(1.2, "mast");
  sweep.range_max = 8.0F;
  sweep.ranges = {1.0F, 2.0F, 9.0F};
  bag.write("/scan", sweep, 1.2);
  bag.finish();
  return echomap::files::read_text_file(path);
}

/// A log of a format in a few lines.
std::string small_log(std::string_view format) {
  const std::string next(1, kNextFile);
  if (format == "carmen") {
    return "# FLASER\nODOM 0 0 0 0 0 0 1 h 1\nFLASER 2 1 81.9 1 2 3 1 2 3 2 h 2\r\n"
           "ROBOTLASER1 0 -1.5 3 0.5 80 0.01 0 2 1 80 0 1 2 3 1 2 3 0 0 0 0 0 4 h 4\n";
  }
  if (format == "edmonton") {
    return repeated("1.5 ", 180) + "\n" + repeated("51 ", 180) + next + "0 0 0\n1 0 0.5\n" + next +
           "# t\n1\n2\n" + next + "1 2 3 4 5\n";
  }
  if (format == "wean") {
    return "O 1 2 3 4\nL 1 2 3 4 5 6 " + repeated("8191 ", 180) + "7\n";
  }
  if (format == "brenner") {
    return "S 2 3 100 200 300\n" + next + "M 1 5 0 0 0 6 0\nM 3 7 0 0 0 8 0\n" + next + "P 1 2 3\n";
  }
  if (format == "mrclam") {
    return "# t v w\n1 0.5 0.1\n2 0 0\n" + next + "1.5 72 2 0.1\n" + next + "6 72\n" + next +
           "1 2 3 4\n";
  }
  if (format == "carl") {
    return "timestr\n20200705-092618.125, 0, 0, 358.9, -12.5, 3000\n";
  }
  if (format == "bigwheelbot") {
    return "1,-1,-155,376,500,60,59,105,-98\n";
  }
  if (format == "nxt") {
    return "122.0\n255\n30\n";
  }
  if (format == "udacity") {
    return "1000 5110 2 3 4 5 6 7 8\n" + next + "1000 1 2 900\n";
  }
  if (format == "uci-ring") {
    return repeated("5.000,", 24) + "Sharp-Right-Turn\n";
  }
  if (format == "breezyslam") {
    return "1 0 5 6" + repeated(" 0", 20) + repeated(" 1000", 683) + "\n";
  }
  if (format == "roomba-ci") {
    return "0.02, 32767, -32768, 62.5, 00000001, 00111111, 1, 2, 3, 4, 5, 6;\n";
  }
  if (format == "ros2-bag") {
    return small_bag();
  }
  if (format == "tum") {
    return "# t\n1 2 3 0 0 0 0.7 0.7\n";
  }
  return "x_m,y_m,heading_rad\n0,0,0\n1,1,1\n" + next + "x_m,y_m,pose_index\n1,2,0\n3,4,1\n";
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds;
  std::uint8_t kind = 0;
  for (const auto& format : datasets::log_formats()) {
    seeds.push_back(input_of(kind++, small_log(format.name)));
  }
  return seeds;
}

/// One input is a format and the text of its files. They are read as records, or refused with a
/// FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  static LogFolders folders;
  const auto& formats = datasets::log_formats();
  const auto& format = formats[data[0] % formats.size()];
  folders.write(format.name, {data + 1, size - 1});
  try {
    read(format, folders.log_of(format.name));
  } catch (const echomap::files::FileError& error) {
    require(std::string_view(error.what()).size() < 1000, "an error can be read");
  }
  return 0;
}
