// SPDX-License-Identifier: MIT
#include "host/fleet_messages/conversions.hpp"

#include <cmath>

#include "host/fleet_messages/quantiser.hpp"

namespace echomap::fleet_messages {
namespace {

/// Of correlations.
constexpr double kMaxCorrelation = 127.0;
/// mm2 in m2.
constexpr double kSquareMillimetres = 1e6;

template <class M>
std::optional<M> message_if(bool fits, M&& message) {
  return fits ? std::optional<M>(std::forward<M>(message)) : std::nullopt;
}

ReadingRow to_row(Quantiser& quantiser, const slam::StopReading& reading) {
  const slam::OdometryMark& mark = reading.mark;
  ReadingRow row;
  row.T_odom_robot = quantiser.pose(mark.T_odom_robot);
  row.path_mm = quantiser.thousandths<std::int32_t>(mark.path_m);
  row.turn = quantiser.turn(mark.turn_rad);
  row.turned = quantiser.turn(mark.turned_rad);
  row.jumped_mm = quantiser.thousandths<std::int32_t>(mark.jumped_m);
  row.jumped = quantiser.turn(mark.jumped_rad);
  row.sonar_x_mm = quantiser.thousandths<std::int16_t>(reading.T_robot_sonar.x_m());
  row.sonar_y_mm = quantiser.thousandths<std::int16_t>(reading.T_robot_sonar.y_m());
  row.sonar_heading = quantiser.direction(reading.T_robot_sonar.heading_rad());
  row.range_mm = reading.range_m ? quantiser.range_mm(*reading.range_m) : ReadingRow::kNoRange;
  return row;
}

slam::StopReading to_reading(const ReadingRow& row) {
  slam::StopReading reading;
  reading.mark.T_odom_robot = to_pose(row.T_odom_robot);
  reading.mark.path_m = row.path_mm / 1000.0;
  reading.mark.turn_rad = kAngleUnitRad * row.turn;
  reading.mark.turned_rad = kAngleUnitRad * row.turned;
  reading.mark.jumped_m = row.jumped_mm / 1000.0;
  reading.mark.jumped_rad = kAngleUnitRad * row.jumped;
  reading.T_robot_sonar = {
      row.sonar_x_mm / 1000.0, row.sonar_y_mm / 1000.0, to_direction_rad(row.sonar_heading)};
  if (row.range_mm != ReadingRow::kNoRange) {
    reading.range_m = row.range_mm / 1000.0;
  }
  return reading;
}

std::vector<PoseRow> to_rows(Quantiser& quantiser, const std::vector<geometry::Pose2>& poses) {
  std::vector<PoseRow> rows;
  for (const geometry::Pose2& pose : poses) {
    rows.push_back(quantiser.pose(pose));
  }
  return rows;
}

std::int8_t to_correlation(Quantiser& quantiser, double covariance, double stddev_product) {
  const double correlation = stddev_product > 0.0 ? covariance / stddev_product : 0.0;
  return quantiser.nearest<std::int8_t>(kMaxCorrelation * std::clamp(correlation, -1.0, 1.0));
}

CovariancePart to_part(Quantiser& quantiser, const Eigen::Matrix3d& covariance) {
  const Eigen::Vector3d stddev = covariance.diagonal().cwiseSqrt();
  CovariancePart part;
  part.x_stddev_mm = quantiser.saturated<std::uint16_t>(1000.0 * stddev.x());
  part.y_stddev_mm = quantiser.saturated<std::uint16_t>(1000.0 * stddev.y());
  part.heading_stddev = quantiser.saturated<std::uint16_t>(stddev.z() / kAngleUnitRad);
  part.correlation_x_y = to_correlation(quantiser, covariance(0, 1), stddev.x() * stddev.y());
  part.correlation_x_heading = to_correlation(quantiser, covariance(0, 2), stddev.x() * stddev.z());
  part.correlation_y_heading = to_correlation(quantiser, covariance(1, 2), stddev.y() * stddev.z());
  return part;
}

}  // namespace

std::optional<SubmapMessage> to_message(const team_map::Submap& submap, std::uint16_t map_number) {
  Quantiser quantiser;
  SubmapMessage message;
  message.map_number = map_number;
  message.index = submap.index;
  message.begin_ms = quantiser.stamp_ms(submap.begin_s);
  message.end_ms = quantiser.stamp_ms(submap.end_s);
  for (const slam::StopReading& reading : submap.readings) {
    message.readings.push_back(to_row(quantiser, reading));
  }
  message.T_odom_way = to_rows(quantiser, submap.T_odom_way);
  for (const team_map::SubmapContact& contact : submap.contacts) {
    const int switches = (contact.left ? 1 : 0) + (contact.right ? 2 : 0);
    message.contacts.push_back(
        {quantiser.pose(contact.T_odom_robot), static_cast<std::uint8_t>(switches)});
  }
  return message_if(quantiser.fits(), std::move(message));
}

team_map::Submap to_submap(const SubmapMessage& message) {
  team_map::Submap submap;
  submap.index = message.index;
  submap.begin_s = static_cast<double>(message.begin_ms) / 1000.0;
  submap.end_s = static_cast<double>(message.end_ms) / 1000.0;
  for (const ReadingRow& row : message.readings) {
    submap.readings.push_back(to_reading(row));
  }
  submap.T_odom_way = to_poses(message.T_odom_way);
  for (const ContactRow& row : message.contacts) {
    submap.contacts.push_back(
        {to_pose(row.T_odom_robot), (row.switches & 1U) != 0, (row.switches & 2U) != 0});
  }
  return submap;
}

std::optional<team_map::Submap> quantised(const team_map::Submap& submap) {
  const auto message = to_message(submap, 0);
  return message ? std::optional(to_submap(*message)) : std::nullopt;
}

std::optional<GraphMessage> to_graph_message(const std::vector<geometry::Pose2>& T_map_submaps,
                                             const Eigen::Matrix3d& latest_covariance,
                                             std::uint16_t map_number) {
  Quantiser quantiser;
  GraphMessage message{
      map_number, to_part(quantiser, latest_covariance), to_rows(quantiser, T_map_submaps)};
  return message_if(quantiser.fits(), std::move(message));
}

std::vector<geometry::Pose2> to_poses(const std::vector<PoseRow>& rows) {
  std::vector<geometry::Pose2> poses;
  for (const PoseRow& row : rows) {
    poses.push_back(to_pose(row));
  }
  return poses;
}

std::optional<PoseMessage> to_message(const PoseEstimate& pose,
                                      double stamp_s,
                                      std::uint16_t map_number) {
  Quantiser quantiser;
  PoseMessage message{quantiser.stamp_ms(stamp_s),
                      map_number,
                      quantiser.pose(pose.T_map_robot),
                      to_part(quantiser, pose.covariance)};
  return message_if(quantiser.fits(), std::move(message));
}

PoseEstimate to_pose_estimate(const PoseMessage& message) {
  return {to_pose(message.T_map_robot), to_covariance(message.covariance)};
}

Eigen::Matrix3d to_covariance(const CovariancePart& part) {
  const Eigen::Vector3d stddev(
      part.x_stddev_mm / 1000.0, part.y_stddev_mm / 1000.0, kAngleUnitRad * part.heading_stddev);
  Eigen::Matrix3d correlations = Eigen::Matrix3d::Identity();
  correlations(0, 1) = correlations(1, 0) = part.correlation_x_y / kMaxCorrelation;
  correlations(0, 2) = correlations(2, 0) = part.correlation_x_heading / kMaxCorrelation;
  correlations(1, 2) = correlations(2, 1) = part.correlation_y_heading / kMaxCorrelation;
  return stddev.asDiagonal() * correlations * stddev.asDiagonal();
}

std::optional<ClaimMessage> to_message(const std::vector<team_exploration::Claim>& claims,
                                       std::uint16_t map_number) {
  Quantiser quantiser;
  ClaimMessage message;
  message.map_number = map_number;
  for (const team_exploration::Claim& claim : claims) {
    message.claims.push_back(
        {quantiser.thousandths<std::int32_t>(claim.at_m.x()),
         quantiser.thousandths<std::int32_t>(claim.at_m.y()),
         quantiser.saturated<std::uint32_t>(kSquareMillimetres * claim.utility),
         quantiser.thousandths<std::uint16_t>(claim.reach_m)});
    if (!claim.waits_for.empty()) {
      message.waits_for = {{claim.waits_for}};
    }
  }
  return message_if(quantiser.fits(), std::move(message));
}

std::vector<team_exploration::Claim> to_claims(const ClaimMessage& message,
                                               const std::string& robot) {
  std::vector<team_exploration::Claim> claims;
  const std::string waits_for = message.waits_for.empty() ? "" : message.waits_for.front().robot;
  for (const ClaimRow& row : message.claims) {
    claims.push_back({robot,
                      {row.x_mm / 1000.0, row.y_mm / 1000.0},
                      row.utility_mm2_per_s / kSquareMillimetres,
                      row.reach_mm / 1000.0,
                      waits_for});
  }
  return claims;
}

std::optional<SourceMessage> to_message(const SourceBatch& batch, std::uint16_t map_number) {
  if (batch.readings.empty()) {
    return std::nullopt;
  }
  Quantiser quantiser;
  SourceMessage message;
  message.map_number = map_number;
  message.submap_index = batch.submap_index;
  message.begin_ms = quantiser.stamp_ms(batch.readings.front().stamp_s);
  const double begin_s = static_cast<double>(message.begin_ms) / 1000.0;
  for (const SourceReading& reading : batch.readings) {
    message.readings.push_back({quantiser.thousandths<std::uint32_t>(reading.stamp_s - begin_s),
                                quantiser.pose(reading.T_odom_robot),
                                quantiser.thousandths<std::uint32_t>(reading.value),
                                quantiser.thousandths<std::uint32_t>(reading.dwell_s)});
  }
  return message_if(quantiser.fits(), std::move(message));
}

SourceBatch to_source_batch(const SourceMessage& message) {
  SourceBatch batch{message.submap_index, {}};
  for (const SourceRow& row : message.readings) {
    batch.readings.push_back({static_cast<double>(message.begin_ms + row.after_ms) / 1000.0,
                              to_pose(row.T_odom_robot),
                              row.value_milli / 1000.0,
                              row.dwell_ms / 1000.0});
  }
  return batch;
}

std::optional<SearchMessage> to_message(const SearchReport& report, std::uint16_t map_number) {
  Quantiser quantiser;
  SearchMessage message;
  message.map_number = map_number;
  message.verdict = static_cast<std::uint8_t>(report.verdict);
  message.probability_milli = quantiser.thousandths<std::uint16_t>(report.probability);
  message.x_mm = quantiser.thousandths<std::int32_t>(report.at_m.x());
  message.y_mm = quantiser.thousandths<std::int32_t>(report.at_m.y());
  message.strength_milli = quantiser.thousandths<std::uint32_t>(report.strength);
  for (const source_search::PlannedDwell& dwell : report.plan) {
    message.plan.push_back({quantiser.thousandths<std::int32_t>(dwell.at_m.x()),
                            quantiser.thousandths<std::int32_t>(dwell.at_m.y()),
                            quantiser.thousandths<std::uint32_t>(dwell.dwell_s)});
  }
  return message_if(quantiser.fits(), std::move(message));
}

SearchReport to_search_report(const SearchMessage& message) {
  SearchReport report{static_cast<source_search::SourceVerdict>(message.verdict),
                      message.probability_milli / 1000.0,
                      {message.x_mm / 1000.0, message.y_mm / 1000.0},
                      message.strength_milli / 1000.0,
                      {}};
  for (const DwellRow& row : message.plan) {
    report.plan.push_back({{row.x_mm / 1000.0, row.y_mm / 1000.0}, row.dwell_ms / 1000.0});
  }
  return report;
}

std::optional<AlignmentMessage> to_message(const std::vector<AlignedMap>& maps) {
  Quantiser quantiser;
  AlignmentMessage message;
  for (const AlignedMap& map : maps) {
    message.maps.push_back({map.robot,
                            map.map_number,
                            quantiser.pose(map.T_component_map),
                            to_rows(quantiser, map.T_component_submaps)});
  }
  return message_if(quantiser.fits(), std::move(message));
}

std::vector<AlignedMap> to_aligned_maps(const AlignmentMessage& message) {
  std::vector<AlignedMap> maps;
  for (const AlignedMapPart& part : message.maps) {
    maps.push_back({part.robot,
                    part.map_number,
                    to_pose(part.T_component_map),
                    to_poses(part.T_component_submaps)});
  }
  return maps;
}

std::optional<PresenceMessage> with_traits(PresenceMessage message, const RobotTraits& traits) {
  Quantiser quantiser;
  message.body_radius_mm = quantiser.thousandths<std::uint16_t>(traits.body_radius_m);
  message.beam_half_angle =
      quantiser.nearest<std::uint16_t>(traits.beam_half_angle_rad / kAngleUnitRad);
  return message_if(quantiser.fits(), std::move(message));
}

RobotTraits to_traits(const PresenceMessage& message) {
  return {message.body_radius_mm / 1000.0, kAngleUnitRad * message.beam_half_angle};
}

}  // namespace echomap::fleet_messages
