// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/slam/slam_method.hpp"

namespace echomap::slam {

/// A SLAM method that is selected by name.
struct NamedSlam {
  std::string_view name;
  std::unique_ptr<SlamMethod> (*make)();  ///< Makes the method with its default settings.
  bool takes_cones = false;               ///< Whether it handles wide cones, or thin beams only.
};

/// All SLAM methods.
const std::vector<NamedSlam>& slam_methods();

/// What to write instead of a name that a method had in an earlier version; else empty.
std::string renamed_slam_method(const std::string& name);

/// Also finds a method by its name of an earlier version, as old summaries have it. Throws
/// std::invalid_argument for a name that no method has.
const NamedSlam& slam_by_name(std::string_view name);

}  // namespace echomap::slam
