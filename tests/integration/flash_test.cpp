// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/host/flashing/brick_program.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// echomap flash, with an avrdude before the real one in PATH that would leave a trace.
class Flash : public ::testing::Test {
 protected:
  Flash() {
    std::ofstream(scratch / "avrdude") << "#!/bin/sh\necho avrdude ran\n";
    fs::permissions(scratch / "avrdude", fs::perms::owner_all);
    ::setenv("PATH", (scratch.path().string() + ":" + program_path).c_str(), 1);
  }
  ~Flash() override { ::setenv("PATH", program_path.c_str(), 1); }

  Ended flash(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "flash");
    return Program("echomap", std::move(arguments), scratch / "log").wait();
  }

  const tests::ScratchFolder scratch;
  const std::string program_path = std::getenv("PATH");
};

/// Even where a robot answers at it: it hangs on no USB.
TEST_F(Flash, LeavesThePtyOfAnEmulatedRobotAlone) {
  const std::string link = (scratch / "robot").string();
  Program mock("echomap-mock", {"--link=" + link}, scratch / "mock.log");
  ASSERT_TRUE(eventually([&] { return fs::exists(link); }));
  for (const std::string& port : {link, fs::canonical(link).string()}) {
    const Ended ended = flash({"--board=uno", "--port=" + port});
    EXPECT_EQ(ended.status, 3) << ended.said;
    EXPECT_THAT(ended.said,
                AllOf(HasSubstr("will not flash " + port + " (no USB id)"),
                      HasSubstr("next: "),
                      Not(HasSubstr("avrdude ran"))));
  }
  mock.send(SIGTERM);
}

TEST_F(Flash, RefusesABoardThatItDoesNotKnow) {
  const Ended ended = flash({"--board=due"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.said, HasSubstr("valid here: uno, nano, mega"));
}

/// The image of an RP2040 that this test makes: a boot stage with its checksum, and vectors.
std::string pico_image() {
  std::string image(3000, '\0');
  const std::string checksum = "\x9a\x39\x65\x70";
  image.replace(252, 4, checksum);
  image.replace(256, 8, std::string("\x00\x00\x04\x20\x01\x02\x00\x10", 8));
  return image;
}

TEST_F(Flash, CopiesAPicosImageToTheDriveThatIsNamed) {
  files::write_text_file(scratch / "pico.bin", pico_image());
  fs::create_directory(scratch / "drive");
  const std::vector<std::string> words{"--board=pico",
                                       "--image=" + (scratch / "pico.bin").string(),
                                       "--volume=" + (scratch / "drive").string()};
  const Ended refused = flash(words);
  EXPECT_EQ(refused.status, 3);
  EXPECT_THAT(refused.said, HasSubstr("is no drive of a Pico"));

  files::write_text_file(scratch / "drive" / "INFO_UF2.TXT", "Board-ID: RPI-RP2\n");
  const Ended ended = flash(words);
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_EQ(fs::file_size(scratch / "drive" / "pico.uf2"), 16 * 512U);
}

TEST_F(Flash, WritesAPicosImageAsAFileToDrag) {
  files::write_text_file(scratch / "pico.bin", pico_image());
  const std::string uf2 = (scratch / "to_drag.uf2").string();
  const Ended ended =
      flash({"--board=pico", "--image=" + (scratch / "pico.bin").string(), "--uf2=" + uf2});
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_EQ(files::read_text_file(uf2).substr(0, 4), "UF2\n");
  EXPECT_THAT(ended.said, HasSubstr("next: hold the button BOOTSEL"));
  files::write_text_file(scratch / "uno.hex", ":100000000C9434000C943E000C943E000C943E0082\n");
  const Ended refused = flash({"--board=pico", "--image=" + (scratch / "uno.hex").string()});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.said, HasSubstr("too few for a boot stage"));
}

TEST_F(Flash, WritesNoFileToDragInADryRunNorWhereItMayNot) {
  files::write_text_file(scratch / "pico.bin", pico_image());
  const std::string image = (scratch / "pico.bin").string();
  const std::string uf2 = (scratch / "to_drag.uf2").string();
  const Ended dry = flash({"--board=pico", "--image=" + image, "--uf2=" + uf2, "--dry-run"});
  EXPECT_EQ(dry.status, 0);
  EXPECT_EQ(dry.said, "echomap flash --board pico --image " + image + " --uf2 " + uf2 + "\n");
  EXPECT_FALSE(fs::exists(uf2));
  const std::string nowhere = (scratch / "no_folder" / "x.uf2").string();
  const Ended refused = flash({"--board=pico", "--image=" + image, "--uf2=" + nowhere});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.said, AllOf(HasSubstr("cannot create " + nowhere), HasSubstr("\n  next: ")));
}

/// ssh and scp before the real ones in PATH: no host is ever asked.
TEST_F(Flash, CopiesAnEv3sProgramByScpAndStartsIt) {
  for (const char* name : {"ssh", "scp"}) {
    std::ofstream(scratch / name) << "#!/bin/sh\necho \"ran: " << name << " $*\"\n";
    fs::permissions(scratch / name, fs::perms::owner_all);
  }
  files::write_text_file(scratch / "ev3.elf", flashing::brick_program());
  const std::string image = "--image=" + (scratch / "ev3.elf").string();
  const Ended dry = flash({"--board=ev3", image, "--host=robot@10.0.0.7", "--dry-run"});
  EXPECT_EQ(dry.status, 0);
  EXPECT_THAT(dry.said, AllOf(HasSubstr("scp -o ConnectTimeout=10"), Not(HasSubstr("ran: "))));
  const Ended ended = flash({"--board=ev3", image, "--host=robot@10.0.0.7"});
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said,
              HasSubstr("ran: scp -o ConnectTimeout=10 " + (scratch / "ev3.elf").string() +
                        " robot@10.0.0.7:"));
  EXPECT_THAT(ended.said, HasSubstr("--port tcp://10.0.0.7:8375"));
}

TEST_F(Flash, TakesThePortFromTheEnvironment) {
  ::setenv("ECHOMAP_PORT", "/dev/null", 1);
  const Ended ended = flash({"--board=nano"});
  ::unsetenv("ECHOMAP_PORT");
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said, HasSubstr("will not flash /dev/null"));
}

}  // namespace
}  // namespace echomap::test
