// SPDX-License-Identifier: MIT
#include "host/transport/port_holder.hpp"

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// A folder like /proc.
class PortHolders : public testing::Test {
 protected:
  void add_process(int pid, const std::string& name, const std::string& words) {
    const fs::path process = folder / std::to_string(pid);
    fs::create_directories(process / "fd");
    files::write_text_file(process / "comm", name + "\n");
    files::write_text_file(process / "cmdline", words);
  }
  void add_descriptor(int pid, const std::string& device) {
    fs::create_symlink(device, folder / (std::to_string(pid) + "/fd/5"));
  }

  tests::ScratchFolder folder;
  const std::string device = "/dev/ttyUSB0";
};

TEST_F(PortHolders, AreTheProcessesThatHaveADescriptorOfThePort) {
  using namespace std::string_literals;
  add_process(41,
              "picocom",
              "picocom\0-b\0"
              "9600\0/dev/ttyUSB0\0"s);
  add_descriptor(41, device);
  add_process(42, "bash", "bash\0"s);
  add_descriptor(42, "/dev/ttyUSB1");
  add_process(::getpid(), "itself", "itself\0"s);
  add_descriptor(::getpid(), device);
  fs::create_directories(folder / "self/fd");
  const auto holders = port_holders(device, folder.path());
  ASSERT_EQ(holders.size(), 1U);
  EXPECT_EQ(in_words(holders[0]), "process 41 (picocom -b 9600 /dev/ttyUSB0)");
  EXPECT_TRUE(port_holders(device, folder / "nothing").empty());
}

TEST_F(PortHolders, AreNamedInLockFilesForAsLongAsTheyLive) {
  const std::string parent = std::to_string(::getppid());
  add_process(::getppid(), "minicom", "");
  const auto holder = [&] { return lock_file_holder(device, folder.path(), folder.path()); };
  const fs::path lock = folder / "LCK..ttyUSB0";
  EXPECT_FALSE(holder());
  files::write_text_file(lock, "      " + parent + " minicom root\n");
  ASSERT_TRUE(holder());
  EXPECT_EQ(in_words(*holder()), "process " + parent + " (minicom)");
  for (const char* stale : {"", "x", "-1", "0", "4194305\n"}) {
    files::write_text_file(lock, stale);
    EXPECT_FALSE(holder()) << stale;
  }
}

TEST_F(PortHolders, HaveARemedy) {
  EXPECT_THAT(remedy_against({7, "ModemManager", ""}, device), HasSubstr("ports --install-rules"));
  EXPECT_THAT(remedy_against({7, "brltty", ""}, device), HasSubstr("mask --now brltty"));
  EXPECT_THAT(remedy_against({7, "echomap", ""}, device), HasSubstr("Ctrl-C"));
  EXPECT_THAT(remedy_against({7, "picocom", ""}, device), HasSubstr("kill 7"));
}

TEST_F(PortHolders, AreFoundByName) {
  add_process(7, "brltty", "");
  ASSERT_TRUE(process_named("brltty", folder.path()));
  EXPECT_EQ(process_named("brltty", folder.path())->pid, 7);
  EXPECT_FALSE(process_named("ModemManager", folder.path()));
}

}  // namespace
}  // namespace echomap::transport
