// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/apps/recorded_run.hpp"
#include "host/console/exit_code.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/session/open_robot.hpp"
#include "host/session/simulated_robots.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {

/// What a command answers or throws.
using console::CommandError;
using console::ExitCode;

/// Options that mean the same in every sub-command that has them.
struct RunOptions {
  std::string robot = "uno_2wd";
  strategies::StrategyOptions strategy;
  /// A way of slam::slam_methods() that a robot with a sonar is placed by, or "none": odometry.
  std::string slam = "multiscan";
  bool slam_is_named = false;  ///< It is asked for, and not as by default.
  std::uint32_t seed = 1;
  std::filesystem::path out;   ///< Empty: a stamped folder below the user's data folder.
  std::filesystem::path json;  ///< Empty: none; "-": stdout.
  bool force = false;          ///< Overwrite a run that `out` has in it.
  bool headless = false;
  std::string view = "line";  ///< What is shown while it runs: or "map" or "none".
  bool align = true;          ///< Turn the pictures to the room's main direction.
  /// Megabytes at which the recording goes on in another file; 0: never.
  std::uint64_t split_mb = 0;
};

/// Whether and how a run is shown in a browser.
struct LiveOptions {
  bool serves = false;
  std::string listen = "127.0.0.1";  ///< ADDRESS or ADDRESS:PORT.
  bool opens_browser = true;         ///< Where there is a desktop.
};

/// `echomap explore`: drives the robot on a port.
struct ExploreOptions {
  RunOptions run;
  LiveOptions live;
  std::string fixes;  ///< udp:HOST:PORT or tcp:HOST:PORT of an overhead camera; empty: none.
  std::filesystem::path resume;  ///< Run directory of the run to go on with; empty: none.
  session::ConnectionOptions connection;
};
ExitCode run_explore(const ExploreOptions& options);

/// `echomap demo`: an emulated robot in a bundled room explores it and is scored.
struct DemoOptions {
  RunOptions run;
  LiveOptions live;
  /// Times real time, 0: as fast as it can; empty: by whether somebody may watch.
  std::optional<double> speed;
  session::SimulatedRobotOptions robot;
  bool no_kidnap = false;  ///< End with the map.
};
ExitCode run_demo(const DemoOptions& options);

/// `echomap search`: drives a robot with a scalar sensor until it knows whether and where a source
/// is.
struct SearchOptions {
  RunOptions run;
  LiveOptions live;
  session::ConnectionOptions connection;
  session::SimulatedRobotOptions robot;  ///< Without a world the robot is at a port.
  std::optional<double> max_s = 900.0;   ///< Robot time; empty: until it is sure.
};
ExitCode run_search(const SearchOptions& options);

/// `echomap eval`: scores a run directory against the truth, or against known relations.
struct EvalOptions {
  std::filesystem::path run;
  std::filesystem::path truth;      ///< Empty: none; there is this or `relations`, or both.
  std::filesystem::path relations;  ///< Empty: none.
  std::filesystem::path picture;    ///< Empty: none; needs `truth`.
  bool align = true;                ///< Turn the picture to the room's main direction.
  std::filesystem::path json;
};
ExitCode run_eval(const EvalOptions& options);

/// `echomap replay`: makes a map of a log.
struct ReplayOptions {
  std::filesystem::path log;
  std::string format;              ///< Empty: what the log plainly says.
  std::string map = "grid";        ///< Or "points" or "polygon".
  std::string poses = "odometry";  ///< Or "given".
  std::string slam;                ///< A way of slam::slam_methods(); empty: by `poses`.
  double resolution_m = 0.05;
  PlayedPart part;    ///< Of a recording.
  bool step = false;  ///< Wait for Enter after each stop of a recording.
  bool align = true;  ///< Turn the pictures to the room's main direction.
  std::filesystem::path out;
  std::filesystem::path json;
  bool force = false;  ///< Overwrite a run that `out` has in it.
  bool headless = false;
  LiveOptions live;

  /// Whether something is asked for that only a recording can do.
  bool plays_a_part() const { return step || part != PlayedPart(); }
};
ExitCode run_replay(const ReplayOptions& options);

