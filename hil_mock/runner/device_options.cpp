// SPDX-License-Identifier: MIT
#include "hil_mock/runner/device_options.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>

#include "hil_mock/world/motor_driver.hpp"
#include "hil_mock/world/noise.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::runner {
namespace {

constexpr double kEndlessS = std::numeric_limits<double>::infinity();

/// Paced time would overflow far above it, and no machine comes near.
constexpr double kFastest = 1e6;

/// Simulated time beyond it would overflow; no run is so long.
constexpr double kLongestS = 1e9;
constexpr std::size_t kKidnapNumbers = 5;

constexpr std::size_t kMaxRobots = 16;
/// What `--starts` is for the seed to choose.
constexpr const char* kDrawn = "drawn";
constexpr unsigned kLastPort = 65535;

/// Texts and numbers as they stand on the command line, before they are understood.
struct RawOptions {
  std::string speed = "1";
  std::vector<double> start;
  std::string starts;
  std::vector<double> kidnaps;
  std::string faults;
  std::string part_faults;
  std::string camera_params;
  std::string line = "direct";
};

std::string check_speed(const std::string& text) {
  double speed = 0.0;
  const bool valid =
      text == "max" || (CLI::detail::lexical_cast(text, speed) && speed > 0.0 && speed <= kFastest);
  return valid ? "" : "it must be a positive number up to 1e6, or max";
}

std::string check_finite(const std::string& text) {
  double number = 0.0;
  return CLI::detail::lexical_cast(text, number) && std::isfinite(number) ? ""
                                                                          : "it must be a number";
}

std::string check_faults(const std::string& text) {
  try {
    line_faults::parse_line_faults(text);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::string part_faults_help() {
  std::string names;
  for (const std::string& name : world::part_fault_names()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

std::string check_part_faults(const std::string& text) {
  try {
    world::parse_part_faults(text);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::string check_camera(const std::string& text) {
  try {
    parse_camera(text);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

Kidnap read_kidnap(const double* numbers) {
  const double placed_s = numbers[0] + numbers[1];
  return {std::llround(numbers[0] * 1e9),
          std::llround(placed_s * 1e9),
          {numbers[2], numbers[3], geometry::radians(numbers[4])}};
}

/// Throws CLI::ValidationError where times are none, overlap or are out of order.
std::vector<Kidnap> read_kidnaps(const std::vector<double>& numbers) {
  std::vector<Kidnap> kidnaps;
  for (std::size_t i = 0; i < numbers.size(); i += kKidnapNumbers) {
    const double earliest_s =
        kidnaps.empty() ? 0.0 : static_cast<double>(kidnaps.back().place_ns) * 1e-9;
    if (i + kKidnapNumbers > numbers.size() || numbers[i] < earliest_s || numbers[i] > kLongestS ||
        numbers[i + 1] <= 0.0 || numbers[i + 1] > kLongestS) {
      throw CLI::ValidationError("--kidnap",
                                 "it takes AT_S,HELD_S,X_M,Y_M,HEADING_DEG, one after the other");
    }
    kidnaps.push_back(read_kidnap(&numbers[i]));
  }
  return kidnaps;
}

void add_board_options(CLI::App& app, DeviceOptions& options, const DeviceProgram& program) {
  if (program.boards.empty()) {
    return;
  }
  options.board.board = program.boards.front();
  auto* board = app.add_option("--board", options.board.board, "Run this board's firmware")
                    ->check(CLI::IsMember(program.boards))
                    ->capture_default_str();
  app.add_option("--firmware", options.board.firmware, "Run this ELF, on the board that it is for")
      ->check(CLI::ExistingFile)
      ->excludes(board);
}

void add_line_faults(CLI::App& app, RawOptions& raw) {
  app.add_option(
         "--faults",
         raw.faults,
         "Faults of the line, for each byte: flip=R,drop=R,insert=R,burst=R,cut=R; for each frame: "
         "loss=R; away=AT_S:FOR_S for a while without any; and seed=N, by default that of --seed")
      ->check(check_faults);
  app.add_option("--line", raw.line, "Serial line, with the modelled delays of an adapter")
      ->check(CLI::IsMember({"direct", "usb", "ftdi", "bluetooth"}))
      ->capture_default_str();
}

/// "x,y,deg;x,y,deg" in metres and degrees. Throws std::invalid_argument.
std::vector<geometry::Pose2> parse_starts(const std::string& text) {
  std::vector<geometry::Pose2> starts;
  for (const std::string& one : CLI::detail::split(text, ';')) {
    std::array<double, 3> numbers{};
    const std::vector<std::string> words = CLI::detail::split(one, ',');
    for (std::size_t i = 0; i < words.size() && i < numbers.size(); ++i) {
      if (!CLI::detail::lexical_cast(words[i], numbers[i]) || !std::isfinite(numbers[i])) {
        throw std::invalid_argument("'" + words[i] + "' is no number");
      }
    }
    if (words.size() != numbers.size()) {
      throw std::invalid_argument("it takes X_M,Y_M,HEADING_DEG for each robot, with ; between");
    }
    starts.emplace_back(numbers[0], numbers[1], geometry::radians(numbers[2]));
  }
  return starts;
}

std::string check_starts(const std::string& text) {
  try {
    if (text != kDrawn) {
      parse_starts(text);
    }
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

void add_team_options(CLI::App& app, DeviceOptions& options, RawOptions& raw) {
  app.add_option("--robots",
                 options.robots,
                 "Robots in this world. Of several each has its own port, channel, seed and files: "
                 "LINK.0, TCP port + 0, SOCKET.0, TRUTH/robot0, ..")
      ->check(CLI::Range(std::size_t{1}, kMaxRobots))
      ->capture_default_str();
  app.add_option(
         "--starts",
         raw.starts,
         "Starts of all robots, x,y,heading in metres and degrees with ; between, or drawn: "
         "all by the seed. By default the first is the room's and the others are drawn")
      ->check(check_starts)
      ->excludes("--start");
  app.add_option("--apart", options.apart_m, "Metres of way between two starts that are drawn")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/// Where the robot stands, where it is carried, and who looks on.
void add_place_options(CLI::App& app, DeviceOptions& options, RawOptions& raw) {
  app.add_option("--start", raw.start, "Start x,y,heading in metres and degrees")
      ->delimiter(',')
      ->expected(3)
      ->check(check_finite);
  app.add_option("--kidnap",
                 raw.kidnaps,
                 "Lift the robot at AT_S, hold it for HELD_S, place it: "
                 "AT_S,HELD_S,X_M,Y_M,HEADING_DEG; may be repeated")
      ->delimiter(',')
      ->expected(kKidnapNumbers, 100 * kKidnapNumbers)
      ->check(check_finite);
  auto* camera = app.add_option("--camera",
                                options.camera,
                                "Send an overhead camera's pose measurements to udp:PORT of this "
                                "machine, or serve them on tcp:PORT");
  app.add_option(
         "--camera-params",
         raw.camera_params,
         "Parameters of the camera: rate=HZ,delay=S,jitter=S,noise=M,heading=DEG,drop=SHARE")
      ->check(check_camera)
      ->needs(camera);
}

void add_options(CLI::App& app,
                 DeviceOptions& options,
                 RawOptions& raw,
                 const DeviceProgram& program) {
  app.add_option("--world", options.world, "Room: a bundled name or a TOML file")
      ->capture_default_str();
  app.add_option("--robot", options.robot, "Robot: a bundled name or a TOML file")
      ->capture_default_str();
  app.add_option("--driver",
                 options.driver,
                 "Motor driver between board and motors, instead of the robot file's")
      ->check(CLI::IsMember(world::driver_names()));
  add_board_options(app, options, program);
  auto* link =
      app.add_option("--link", options.link, "Symbolic link to the pty")->capture_default_str();
  app.add_option("--tcp", options.tcp_port, "Serve a TCP port on 127.0.0.1 (0: a free one)")
      ->excludes(link);
  auto* lockstep =
      app.add_option("--lockstep", options.lockstep, "Socket on which a host grants the time");
  app.add_option("--speed", raw.speed, "Simulated seconds per second, or max")
      ->check(check_speed)
      ->capture_default_str()
      ->excludes(lockstep);
  app.add_option("--seed", options.seed, "Seed of every random generator")->capture_default_str();
  add_line_faults(app, raw);
  app.add_option("--part-faults",
                 raw.part_faults,
                 "Parts that fail or were put together wrongly, NAME@AT_S[:FOR_S[:VALUE]] with "
                 "commas between: " +
                     part_faults_help())
      ->check(check_part_faults);
  app.add_option("--truth",
                 options.truth,
                 "Folder for the truth files: of the room at the start, of all at the end");
  app.add_option("--duty-log",
                 options.duty_log,
                 "CSV file for when a wheel is driven and when no more: simulated time, "
                 "CLOCK_MONOTONIC, duties");
  app.add_option("--pin-log",
                 options.pin_log,
                 "CSV file for every change of a wire to a motor driver, with its simulated time");
  add_place_options(app, options, raw);
  add_team_options(app, options, raw);
  app.add_option("--duration", options.duration_s, "Simulated seconds after which to end")
      ->check(CLI::PositiveNumber)
      ->excludes(lockstep);
}

void understand(const RawOptions& raw, DeviceOptions& options) {
  options.speed = raw.speed == "max" ? kEndlessS : std::stod(raw.speed);
  options.line.faults = line_faults::parse_line_faults(raw.faults);
  if (raw.faults.find("seed=") == std::string::npos) {
    options.line.faults.seed = options.seed;
  }
  if (raw.line != "direct") {
    options.line.delays = line_faults::line_delays(raw.line);
  }
  if (!raw.start.empty()) {
    options.T_world_start =
        geometry::Pose2(raw.start[0], raw.start[1], geometry::radians(raw.start[2]));
  }
  options.draws_starts = raw.starts == kDrawn;
  if (!raw.starts.empty() && !options.draws_starts) {
    options.starts = parse_starts(raw.starts);
  }
  options.part_faults = world::parse_part_faults(raw.part_faults);
  options.kidnaps = read_kidnaps(raw.kidnaps);
  options.camera_params = parse_camera(raw.camera_params);
}

/// Throws CLI::ValidationError for what several robots cannot have.
void check_team(const DeviceOptions& options) {
  if (!options.starts.empty() && options.starts.size() != options.robots) {
    throw CLI::ValidationError("--starts", "it takes one start for each of --robots");
  }
  if (options.robots == 1) {
    return;
  }
  if (!options.kidnaps.empty() || !options.camera.empty() || !options.duty_log.empty() ||
      !options.pin_log.empty()) {
    throw CLI::ValidationError(
        "--robots", "--kidnap, --camera, --duty-log and --pin-log are of one robot alone");
  }
  if (options.tcp_port.value_or(0) + options.robots - 1 > kLastPort) {
    throw CLI::ValidationError("--tcp", "there are not so many ports behind it");
  }
}

}  // namespace

DeviceOptions options_of_robot(const DeviceOptions& options, std::size_t robot) {
  DeviceOptions own = options;
  if (options.robots == 1) {
    return own;
  }
  const auto number = static_cast<std::uint32_t>(robot);
  const std::string end = "." + std::to_string(robot);
  own.seed = world::seed_of(options.seed, number);
  own.line.faults.seed = world::seed_of(options.line.faults.seed, number);
  own.link += end;
  if (options.tcp_port.value_or(0) != 0) {
    own.tcp_port = static_cast<std::uint16_t>(*options.tcp_port + robot);
  }
  if (!options.lockstep.empty()) {
    own.lockstep += end;
  }
  if (!options.truth.empty()) {
    own.truth /= "robot" + std::to_string(robot);
  }
  return own;
}

std::variant<DeviceOptions, int> read_device_options(int argc,
                                                     char** argv,
                                                     const DeviceProgram& program) {
  DeviceOptions options;
  options.link = "/tmp/echomap-" + std::to_string(::getuid());
  options.duration_s = kEndlessS;
  options.robot = program.robot;
  RawOptions raw;
  CLI::App app("A simulated robot in a simulated room, behind a serial port.", program.name);
  app.set_version_flag("--version", program.name + " " ECHOMAP_VERSION);
  add_options(app, options, raw, program);
  try {
    app.parse(argc, argv);
    understand(raw, options);
    check_team(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return options;
}

}  // namespace echomap::runner
