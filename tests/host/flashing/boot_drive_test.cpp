// SPDX-License-Identifier: MIT
#include "host/flashing/boot_drive.hpp"

#include <cerrno>
#include <chrono>
#include <string>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "tests/host/flashing/pico_image.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::flashing {
namespace {

namespace fs = std::filesystem;
using console::ExitCode;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const transport::UsbDevice waiting_pico{{0x2e8a, 0x0003}, "RP2 Boot", "E0C9"};
const transport::UsbDevice running_pico{{0x2e8a, 0x000a}, "echomap", "E661"};

/// Folders that look like drives, and a table of mounts.
class BootDrive : public testing::Test {
 protected:
  fs::path drive(const std::string& name, const std::string& board = "RPI-RP2") const {
    fs::create_directories(folder_ / name);
    files::write_text_file(
        folder_ / name / "INFO_UF2.TXT",
        "UF2 Bootloader v3.0\nModel: Raspberry Pi RP2\nBoard-ID: " + board + "\n");
    return folder_ / name;
  }
  /// The drives that are found in a table of mounts, of which "DIR" is the scratch folder.
  std::vector<fs::path> found_in(std::string mounts) const {
    for (std::size_t at = 0; (at = mounts.find("DIR", at)) != std::string::npos;) {
      mounts.replace(at, 3, folder_.path().string());
    }
    files::write_text_file(folder_ / "mounts", mounts);
    return mounted_boot_drives(folder_ / "mounts");
  }
  std::string refusal(const fs::path& named,
                      const std::vector<fs::path>& mounted,
                      const std::vector<transport::UsbDevice>& usb) const {
    try {
      return "no error, but: " + choose_boot_drive(named, mounted, usb).string();
    } catch (const console::CommandError& error) {
      EXPECT_EQ(error.code(), ExitCode::kNoRobot);
      return error.what();
    }
  }
  std::string failure_of_copy(const fs::path& to, const SyncFile& sync) const {
    try {
      copy_to_boot_drive(uf2, to, "echomap-pico.uf2", sync);
    } catch (const console::CommandError& error) {
      EXPECT_EQ(error.code(), ExitCode::kRuntimeError);
      return error.what();
    }
    return "";
  }

  const Bytes uf2 = uf2_of(pico_image(3000));
  const tests::ScratchFolder folder_;
};

TEST_F(BootDrive, IsFoundAmongTheMountsByWhatItSays) {
  drive("pico");
  drive("rp2350", "RP2350");
  drive("copy");
  EXPECT_THAT(found_in("/dev/sda1 / ext4 rw 0 0\n"
                       "/dev/sdb1 DIR/pico vfat rw,nosuid 0 0\n"
                       "/dev/sdc1 DIR/rp2350 vfat rw 0 0\n"
                       "/dev/sdd1 DIR/copy ext4 rw 0 0\n"
                       "/dev/sde1 DIR/gone vfat rw 0 0\n"
                       "\n"),
              ElementsAre(folder_ / "pico"));
}

TEST_F(BootDrive, IsFoundBelowAFolderWithABlankInItsName) {
  drive("my drives");
  EXPECT_THAT(found_in("/dev/sdb1 DIR/my\\040drives vfat rw 0 0\n"),
              ElementsAre(folder_ / "my drives"));
}

TEST_F(BootDrive, IsOneDriveWhereverElseItIsMounted) {
  drive("pico");
  drive("again");
  drive("another");
  EXPECT_THAT(found_in("/dev/sdb1 DIR/pico vfat rw 0 0\n"
                       "/dev/sdb1 DIR/again vfat rw 0 0\n"
                       "/dev/sdc1 DIR/another vfat rw 0 0\n"),
              ElementsAre(folder_ / "pico", folder_ / "another"));
}

TEST_F(BootDrive, IsTheOnlyOneOrTheOneThatIsNamed) {
  const fs::path one = drive("one");
  const fs::path two = drive("two");
  EXPECT_EQ(choose_boot_drive("", {one}, {}), one);
  EXPECT_EQ(choose_boot_drive(two, {one, two}, {}), two);
  EXPECT_THAT(refusal("", {one, two}, {}),
              AllOf(HasSubstr("several Picos"),
                    HasSubstr("here: " + one.string()),
                    HasSubstr("here: " + two.string()),
                    HasSubstr("next: name one of these drives with --volume")));
}

TEST_F(BootDrive, IsMissedWithTheStepThatHelps) {
  EXPECT_THAT(refusal("", {}, {}),
              AllOf(HasSubstr("no drive of a Pico (RPI-RP2) is mounted"),
                    HasSubstr("next: unplug the Pico, hold its button BOOTSEL")));
  EXPECT_THAT(refusal("", {}, {running_pico}),
              AllOf(HasSubstr("that runs its program"), HasSubstr("BOOTSEL")));
  EXPECT_THAT(refusal("", {}, {running_pico, waiting_pico}),
              AllOf(HasSubstr("in its boot loader is plugged in"), HasSubstr("udisksctl mount")));
}

TEST_F(BootDrive, IsNotAnyFolderThatIsNamed) {
  EXPECT_THAT(refusal(folder_.path(), {}, {}), HasSubstr("is no drive of a Pico"));
  EXPECT_THAT(refusal(drive("rp2350", "RP2350"), {}, {}), HasSubstr("is no drive of a Pico"));
}

TEST_F(BootDrive, GetsEveryByteAndIsWaitedFor) {
  const fs::path to = drive("pico");
  bool is_synced = false;
  const auto sync = [&](int descriptor) {
    is_synced = read_bytes(to / "echomap-pico.uf2") == uf2;
    return ::fsync(descriptor);
  };
  EXPECT_EQ(failure_of_copy(to, sync), "");
  EXPECT_TRUE(is_synced) << "synced before all was written";
}

TEST_F(BootDrive, ThatIsFullOrLockedIsAnError) {
  const fs::path to = drive("pico");
  fs::create_symlink("/dev/full", to / "echomap-pico.uf2");
  EXPECT_THAT(failure_of_copy(to, ::fsync),
              AllOf(HasSubstr("cannot write " + (to / "echomap-pico.uf2").string()),
                    HasSubstr("No space left"),
                    HasSubstr("next: ")));
  fs::remove(to / "echomap-pico.uf2");
  fs::create_directory(to / "echomap-pico.uf2");
  EXPECT_THAT(failure_of_copy(to, ::fsync), HasSubstr("Is a directory"));
}

TEST_F(BootDrive, MayGoAwayOnceAllIsWritten) {
  const fs::path to = drive("pico");
  const auto fail = [](int) {
    errno = EIO;
    return -1;
  };
  EXPECT_THAT(failure_of_copy(to, fail), HasSubstr("Input/output error"))
      << "the drive is still there: it has not taken the image";
  const auto fail_and_go = [&](int descriptor) {
    fs::remove(to / "INFO_UF2.TXT");
    return fail(descriptor);
  };
  EXPECT_EQ(failure_of_copy(to, fail_and_go), "") << "the program runs";
}

TEST_F(BootDrive, IsGivenTimeToGoAwayAfterAnErrorOfItsDevice) {
  const fs::path to = drive("pico");
  for (const int error : {EIO, ENODEV, ENXIO}) {
    drive("pico");
    std::jthread kernel;
    const auto fail_and_go_later = [&](int) {
      kernel = std::jthread([&to] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        fs::remove(to / "INFO_UF2.TXT");
      });
      errno = error;
      return -1;
    };
    EXPECT_EQ(failure_of_copy(to, fail_and_go_later), "") << "its files were still shown";
  }
}

}  // namespace
}  // namespace echomap::flashing
