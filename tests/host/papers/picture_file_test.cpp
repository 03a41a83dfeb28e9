// SPDX-License-Identifier: MIT
#include "host/papers/picture_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(PictureFile, IsWrittenIntoANewFolderAndReturned) {
  const tests::ScratchFolder folder;
  const exports::Picture picture(4, 3, {255, 255, 255});
  const auto bytes = write_picture(picture, folder / "sub/picture.png");
  ASSERT_GT(bytes.size(), 8U);
  EXPECT_EQ(bytes[1], 'P');
  EXPECT_EQ(bytes.size(), file_size(folder / "sub/picture.png"));
}

}  // namespace
}  // namespace echomap::papers
