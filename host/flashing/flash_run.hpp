// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/console/exit_code.hpp"
#include "host/flashing/brick_plan.hpp"
#include "host/flashing/flash_plan.hpp"
#include "host/flashing/uf2.hpp"

namespace echomap::flashing {

/// Prints each command on stdout before it runs it, with the terminal to itself, until one
/// succeeds; only prints them all where `dry_run`. Throws CommandError 1 where the program is
/// missing or every try fails. Ctrl-C ends it with kInterrupted.
console::ExitCode carry_out(const FlashPlan& plan, bool dry_run);

/// The same for the steps of a brick, all of which have to succeed. Throws CommandError 3 where ssh
/// does not reach it, or another machine is there.
console::ExitCode carry_out(const BrickPlan& plan, bool dry_run);

/// An image for a Pico and the drive of its boot loader.
struct DrivePlan {
  std::filesystem::path image;  ///< The file that was read, .bin or .uf2.
  Bytes uf2;                    ///< What is written.
  std::filesystem::path drive;  ///< Where it is mounted.
};

/// The command that writes an image as a UF2 file.
console::CommandWords uf2_command(const std::filesystem::path& image,
                                  const std::filesystem::path& uf2);

/// Prints the commands that copy the image to the drive, and does the same by itself unless
/// `dry_run`. Throws CommandError 1 where the drive does not take it.
console::ExitCode carry_out(const DrivePlan& plan, bool dry_run);

}  // namespace echomap::flashing
