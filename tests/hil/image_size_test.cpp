// SPDX-License-Identifier: MIT
#include "tests/hil/measure/image_size.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

/// Most of each, as the boards' CMakeLists.txt demand it of the build.
ImageSize budget_of(const std::string& image) {
  if (image.starts_with("echomap-mega")) {
    return {28'672, 2'048};
  }
  if (image.starts_with("echomap-pico")) {
    return {26'624, 1'536};
  }
  return image.starts_with("echomap-stm32") ? ImageSize{24'576, 2'048} : ImageSize{24'576, 1'200};
}

/// Of an image, as the page of sizes has it; of images without a row there, nothing.
std::optional<ImageSize> known_size(const std::string& image) {
  std::ifstream page(std::string(ECHOMAP_SOURCE_DIR) + "/firmware/sizes.txt");
  for (std::string line; std::getline(page, line);) {
    std::istringstream words(line);
    std::string name;
    ImageSize size;
    if (words >> name >> size.flash_bytes >> size.ram_bytes && name == image + ".elf") {
      return size;
    }
  }
  return std::nullopt;
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
  if (const auto known = known_size(GetParam())) {
    EXPECT_NEAR(double(size.flash_bytes), double(known->flash_bytes), 256.0)
        << "write what the build prints into firmware/sizes.txt";
    EXPECT_NEAR(double(size.ram_bytes), double(known->ram_bytes), 32.0)
        << "write what the build prints into firmware/sizes.txt";
  }
}

}  // namespace
}  // namespace echomap::tests
