// SPDX-License-Identifier: MIT
#include "hil_mock/world/part_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "hil_mock/world/toml_values.hpp"
#include "host/files/nearest_word.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

constexpr double kMaxMountM = 1.0;

/// Boards that a robot may carry, by the names of their firmware's images.
constexpr std::array kBoards = {"native", "uno", "mega", "stm32f103", "pico"};

constexpr std::array<std::pair<const char*, IrKind>, 3> kIrKinds = {
    {{"gp2y0a21", IrKind::kGp2y0a21},
     {"epuck", IrKind::kEpuck},
     {"create_wall", IrKind::kCreateWall}}};

constexpr std::array<std::pair<const char*, ScalarSensorKind>, 2> kScalarSensorKinds = {
    {{"geiger", ScalarSensorKind::kGeiger}, {"light", ScalarSensorKind::kLight}}};

constexpr std::array<std::pair<const char*, CliffPlace>, 4> kCliffPlaces = {
    {{"left", CliffPlace::kLeft},
     {"front_left", CliffPlace::kFrontLeft},
     {"front_right", CliffPlace::kFrontRight},
     {"right", CliffPlace::kRight}}};

/// The value that the word at `key` names; `words` are all that there are.
template <class Value, std::size_t count>
Value named(const files::TomlReader& table,
            std::string_view key,
            const std::array<std::pair<const char*, Value>, count>& words) {
  const std::string word = table.text(key);
  std::vector<std::string> names;
  for (const auto& [name, value] : words) {
    if (word == name) {
      return value;
    }
    names.emplace_back(name);
  }
  table.fail(key, "unknown word '" + word + "'" + files::suggestion(word, names));
}

double coordinate(const files::TomlReader& table, std::string_view key) {
  const double value_m = table.number(key);
  if (value_m < -kMaxMountM || value_m > kMaxMountM) {
    table.fail(key, "it must be within 1 m of the middle of the axle");
  }
  return value_m;
}

Eigen::Vector2d read_mount(const files::TomlReader& table) {
  return {coordinate(table, "x_m"), coordinate(table, "y_m")};
}

geometry::Pose2 read_pose(const files::TomlReader& table) {
  const Eigen::Vector2d mount_m = read_mount(table);
  return {mount_m.x(), mount_m.y(), geometry::radians(table.number("heading_deg"))};
}

std::vector<IrRangeParams> read_ranges(const files::TomlReader& file) {
  std::vector<IrRangeParams> ranges;
  for (const files::TomlReader& table : file.tables("range")) {
    const std::int64_t channel = table.integer("channel");
    const auto same = [&](const IrRangeParams& range) { return range.channel == channel; };
    if (channel < 0 || channel > 7 || std::any_of(ranges.begin(), ranges.end(), same)) {
      table.fail("channel", "channels are numbered 0 to 7, each once");
    }
    ranges.push_back({static_cast<int>(channel), named(table, "kind", kIrKinds), read_pose(table)});
  }
  return ranges;
}

std::vector<CliffParams> read_cliffs(const files::TomlReader& file) {
  std::vector<CliffParams> cliffs;
  for (const files::TomlReader& table : file.tables("cliff")) {
    const CliffPlace place = named(table, "place", kCliffPlaces);
    const auto same = [&](const CliffParams& cliff) { return cliff.place == place; };
    if (std::any_of(cliffs.begin(), cliffs.end(), same)) {
      table.fail("place", "there is another one at this place");
    }
    cliffs.push_back({place, read_mount(table)});
  }
  return cliffs;
}

WallSensorParams read_wall_sensor(const files::TomlReader& table) {
  return {read_pose(table), positive(table, "reach_m")};
}

BeamDetectorParams read_beam_detector(const files::TomlReader& table) {
  BeamDetectorParams detector;
  detector.mount_m = read_mount(table);
  detector.own_beam_reach_m = within(table, "own_beam_reach_m", 0.0, 10.0);
  detector.own_beam_half_angle_rad = angle(table, "own_beam_half_angle_deg", 0.0);
  return detector;
}

GyroParams read_gyro(const files::TomlReader& table) {
  GyroParams gyro;
  gyro.bias_stddev_deg_per_s =
      within(table, "bias_stddev_deg_per_s", gyro.bias_stddev_deg_per_s, 20.0);
  gyro.scale_stddev = within(table, "scale_stddev", gyro.scale_stddev, 0.1);
  gyro.bias_walk_deg_per_s_per_sqrt_s =
      within(table, "bias_walk_deg_per_s_per_sqrt_s", gyro.bias_walk_deg_per_s_per_sqrt_s, 10.0);
  gyro.noise_deg_per_s_per_sqrt_hz =
      within(table, "noise_deg_per_s_per_sqrt_hz", gyro.noise_deg_per_s_per_sqrt_hz, 1.0);
  return gyro;
}

BatteryParams read_battery(const files::TomlReader& table) {
  BatteryParams battery;
  battery.full_v = positive(table, "full_v");
  battery.empty_v = positive(table, "empty_v");
  if (battery.empty_v >= battery.full_v) {
    table.fail("empty_v", "it must be less than full_v");
  }
  battery.capacity_ah = positive(table, "capacity_ah");
  battery.resistance_ohm = within(table, "resistance_ohm", battery.resistance_ohm, 10.0);
  battery.idle_a = within(table, "idle_a", battery.idle_a, 10.0);
  battery.stall_a = within(table, "stall_a", battery.stall_a, 100.0);
  battery.no_load_a = within(table, "no_load_a", battery.no_load_a, 100.0);
  battery.divider = within(table, "divider", battery.divider, 1.0);
  battery.noise_mv = within(table, "noise_mv", battery.noise_mv, 1000.0);
  return battery;
}

