// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "host/apps/commands.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"
#include "host/files/atomic_file.hpp"
#include "host/flashing/boot_drive.hpp"
#include "host/flashing/flash_plan.hpp"
#include "host/flashing/flash_run.hpp"
#include "host/flashing/rp2040_image.hpp"
#include "host/session/child_process.hpp"
#include "host/session/speed_search.hpp"
#include "host/transport/port_lock.hpp"

namespace echomap::apps {
namespace {

using boards::FlashMethod;

constexpr auto kUsualBrick = "robot@ev3dev.local";

/// The board's image for this speed in the build that this program is of. That of the usual speed
/// bears no number.
std::filesystem::path built_image(const boards::Board& board, std::optional<int> baud) {
  const auto usual = session::program_folder().parent_path() / board.image;
  if (baud && !board.has_image_per_baud) {
    throw CommandError(ExitCode::kUsage,
                       "--baud is not for the " + std::string(board.what) +
                           ": it has one image\n  next: leave --baud out");
  }
  const bool is_usual = baud.value_or(session::kRobotBauds.front()) == session::kRobotBauds.front();
  const std::string number = is_usual ? "" : "-" + std::to_string(*baud);
  return usual.parent_path() / (usual.stem().string() + number + usual.extension().string());
}

std::string image_for(const FlashOptions& options, const boards::Board& board) {
  const std::filesystem::path image =
      options.image.empty() ? built_image(board, options.baud) : options.image;
  if (!std::filesystem::is_regular_file(image)) {
    throw CommandError(ExitCode::kRuntimeError,
                       "there is no image " + image.string() + "\n  next: ./run build " +
                           std::string(board.target) + ", or name another one with --image");
  }
  return image.string();
}

ExitCode flash_by_port(const FlashOptions& options) {
  const flashing::FlashTarget target = flashing::choose_flash_target(
      {options.board, options.port}, {transport::list_ports(), transport::list_usb_devices()});
  if (!options.dry_run && !target.port.empty()) {
    transport::refuse_if_held(target.port);  // avrdude asks nobody.
  }
  return carry_out(flash_plan(target, image_for(options, *target.board)), options.dry_run);
}

ExitCode flash_brick(const FlashOptions& options, const boards::Board& board) {
  const std::string host = options.host.empty() ? kUsualBrick : options.host;
  if (const std::string fault = flashing::fault_of_host(host); !fault.empty()) {
    throw CommandError(ExitCode::kUsage, "--host: " + fault);
  }
  const std::string program = image_for(options, board);
  if (const std::string fault = flashing::fault_of_brick_program(program); !fault.empty()) {
    throw CommandError(ExitCode::kRuntimeError,
                       "will not flash " + program + ": " + fault +
                           "\n  next: ./run build firmware_ev3, and flash without --image");
  }
  return carry_out(flashing::brick_plan(host, program), options.dry_run);
}

/// Writes the image as a file to drag; in a dry run prints how to.
ExitCode write_uf2(const flashing::DrivePlan& plan,
                   const std::filesystem::path& path,
                   bool dry_run) {
  if (dry_run) {
    fmt::print("{}\n", console::shell_line(flashing::uf2_command(plan.image, path)));
    return ExitCode::kOk;
  }
  try {
    files::AtomicFile file(path);
    file.write(plan.uf2);
    file.commit();
  } catch (const files::FileError& error) {
    throw CommandError(ExitCode::kRuntimeError,
                       std::string(error.what()) +
                           "\n  next: name with --uf2 a file in a folder that you may write to");
  }
  console::print("wrote " + path.string() +
                 "\n  next: hold the button BOOTSEL of a Pico while plugging it in, and drag the "
                 "file to its drive RPI-RP2");
  return ExitCode::kOk;
}

ExitCode flash_pico(const FlashOptions& options, const boards::Board& board) {
  flashing::DrivePlan plan;
  plan.image = image_for(options, board);
  plan.uf2 = flashing::uf2_of(flashing::read_rp2040_image(plan.image));
  if (!options.uf2.empty()) {
    return write_uf2(plan, options.uf2, options.dry_run);
  }
  plan.drive = flashing::choose_boot_drive(
      options.volume, flashing::mounted_boot_drives(), transport::list_usb_devices());
  return carry_out(plan, options.dry_run);
}

/// Refuses an option that means nothing for the board.
void refuse_options_of_others(const FlashOptions& options) {
  const auto method =
      options.board.empty() ? FlashMethod::kAvrdude : boards::board_named(options.board).method;
  const auto refuse = [](std::string_view option, std::string_view board, bool is_given) {
    if (is_given) {
      throw CommandError(ExitCode::kUsage,
                         fmt::format("{0} is only for --board {1}\n  next: leave {0} out, or say "
                                     "--board {1}",
                                     option,
                                     board));
    }
  };
  if (method != FlashMethod::kSsh) {
    refuse("--host", "ev3", !options.host.empty());
  }
  if (method != FlashMethod::kUf2) {
    refuse("--volume", "pico", !options.volume.empty());
    refuse("--uf2", "pico", !options.uf2.empty());
  }
  if (method == FlashMethod::kSsh && !options.port.empty()) {
    throw CommandError(
        ExitCode::kUsage,
        "an EV3 is flashed by ssh, not at --port (or $ECHOMAP_PORT)\n  next: name it "
        "with --host USER@NAME");
  }
  if (method == FlashMethod::kUf2 && !options.port.empty()) {
    throw CommandError(
        ExitCode::kUsage,
        "a Pico is flashed through the drive of its boot loader, not at --port (or "
        "$ECHOMAP_PORT)\n  next: hold BOOTSEL while plugging it in; --volume DIR names "
        "the drive");
  }
}

}  // namespace

ExitCode run_flash(const FlashOptions& options) {
  refuse_options_of_others(options);
  if (options.board.empty()) {
    return flash_by_port(options);
  }
  const boards::Board& board = boards::board_named(options.board);
  switch (board.method) {
    case FlashMethod::kSsh:
      return flash_brick(options, board);
    case FlashMethod::kUf2:
      return flash_pico(options, board);
    case FlashMethod::kAvrdude:
    case FlashMethod::kStm32:
      break;
  }
  return flash_by_port(options);
}

}  // namespace echomap::apps
