// SPDX-License-Identifier: MIT
#include "tests/hil/measure/image_size.hpp"

#include <cstdint>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

/// Most of each, as the boards' CMakeLists.txt demand it of the build.
ImageSize budget_of(const std::string& image) {
  if (image.starts_with("echomap-mega")) {
    return {20'480, 2'048};
  }
  return image.starts_with("echomap-stm32") ? ImageSize{16'384, 2'048} : ImageSize{24'576, 1'200};
}

class ImageSizes : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Images, ImageSizes, every_image(), image_label);

TEST_P(ImageSizes, FitIntoTheBudget) {
  const ImageSize budget = budget_of(GetParam());
  const ImageSize size = size_of_image(release_image(GetParam()));
  std::printf("%s: %llu B flash, %llu B static RAM\n",
              GetParam(),
              static_cast<unsigned long long>(size.flash_bytes),
              static_cast<unsigned long long>(size.ram_bytes));
  RecordProperty("flash_bytes", std::to_string(size.flash_bytes));
  RecordProperty("static_ram_bytes", std::to_string(size.ram_bytes));
  EXPECT_GT(size.flash_bytes, 4'000U);
  EXPECT_LE(size.flash_bytes, budget.flash_bytes);
  EXPECT_GT(size.ram_bytes, 200U);
  EXPECT_LE(size.ram_bytes, budget.ram_bytes);
}

}  // namespace
}  // namespace echomap::tests
