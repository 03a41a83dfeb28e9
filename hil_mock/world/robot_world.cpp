// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_world.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"

namespace echomap::world {

namespace {

bool is_of_sonar(PartFaultKind kind) {
  switch (kind) {
    case PartFaultKind::kSonarDead:
    case PartFaultKind::kSonarStuck:
    case PartFaultKind::kPanReversed:
    case PartFaultKind::kPanOff:
    case PartFaultKind::kRangeScale:
    case PartFaultKind::kSonarHigh:
    case PartFaultKind::kSonarSlow:
      return true;
    default:
      return false;
  }
}

bool is_of_contacts(PartFaultKind kind) {
  return kind == PartFaultKind::kContactLeftBroken || kind == PartFaultKind::kContactRightBroken;
}

/// Empty where the robot has what the fault is of.
std::string missing_part(PartFaultKind kind, const RobotParams& robot) {
  if (is_of_sonar(kind) && !robot.has_sonar) {
    return "sonar";
  }
  if (is_of_contacts(kind) && !robot.body.has_bumpers) {
    return "bumpers";
  }
  return kind == PartFaultKind::kBatteryLow && !robot.parts.battery ? "battery" : "";
}

std::vector<PartFault> validated(std::vector<PartFault> faults, const RobotParams& robot) {
  for (const PartFault& fault : faults) {
    if (const std::string part = missing_part(fault.kind, robot); !part.empty()) {
      throw std::invalid_argument("part fault '" + std::string(name_of(fault.kind)) +
                                  "': the robot has no " + part);
    }
  }
  return faults;
}

}  // namespace

RobotWorld::RobotWorld(FloorPlan plan,
                       const RobotParams& robot,
                       std::uint32_t seed,
                       std::vector<PartFault> faults)
    : plan_(std::move(plan)),
      robot_(robot),
      body_(plan_, robot.drive, robot.body, NoiseStream(seed, NoisePurpose::kBody)),
      sonar_(plan_, robot.sonar),
      sonar_noise_(seed, NoisePurpose::kSonar),
      places_(seed, NoisePurpose::kPlaces),
      dirt_(seed, NoisePurpose::kEncoderDirt),
      parts_(plan_, body_, robot.parts, seed),
      faults_(validated(std::move(faults), robot)) {
  for (const PersonParams& person : plan_.people()) {
    people_.emplace_back(person);
  }
}

void RobotWorld::step(double dt_s, const WheelDuty& duty, EncoderChanges& changes) {
  now_s_ += dt_s;
  move_people(dt_s);
  apply_body_faults();
  const std::size_t left_before = changes.left.size();
  const std::size_t right_before = changes.right.size();
  body_.step(dt_s, wired(duty), changes);
  soil(PartFaultKind::kEncoderLeftDirty, left_before, changes.left);
  soil(PartFaultKind::kEncoderRightDirty, right_before, changes.right);
  wire(changes);
  if (const auto share = fault(PartFaultKind::kBatteryLow)) {
    parts_.drain_battery_to(*share);
  }
  parts_.step(dt_s, duty);
}

void RobotWorld::apply_body_faults() {
  const auto rolling = [&](PartFaultKind slip, PartFaultKind wheel) {
    return (1.0 - fault(slip).value_or(0.0)) * fault(wheel).value_or(1.0);
  };
  body_.scale_rolling({rolling(PartFaultKind::kSlipLeft, PartFaultKind::kWheelLeft),
                       rolling(PartFaultKind::kSlipRight, PartFaultKind::kWheelRight)});
  body_.scale_counts(fault(PartFaultKind::kCounts).value_or(1.0));
}

WheelDuty RobotWorld::wired(WheelDuty duty) const {
  if (has_fault(PartFaultKind::kMotorsSwapped)) {
    std::swap(duty.left, duty.right);
    std::swap(duty.left_coasting, duty.right_coasting);
  }
  return {has_fault(PartFaultKind::kMotorLeftReversed) ? -duty.left : duty.left,
          has_fault(PartFaultKind::kMotorRightReversed) ? -duty.right : duty.right,
          duty.left_coasting,
          duty.right_coasting};
}

void RobotWorld::soil(PartFaultKind dirt, std::size_t first, std::vector<LevelChange>& wheel) {
  if (const auto share = fault(dirt)) {
    const auto is_late = [&](const LevelChange&) { return dirt_.uniform() < *share; };
    const auto begin = wheel.begin() + static_cast<std::ptrdiff_t>(first);
    wheel.erase(std::remove_if(begin, wheel.end(), is_late), wheel.end());
  }
}

Contacts RobotWorld::closed_contacts() const {
  const Contacts pressed = contacts();
  const bool at_rest = robot_.body.has_bumpers && robot_.body.contacts_normally_closed;
  return {pressed.left != at_rest && !has_fault(PartFaultKind::kContactLeftBroken),
          pressed.right != at_rest && !has_fault(PartFaultKind::kContactRightBroken)};
}

void RobotWorld::wire(EncoderChanges& changes) const {
  const auto wire_one = [&](PartFaultKind dead, PartFaultKind reversed, auto& wheel) {
    if (has_fault(dead)) {
      wheel.clear();
    }
    if (has_fault(reversed)) {
      for (LevelChange& change : wheel) {
        std::swap(change.a, change.b);
      }
    }
  };
  wire_one(PartFaultKind::kEncoderLeft, PartFaultKind::kEncoderLeftReversed, changes.left);
  wire_one(PartFaultKind::kEncoderRight, PartFaultKind::kEncoderRightReversed, changes.right);
  if (has_fault(PartFaultKind::kEncodersSwapped)) {
    std::swap(changes.left, changes.right);
  }
}

void RobotWorld::move_people(double dt_s) {
  if (people_.empty()) {
    return;
  }
  std::vector<Disc> robots{{T_world_robot().position_m(), robot_.body.radius_m}};
  robots.insert(robots.end(), plan_.robots().begin(), plan_.robots().end());
  std::vector<Disc> places;
  for (Person& person : people_) {
    person.step(dt_s, now_s_, robots);
    if (const auto place = person.place()) {
      places.push_back(*place);
    }
  }
  plan_.put_people(places);
}

void RobotWorld::place(const geometry::Pose2& T_world_robot) {
  body_.place(T_world_robot);
  parts_.forget_heading();
}

bool RobotWorld::fits(const Eigen::Vector2d& place_m, double clearance_m) const {
  const double room_m = robot_.body.radius_m + clearance_m;
  const auto is_clear = [&](const Disc& peer) {
    return (place_m - peer.middle_m).norm() >= peer.radius_m + room_m;
  };
  return plan_.is_free(place_m) && plan_.clearance_m(place_m) >= room_m &&
         std::ranges::all_of(plan_.robots(), is_clear);
}

std::optional<Disc> RobotWorld::hull() const {
  if (body_.is_lifted()) {
    return std::nullopt;
  }
  return Disc{T_world_robot().position_m(), robot_.body.radius_m};
}

bool RobotWorld::is_clear_of(const Polygon& box_m, const Eigen::Vector2d& place_m) const {
  constexpr double kHandM = 0.08;
  return !geometry::contains(box_m, place_m) &&
         geometry::distance_to_sides_m(box_m, place_m) >= robot_.body.radius_m + kHandM;
}

geometry::Pose2 RobotWorld::somewhere_else() {
  constexpr int kTries = 1000;
  constexpr double kClearanceM = 0.05;
  constexpr double kFarM = 1.0;
  Eigen::AlignedBox2d room;
  for (const Eigen::Vector2d& corner_m : plan_.room_m()) {
    room.extend(corner_m);
  }
  geometry::Pose2 farthest = T_world_robot();
  double distance_m = 0.0;
  for (int i = 0; i < kTries && distance_m < kFarM; ++i) {
    const Eigen::Vector2d share(places_.uniform(), places_.uniform());
    const Eigen::Vector2d place_m = room.min() + share.cwiseProduct(room.sizes());
    const double heading_rad = 2.0 * std::numbers::pi * places_.uniform();
    const double away_m = (place_m - T_world_robot().position_m()).norm();
    if (away_m > distance_m && fits(place_m, kClearanceM)) {
      farthest = {place_m.x(), place_m.y(), heading_rad};
      distance_m = away_m;
    }
  }
  return farthest;
}

double RobotWorld::echo_pulse_s(std::optional<double> flight_s) const {
  // HC-SR04: without an answer it lets the echo pin go after this.
  constexpr double kNoEchoS = 0.038;
  constexpr double kForeverS = 1e5;
  if (has_fault(PartFaultKind::kSonarHigh)) {
    return kForeverS;
  }
  return flight_s ? *flight_s : fault(PartFaultKind::kSonarSlow).value_or(kNoEchoS);
}

std::optional<double> RobotWorld::ping(double pan_rad) {
  auto range_m = sonar_.ping_m(T_world_sonar(pan_rad), sonar_noise_);
  if (const auto stuck_m = fault(PartFaultKind::kSonarStuck)) {
    range_m = stuck_m;
  }
  if (!range_m || sonar_is_dead()) {
    return std::nullopt;
  }
  return fault(PartFaultKind::kRangeScale).value_or(1.0) * 2.0 * *range_m /
         robot_.sonar.speed_of_sound_m_per_s;
}

geometry::Pose2 RobotWorld::T_world_sonar(double pan_rad) const {
  const double turned_rad = has_fault(PartFaultKind::kPanReversed) ? -pan_rad : pan_rad;
  const double off_rad = geometry::radians(fault(PartFaultKind::kPanOff).value_or(0.0));
  return T_world_robot() *
         geometry::Pose2(robot_.sonar.mount_x_m, robot_.sonar.mount_y_m, turned_rad + off_rad);
}

}  // namespace echomap::world
