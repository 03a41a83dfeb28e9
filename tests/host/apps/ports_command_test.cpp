// SPDX-License-Identifier: MIT
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/known_ports.hpp"
#include "host/transport/udev_rules.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/sysfs_tree.hpp"

namespace echomap::apps {
namespace {

using testing::HasSubstr;

/// A desk with a Nano, at which a robot has answered, a copy of it and a modem.
class PortsCommand : public testing::Test {
 protected:
  PortsCommand() {
    ::setenv("XDG_STATE_HOME", folder.path().c_str(), 1);
    sysfs.plug("ttyUSB0", {"1-1.2", {0x1a86, 0x7523}, "USB Serial"});
    sysfs.plug("ttyUSB1", {"1-1.3", {0x1a86, 0x7523}, "USB Serial"});
    sysfs.plug("ttyUSB2", {"1-1.4", {0x12d1, 0x1506}, "HUAWEI"});
    session::KnownPorts().remember(transport::list_ports(sysfs.root()).at(0));
    options.sysfs = sysfs.root();
    options.json = folder / "ports.json";
    options.rules_folder = folder.path();
  }
  ~PortsCommand() override { ::unsetenv("XDG_STATE_HOME"); }

  nlohmann::json listed() {
    EXPECT_EQ(run_ports(options), ExitCode::kOk);
    return nlohmann::json::parse(files::read_text_file(options.json)).at("ports");
  }

  tests::ScratchFolder folder;
  tests::SysfsTree sysfs{folder / "sys"};
  PortsOptions options;
};

TEST_F(PortsCommand, TellsRobotsFromPortsThatMayBeAndFromOthers) {
  const auto ports = listed();
  ASSERT_EQ(ports.size(), 3U);
  EXPECT_EQ(ports[0]["name"], "/dev/ttyUSB0");
  EXPECT_EQ(ports[0]["what"], "CH340");
  EXPECT_EQ(ports[0]["usb_path"], "1-1.2:1.0");
  EXPECT_EQ(ports[0]["robot_answered_before"], true);
  EXPECT_EQ(ports[1]["robot_answered_before"], false);
  EXPECT_EQ(ports[1]["may_be_robot"], true);
  EXPECT_EQ(ports[2]["may_be_robot"], false);
  EXPECT_EQ(ports[2]["what"], "HUAWEI");
}

TEST_F(PortsCommand, ForgetsAPortOnce) {
  options.forget = "/dev/ttyUSB0";
  EXPECT_EQ(listed()[0]["robot_answered_before"], false);
  EXPECT_THROW(run_ports(options), CommandError);
}

TEST_F(PortsCommand, ForgetsEveryPort) {
  options.forget_all = true;
  EXPECT_EQ(listed()[0]["robot_answered_before"], false);
}

TEST_F(PortsCommand, WritesTheRules) {
  options.install_rules = true;
  EXPECT_EQ(run_ports(options), ExitCode::kOk);
  EXPECT_EQ(files::read_text_file(folder / "60-echomap.rules"), transport::udev_rules());
  options.rules_folder = folder / "absent";
  try {
    run_ports(options);
    FAIL() << "it wrote them";
  } catch (const CommandError& error) {
    EXPECT_THAT(error.what(), HasSubstr("next: sudo "));
  }
}

}  // namespace
}  // namespace echomap::apps
