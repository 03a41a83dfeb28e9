// SPDX-License-Identifier: MIT
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"

// The pages tell the sizes of the images that firmware/sizes.txt has, and ImageSizes holds.
namespace echomap::structure {
namespace {

using testing::HasSubstr;

struct ImageRow {
  std::string board;
  int flash_bytes = 0;
  int ram_bytes = 0;
};

std::vector<ImageRow> images_of_sizes_txt() {
  std::vector<ImageRow> images;
  for (const std::string& line : read_lines(tree_root / "firmware/sizes.txt")) {
    ImageRow image;
    std::istringstream words(line);
    if (std::string elf; words >> elf >> image.flash_bytes >> image.ram_bytes) {
      const std::string prefix = "echomap-";
      image.board = elf.substr(prefix.size(), elf.find('.') - prefix.size());
      images.push_back(image);
    }
  }
  return images;
}

/// 21974 as "21,974".
std::string with_comma(int bytes) {
  const std::string digits = std::to_string(bytes);
  return digits.substr(0, digits.size() - 3) + "," + digits.substr(digits.size() - 3);
}

std::string text_of(const std::string& page) {
  std::ifstream file(tree_root / page);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ImageSizesInDocs, AreThoseOfTheBuild) {
  const std::vector<ImageRow> images = images_of_sizes_txt();
  ASSERT_EQ(images.size(), 4U);
  for (const ImageRow& image : images) {
    const std::string own_page = "docs/hardware/" + image.board + ".md";
    for (const std::string& page :
         {std::string("docs/hardware/boards.md"), std::string("docs/measurements.md"), own_page}) {
      const std::string text = text_of(page);
      EXPECT_THAT(text, HasSubstr(with_comma(image.flash_bytes))) << "flash of " << image.board;
      EXPECT_THAT(text, HasSubstr(with_comma(image.ram_bytes))) << "RAM of " << image.board;
    }
  }
}

}  // namespace
}  // namespace echomap::structure
