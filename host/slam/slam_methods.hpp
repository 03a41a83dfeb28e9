// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "host/slam/slam_method.hpp"

namespace echomap::slam {

/// A way of doing SLAM that can be asked for by its name.
struct NamedSlam {
  std::string_view name;
  std::unique_ptr<SlamMethod> (*make)();  ///< With its one setting.
  bool takes_cones = false;               ///< Or thin beams alone.
};

/// All there are.
const std::vector<NamedSlam>& slam_methods();

/// Throws std::invalid_argument for a name that none has.
const NamedSlam& slam_by_name(std::string_view name);

}  // namespace echomap::slam
