// SPDX-License-Identifier: MIT
#include "host/slam/slam_methods.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/slam/landmark_slam_by_beams.hpp"
#include "host/slam/multiscan_slam.hpp"
#include "host/slam/scan_slam.hpp"

namespace echomap::slam {

namespace {

template <class Method>
std::unique_ptr<SlamMethod> make() {
  return std::make_unique<Method>();
}

}  // namespace

const std::vector<NamedSlam>& slam_methods() {
  static const std::vector<NamedSlam> all{{"ekf", make<LandmarkSlamByBeams>, true},
                                          {"grid", make<MultiscanSlam>, true},
                                          {"scan", make<ScanSlam>}};
  return all;
}

const NamedSlam& slam_by_name(std::string_view name) {
  const auto& all = slam_methods();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NamedSlam& one) { return one.name == name; });
  if (found == all.end()) {
    throw std::invalid_argument("there is no SLAM by the name '" + std::string(name) + "'");
  }
  return *found;
}

}  // namespace echomap::slam