/// `echomap serve`: shows finished runs in a browser.
struct ServeOptions {
  std::vector<std::filesystem::path> runs;  ///< Run directories or recordings.
  LiveOptions live;
};
ExitCode run_serve(const ServeOptions& options);

/// `echomap export`: draws one file of a recorded run again.
struct ExportOptions {
  std::filesystem::path run;              ///< Run directory or recording.
  std::string to;                         ///< One of `export_names()`.
  std::filesystem::path out;              ///< Empty: the run's name with the format's ending, here.
  double until_s = PlayedPart().until_s;  ///< Second of the recording at which to stop.
  bool align = true;                      ///< Turn the pictures to the room's main direction.
  bool force = false;                     ///< Overwrite the file.
};
ExitCode run_export(const ExportOptions& options);
/// The formats of `echomap export`.
std::vector<std::string> export_names();

/// `echomap localize`: finds and follows a robot in a map.
struct LocalizeOptions {
  std::filesystem::path log;   ///< Of a robot that drove; empty: one that drives, at a port.
  std::string format;          ///< Empty: what the log plainly says.
  std::filesystem::path map;   ///< A run directory or the YAML file of a map.
  std::vector<double> at;      ///< x and y in metres, heading in degrees; empty: anywhere.
  std::string filter = "mcl";  ///< Or "ekf", which has fixes instead of a map.
  std::string fixes;           ///< udp:HOST:PORT or tcp:HOST:PORT of an overhead camera.
  /// The camera's frame in the map: metres and degrees; empty: the map's own.
  std::vector<double> camera_at;
  localization::LocalizerPreset preset = localization::LocalizerPreset::kDefault;
  std::optional<std::size_t> particles{};    ///< Empty: those of the preset.
  std::optional<double> resampling_share{};  ///< Empty: that of the preset.
  session::ConnectionOptions connection;
  RunOptions run;
  LiveOptions live;
};
ExitCode run_localize(const LocalizeOptions& options);

/// `echomap diff`: what changed between two maps of one room.
struct DiffOptions {
  std::filesystem::path before;   ///< Run directory.
  std::filesystem::path after;    ///< Run directory.
  std::filesystem::path picture;  ///< Empty: none.
  std::filesystem::path json;     ///< Empty: none; "-": stdout.
};
ExitCode run_diff(const DiffOptions& options);

/// `echomap characterise`: how a sonar's cone opens and its ranges are off, from its own sweeps.
struct CharacteriseOptions {
  std::vector<std::filesystem::path> logs;  ///< Of one sonar; or run directories.
  std::string format;                       ///< Empty: what a log plainly says.
  /// What a range is thought to be off by; no wall fits worse by far.
  double range_stddev_m = 0.01;
  std::filesystem::path json;  ///< Empty: none; "-": stdout.
};
ExitCode run_characterise(const CharacteriseOptions& options);

/// `echomap flash`: writes the firmware to a board.
struct FlashOptions {
  std::string board;             ///< Empty: what the USB id of the port says.
  std::string port;              ///< Empty: the one board here that its USB id gives away.
  std::optional<int> baud;       ///< Of the board's image of this build; none: the usual one.
  std::filesystem::path image;   ///< Empty: the board's image of this build.
  std::string host;              ///< Of an EV3, USER@NAME; empty: that of ev3dev.
  std::filesystem::path volume;  ///< Of a Pico's boot loader; empty: the one that is mounted.
  std::filesystem::path uf2;     ///< Only write the Pico's image to this file; empty: flash.
  bool dry_run = false;
};
ExitCode run_flash(const FlashOptions& options);

/// `echomap ports`: lists serial ports, and who may be there.
struct PortsOptions {
  std::filesystem::path json;  ///< Empty: none; "-": stdout.
  std::string forget;          ///< Name of a port; empty: none.
  bool forget_all = false;
  bool print_rules = false;
  bool install_rules = false;
  std::filesystem::path rules_folder = "/etc/udev/rules.d";
  std::filesystem::path sysfs = "/sys";  ///< Where Linux shows its devices.
};
ExitCode run_ports(const PortsOptions& options);

