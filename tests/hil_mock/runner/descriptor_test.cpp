// SPDX-License-Identifier: MIT
#include "hil_mock/runner/descriptor.hpp"

#include <array>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

namespace echomap::runner {
namespace {

TEST(Descriptor, ClosesWhatItOwns) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  Descriptor reader(ends[0], "pipe");
  {
    Descriptor writer(ends[1], "pipe");
    Descriptor moved(std::move(writer));
    EXPECT_TRUE(moved.is_open());
  }
  char byte = 0;
  EXPECT_EQ(::read(reader.number(), &byte, 1), 0) << "end of stream";
}

TEST(Descriptor, SaysWhatWasTriedAndWhy) {
  try {
    const Descriptor missing(::open("/no/such/file", O_RDONLY), "cannot open it");
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
    EXPECT_EQ(std::string(error.what()).rfind("cannot open it", 0), 0U);
  }
}

TEST(Descriptor, CanBeMadeNotToWait) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const Descriptor reader(ends[0], "pipe");
  const Descriptor writer(ends[1], "pipe");
  set_non_blocking(reader.number());
  char byte = 0;
  EXPECT_EQ(::read(reader.number(), &byte, 1), -1);
  EXPECT_EQ(errno, EAGAIN);
}

}  // namespace
}  // namespace echomap::runner