StepperParams read_stepper(const files::TomlReader& table) {
  StepperParams stepper;
  stepper.half_steps_per_turn = table.number("half_steps_per_turn");
  if (stepper.half_steps_per_turn == 0.0) {
    table.fail("half_steps_per_turn", "it must not be 0");
  }
  stepper.max_half_steps_per_s = positive(table, "max_half_steps_per_s");
  return stepper;
}

ScalarSensorParams read_scalar_sensor(const files::TomlReader& table) {
  ScalarSensorParams sensor;
  sensor.kind = named(table, "kind", kScalarSensorKinds);
  sensor.mount_m = read_mount(table);
  sensor.sensitivity = positive(table, "sensitivity");
  if (sensor.kind == ScalarSensorKind::kLight) {
    sensor.dark_millivolts = within(table, "dark_millivolts", sensor.dark_millivolts, 5000.0);
    sensor.noise_millivolts = within(table, "noise_millivolts", sensor.noise_millivolts, 1000.0);
    return sensor;
  }
  sensor.dead_time_s = 1e-6 * within(table, "dead_time_us", 1e6 * sensor.dead_time_s, 1e6);
  sensor.pulse_s = 1e-6 * within(table, "pulse_us", 1e6 * sensor.pulse_s, 1e6);
  if (sensor.pulse_s <= 0.0 || sensor.dead_time_s <= sensor.pulse_s) {
    table.fail("dead_time_us", "it must be longer than pulse_us, which must be positive");
  }
  return sensor;
}

bool is_fitted_scalar(PinPart part, const PartParams& parts) {
  const PinPart of_robot = parts.scalar && parts.scalar->kind == ScalarSensorKind::kLight
                               ? PinPart::kScalarLevel
                               : PinPart::kScalarPulses;
  return parts.scalar.has_value() && part == of_robot;
}

bool is_fitted(PinPart part, const PartParams& parts) {
  if (part >= PinPart::kStepperA) {
    return parts.stepper.has_value();
  }
  if (part >= PinPart::kRange0) {
    const int channel = static_cast<int>(part) - static_cast<int>(PinPart::kRange0);
    return std::any_of(parts.ranges.begin(), parts.ranges.end(), [&](const IrRangeParams& range) {
      return range.channel == channel;
    });
  }
  if (part <= PinPart::kCliffRight) {
    const auto place = static_cast<CliffPlace>(part);
    return std::any_of(parts.cliffs.begin(), parts.cliffs.end(), [&](const CliffParams& cliff) {
      return cliff.place == place;
    });
  }
  return part == PinPart::kWheelDrop || is_fitted_scalar(part, parts) ||
         (part == PinPart::kVirtualWall && parts.beam_detector.has_value()) ||
         (part == PinPart::kWall && parts.wall.has_value()) ||
         (part == PinPart::kBattery && parts.battery.has_value());
}

/// "cliff_left", or "cliff_left high" where the part pulls its pin up to say yes.
PinWire read_wire(const files::TomlReader& table, std::string_view key, const PartParams& parts) {
  constexpr std::string_view kHigh = " high";
  std::string word = table.text(key);
  const bool active_high = word.ends_with(kHigh);
  if (active_high) {
    word.resize(word.size() - kHigh.size());
  }
  const auto part = pin_part_named(word);
  if (!part) {
    table.fail(key, "unknown part '" + word + "'" + files::suggestion(word, pin_part_names()));
  }
  if (!is_fitted(*part, parts)) {
    table.fail(key, "the robot has no " + word);
  }
  if (active_high && *part > PinPart::kWall) {
    table.fail(key, "only a part that says yes or no has a level for it");
  }
  return {*part, active_high};
}

PinWires read_wires(const files::TomlReader& table, const PartParams& parts) {
  PinWires wires;
  for (std::size_t pin = 0; pin < wires.size(); ++pin) {
    const std::string key = "pin_" + std::to_string(pin);
    if (!table.has(key)) {
      continue;
    }
    const PinWire wire = read_wire(table, key, parts);
    for (const auto& other : wires) {
      if (other && other->part == wire.part) {
        table.fail(key, "this part is wired to another pin");
      }
    }
    wires[pin] = wire;
  }
  return wires;
}

}  // namespace

PartParams read_parts(const files::TomlReader& file) {
  PartParams parts;
  parts.ranges = read_ranges(file);
  parts.cliffs = read_cliffs(file);
  if (file.has("wall_sensor")) {
    parts.wall = read_wall_sensor(file.table("wall_sensor"));
  }
  if (file.has("virtual_wall_sensor")) {
    parts.beam_detector = read_beam_detector(file.table("virtual_wall_sensor"));
  }
  if (file.has("gyro")) {
    parts.gyro = read_gyro(file.table("gyro"));
  }
  if (file.has("battery")) {
    parts.battery = read_battery(file.table("battery"));
  }
  if (file.has("stepper")) {
    parts.stepper = read_stepper(file.table("stepper"));
  }
  if (file.has("scalar_sensor")) {
    parts.scalar = read_scalar_sensor(file.table("scalar_sensor"));
  }
  return parts;
}

Wiring read_wiring(const files::TomlReader& file, const PartParams& parts) {
  Wiring wiring;
  if (!file.has("wiring")) {
    return wiring;
  }
  const files::TomlReader tables = file.table("wiring");
  for (const char* const board : kBoards) {
    if (tables.has(board)) {
      wiring.emplace(board, read_wires(tables.table(board), parts));
    }
  }
  return wiring;
}

}  // namespace echomap::world
