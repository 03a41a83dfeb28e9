// SPDX-License-Identifier: MIT
#include "host/datasets/open_log.hpp"

#include <algorithm>
#include <array>

#include "host/datasets/bag_files.hpp"
#include "host/datasets/big_wheel_bot_log.hpp"
#include "host/datasets/breezyslam_log.hpp"
#include "host/datasets/brenner_log.hpp"
#include "host/datasets/carl_log.hpp"
#include "host/datasets/carmen_log.hpp"
#include "host/datasets/companion_file.hpp"
#include "host/datasets/edmonton_log.hpp"
#include "host/datasets/line_reader.hpp"
#include "host/datasets/mrclam_log.hpp"
#include "host/datasets/nxt_scan_log.hpp"
#include "host/datasets/roomba_ci_log.hpp"
#include "host/datasets/ros_bag_log.hpp"
#include "host/datasets/run_directory_log.hpp"
#include "host/datasets/tum_log.hpp"
#include "host/datasets/uci_ring_log.hpp"
#include "host/datasets/udacity_log.hpp"
#include "host/datasets/wean_log.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/nearest_word.hpp"

namespace echomap::datasets {
namespace {

/// What a file's name ends in, or its first line begins with, and what that says.
struct Sign {
  std::string_view text;
  std::string_view format;
};

constexpr std::array kNameEndings{
    Sign{"_LASER.txt", "edmonton"},
    Sign{"_scan.txt", "brenner"},
    Sign{"_Odometry.dat", "mrclam"},
    Sign{"measurement.txt", "udacity"},
    Sign{".tum", "tum"},
    Sign{"poses.csv", "run"},
    Sign{".clf", "carmen"},
    Sign{".mcap", "ros2-bag"},
};
constexpr std::array kFirstLineBeginnings{
    Sign{"FLASER ", "carmen"},
    Sign{"ROBOTLASER1 ", "carmen"},
    Sign{"# message formats defined: PARAM", "carmen"},
    Sign{"PARAM ", "carmen"},
    Sign{"L ", "wean"},
    Sign{"O ", "wean"},
    Sign{"timestr ", "carl"},
    Sign{"Time Stamp,", "roomba-ci"},
};

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const LogFormat& format : log_formats()) {
    names.emplace_back(format.name);
  }
  return names;
}

std::string list_of_formats() {
  std::string list;
  for (const LogFormat& format : log_formats()) {
    list += "\n  " + std::string(format.name) + std::string(12 - format.name.size(), ' ') +
            std::string(format.description);
  }
  return list;
}

const LogFormat* find_format(std::string_view name) {
  const auto& formats = log_formats();
  const auto found = std::find_if(
      formats.begin(), formats.end(), [name](const auto& known) { return known.name == name; });
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace

const std::vector<LogFormat>& log_formats() {
  static const std::vector<LogFormat> formats{
      {"bigwheelbot", "Big Wheel Bot: ticks, yaw, two sonars", open_big_wheel_bot_log},
      {"breezyslam", "Mines rover of BreezySLAM: ticks, laser", open_breezyslam_log},
      {"brenner", "LEGO robot of Brenner's course: NAME_scan.txt", open_brenner_log},
      {"carl", "GoPiGo3 Carl: encoders, heading, panned range", open_carl_log},
      {"carmen", "CARMEN: ODOM, FLASER, ROBOTLASER1", open_carmen_log},
      {"edmonton", "Edmonton 2002 as text: NAME_LASER.txt", open_edmonton_log},
      {"mrclam", "UTIAS MRCLAM: RobotN_Odometry.dat", open_mrclam_log},
      {"nxt", "one round scan of a LEGO NXT sonar", open_nxt_scan_log},
      {"roomba-ci", "RoombaCI: encoders, bumper", open_roomba_ci_log},
      {"ros2-bag", "a bag of ROS 2: Range, LaserScan, Odometry", open_ros_bag_log},
      {"run", "a run directory of echomap: points and poses", open_run_directory_log},
      {"tum", "a trajectory in the TUM format", open_tum_log},
      {"uci-ring", "UCI wall following: ring of 24 sonars", open_uci_ring_log},
      {"udacity", "eight sonars with poses: measurement.txt", open_udacity_log},
      {"wean", "CMU Wean Hall: odometry, laser", open_wean_log},
  };
  return formats;
}

std::string unknown_format(std::string_view name) {
  return find_format(name) != nullptr
             ? std::string()
             : "unknown log format '" + std::string(name) + "'" + files::suggestion(name, names());
}

std::optional<std::string_view> recognised_format(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) {
    if (std::filesystem::exists(path / "poses.csv")) {
      return "run";
    }
    return is_bag_folder(path) ? std::optional("ros2-bag") : std::nullopt;
  }
  for (const auto& [ending, format] : kNameEndings) {
    if (has_ending(path, ending)) {
      return format;
    }
  }
  LineReader lines(path);
  const auto line = lines.next();
  for (const auto& [beginning, format] : kFirstLineBeginnings) {
    if (line && line->starts_with(beginning)) {
      return format;
    }
  }
  return std::nullopt;
}

std::unique_ptr<LogReader> open_log(const std::filesystem::path& path, std::string_view format) {
  const std::string_view name = format.empty() ? recognised_format(path).value_or("") : format;
  if (name.empty()) {
    throw files::FileError(path.string() +
                           ": what format is it? Name it with --format:" + list_of_formats());
  }
  const LogFormat* known = find_format(name);
  if (known == nullptr) {
    throw files::FileError(unknown_format(name));
  }
  return known->open(path);
}

}  // namespace echomap::datasets
