// SPDX-License-Identifier: MIT
#include "host/slam/slam_methods.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/slam/ekf_slam.hpp"
#include "host/slam/multiscan_slam.hpp"
#include "host/slam/scan_slam.hpp"

namespace echomap::slam {

namespace {

/// What runs of earlier versions call it in their summaries.
constexpr std::string_view kOldMultiscan = "grid";

template <class Method>
std::unique_ptr<SlamMethod> make() {
  return std::make_unique<Method>();
}

}  // namespace

const std::vector<NamedSlam>& slam_methods() {
  static const std::vector<NamedSlam> all{{"ekf", make<EkfSlam>, true},
                                          {"multiscan", make<MultiscanSlam>, true},
                                          {"scan", make<ScanSlam>}};
  return all;
}

std::string renamed_slam_method(const std::string& name) {
  return name == kOldMultiscan ? "the method 'grid' is now called 'multiscan'" : "";
}

const NamedSlam& slam_by_name(std::string_view name) {
  const auto& all = slam_methods();
  const std::string_view today = name == kOldMultiscan ? "multiscan" : name;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NamedSlam& one) { return one.name == today; });
  if (found == all.end()) {
    throw std::invalid_argument("unknown SLAM method '" + std::string(name) + "'");
  }
  return *found;
}

}  // namespace echomap::slam
