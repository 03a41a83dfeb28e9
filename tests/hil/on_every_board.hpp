// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil/emulated_board.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"

namespace echomap::tests {

/// A test of a robot without a body, on the image that its parameter names.
class OnEveryBoard : public ::testing::TestWithParam<const char*> {
 protected:
  RobotSession robot{release_image(GetParam())};
};

/// The image of each board that a user flashes, to instantiate such tests with `image_label`.
inline auto every_board() { return ::testing::ValuesIn(flashed_images()); }

/// The same with every baud rate that there is an image for.
inline auto every_image() { return ::testing::ValuesIn(images_of_every_baud()); }

/// "echomap-uno-115200" as the end of a test's name: "uno_115200".
inline std::string label_of(const std::string& image) {
  std::string label = image.substr(std::string("echomap-").size());
  std::replace(label.begin(), label.end(), '-', '_');
  return label;
}

inline std::string image_label(const ::testing::TestParamInfo<const char*>& image) {
  return label_of(image.param);
}

}  // namespace echomap::tests