/// `echomap fleet replay`: localizes the robots of recorded logs jointly.
struct FleetReplayOptions {
  std::filesystem::path folder;
  std::vector<std::int64_t> blind;  ///< Robots whose sightings of landmarks are left out.
  std::filesystem::path out;        ///< Empty: a stamped folder below the user's data folder.
  std::filesystem::path json;       ///< Empty: none; "-": stdout.
  bool force = false;               ///< Overwrite a run that `out` has in it.
  bool headless = false;
};
ExitCode run_fleet_replay(const FleetReplayOptions& options);

/// `echomap fleet join`: drives the robot on a port as a member of a fleet.
struct FleetJoinOptions {
  RunOptions run;
  session::ConnectionOptions connection;
  std::filesystem::path as;  ///< Credentials of the member.
  /// All robots of a simulated fleet that works in rounds; empty: in real time.
  std::vector<std::string> rounds_with;
  /// Where others started, as this one's map has it: NAME,X,Y,DEGREES each.
  std::vector<std::string> knows;
  bool search = false;   ///< Search a source, in place of making a map.
  double max_s = 900.0;  ///< Robot time after which a search ends unsure.
};
ExitCode run_fleet_join(const FleetJoinOptions& options);

/// `echomap fleet start`: a broker and simulated robots of one world that explore it together.
struct FleetStartOptions {
  RunOptions run;
  LiveOptions live;
  session::SimulatedRobotOptions robot;
  bool tls = false;
  bool search = false;   ///< Search a source, in place of making a map.
  double max_s = 900.0;  ///< Robot time after which a search ends unsure.
};
ExitCode run_fleet_start(const FleetStartOptions& options);

/// `echomap paper`: repeats the experiments of a paper and writes a report.
struct PaperOptions {
  std::string number;  ///< Of the paper, such as "000".
  std::uint32_t seed = 1;
  std::size_t runs = 20;  ///< Of each experiment with a random outcome.
  std::filesystem::path out;
  bool force = false;
  std::filesystem::path json;  ///< Empty: none; "-": stdout.
  bool headless = false;
};
ExitCode run_paper(const PaperOptions& options);

/// `echomap fleet broker`: runs a broker for robots on other machines until Ctrl-C.
struct FleetBrokerOptions {
  std::string fleet = "fleet";
  std::vector<std::string> robots;  ///< Accounts beside those of the hub and of an observer.
  std::string address = "0.0.0.0";  ///< Where it listens: an address of this machine.
  std::uint16_t port = 8883;        ///< 0: one that is free.
  /// Names and addresses that robots' hosts have for this machine; the first is in their files.
  std::vector<std::string> host_names;
  std::filesystem::path bridge_as;  ///< Credentials of this site at its region's broker.
  std::filesystem::path out;        ///< The broker's folder.
};
ExitCode run_fleet_broker(const FleetBrokerOptions& options);

/// `echomap fleet status`: who is in a fleet and how far it has come.
struct FleetStatusOptions {
  std::filesystem::path as;    ///< Credentials of any member.
  double listen_s = 6.0;       ///< How long it listens.
  std::filesystem::path json;  ///< Empty: none; "-": stdout.
};
ExitCode run_fleet_status(const FleetStatusOptions& options);

/// `echomap fleet map`: the map that a fleet has made so far.
struct FleetMapOptions {
  std::filesystem::path as;  ///< Credentials of any member.
  double listen_s = 5.0;     ///< How long it listens.
  std::string of;            ///< In which robot's frame; empty: that of the largest map.
  std::string robot = RunOptions().robot;  ///< Profile of that robot.
  std::filesystem::path out;   ///< Empty: a stamped folder below the user's data folder.
  std::filesystem::path json;  ///< Empty: none; "-": stdout.
  bool force = false;
};
ExitCode run_fleet_map(const FleetMapOptions& options);

/// `echomap fleet record`: all that a fleet says, as one MCAP file.
struct FleetRecordOptions {
  std::filesystem::path as;   ///< Credentials of any member.
  std::filesystem::path out;  ///< The file.
  double for_s = 0.0;         ///< How long; 0: until Ctrl-C.
  bool force = false;
};
ExitCode run_fleet_record(const FleetRecordOptions& options);

}  // namespace echomap::apps
