// SPDX-License-Identifier: MIT
#include "firmware/boards/native/program_memory.hpp"

#include <gtest/gtest.h>

#include "firmware/hal/encoders.hpp"

namespace echomap::native {
namespace {

TEST(ProgramMemory, PutsBackWhatTheProgramKnew) {
  app::devices.work_waits = true;
  boards::start_edge_count(0);
  boards::count_edges(1);
  boards::fold_edges();
  boards::count_edges(3);
  ASSERT_EQ(hal::read_encoders().left, 2);
  const ProgramMemory memory = ProgramMemory::copy();
  app::devices.work_waits = false;
  boards::start_edge_count(0);
  ASSERT_EQ(hal::read_encoders().left, 0);
  memory.restore();
  EXPECT_TRUE(app::devices.work_waits);
  EXPECT_EQ(hal::read_encoders().left, 2);
  boards::count_edges(2);
  EXPECT_EQ(hal::read_encoders().left, 3) << "it goes on from the levels that it had";
}

}  // namespace
}  // namespace echomap::native
