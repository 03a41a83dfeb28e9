// SPDX-License-Identifier: MIT
#include "host/console/wait_for_enter.hpp"

#include <string_view>
#include <unistd.h>

#include <gtest/gtest.h>

namespace echomap::console {
namespace {

/// Stdin is the end of a pipe while it exists.
class TypedInput {
 public:
  explicit TypedInput(std::string_view text) : stdin_(::dup(STDIN_FILENO)) {
    int ends[2] = {-1, -1};
    EXPECT_EQ(::pipe(ends), 0);
    EXPECT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[0]);
  }
  ~TypedInput() {
    ::dup2(stdin_, STDIN_FILENO);
    ::close(stdin_);
  }
  TypedInput(const TypedInput&) = delete;
  TypedInput& operator=(const TypedInput&) = delete;

 private:
  int stdin_;
};

TEST(WaitForEnter, TakesALineEachTime) {
  const TypedInput input("\nand more\n");
  EXPECT_TRUE(wait_for_enter());
  EXPECT_TRUE(wait_for_enter());
  EXPECT_FALSE(wait_for_enter()) << "nobody is there any more";
}

}  // namespace
}  // namespace echomap::console
