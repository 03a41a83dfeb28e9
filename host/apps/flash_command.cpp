// SPDX-License-Identifier: MIT
#include <filesystem>

#include "host/apps/commands.hpp"
#include "host/flashing/flash_plan.hpp"
#include "host/flashing/flash_run.hpp"
#include "host/session/child_process.hpp"
#include "host/transport/port_lock.hpp"

namespace echomap::apps {
namespace {

/// The image that was named, or the board's of the build that this program is of.
std::string image_for(const FlashOptions& options, const flashing::FlashBoard& board) {
  const std::filesystem::path image =
      options.image.empty() ? session::program_folder().parent_path() / board.image : options.image;
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
  if (!target.port.empty()) {
    transport::refuse_if_held(target.port);  // avrdude asks nobody.
  }
  return carry_out(flash_plan(target, image_for(options, *target.board)), options.dry_run);
}

}  // namespace echomap::apps
