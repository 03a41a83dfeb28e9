// SPDX-License-Identifier: MIT
#include <filesystem>

#include "host/apps/commands.hpp"
#include "host/flashing/flash_plan.hpp"
#include "host/flashing/flash_run.hpp"
#include "host/session/child_process.hpp"
#include "host/session/speed_search.hpp"
#include "host/transport/port_lock.hpp"

namespace echomap::apps {
namespace {

/// The board's image for this speed in the build that this program is of. That of the usual speed
/// bears no number.
std::filesystem::path built_image(const flashing::FlashBoard& board, int baud) {
  const auto usual = session::program_folder().parent_path() / board.image;
  const std::string number = baud == session::kRobotBauds.front() ? "" : "-" + std::to_string(baud);
  return usual.parent_path() / (usual.stem().string() + number + usual.extension().string());
}

std::string image_for(const FlashOptions& options, const flashing::FlashBoard& board) {
  const std::filesystem::path image =
      options.image.empty() ? built_image(board, options.baud) : options.image;
  if (!std::filesystem::is_regular_file(image)) {
    throw CommandError(ExitCode::kRuntimeError,
                       "there is no image " + image.string() + "\n  next: ./run build " +
                           std::string(board.target) + ", or name another one with --image");
  }
  return image.string();
}

}  // namespace

ExitCode run_flash(const FlashOptions& options) {
  const flashing::FlashTarget target = flashing::choose_flash_target(
      {options.board, options.port}, {transport::list_ports(), transport::list_usb_devices()});
  if (!options.dry_run && !target.port.empty()) {
    transport::refuse_if_held(target.port);  // avrdude asks nobody.
  }
  return carry_out(flash_plan(target, image_for(options, *target.board)), options.dry_run);
}

}  // namespace echomap::apps
