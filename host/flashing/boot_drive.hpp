// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "host/flashing/uf2.hpp"
#include "host/transport/port_list.hpp"
#include "host/transport/usb_devices.hpp"

namespace echomap::flashing {

/// Whether a folder is the drive that an RP2040 in its boot loader shows: its INFO_UF2.TXT says so.
bool is_boot_drive(const std::filesystem::path& folder);

/// The folders where such drives are mounted, one for each drive; `mounts` is in the form of
/// /proc/mounts.
std::vector<std::filesystem::path> mounted_boot_drives(
    const std::filesystem::path& mounts = "/proc/mounts");

/// The drive to write to: `named` where it is not empty, else the only one of `mounted`. Throws
/// CommandError 3 where there is none or several, with what to do by what `usb` says: hold BOOTSEL,
/// or mount the drive.
std::filesystem::path choose_boot_drive(const std::filesystem::path& named,
                                        const std::vector<std::filesystem::path>& mounted,
                                        const std::vector<transport::UsbDevice>& usb);

/// Brings what was written to a file to its device, as fsync(2) does.
using SyncFile = std::function<int(int descriptor)>;

/// Writes `uf2` as `name` on the drive and waits until it is there. A drive that goes away once all
/// is written, within 2 s of an error of its device, has started the program. Throws CommandError 1
/// where it cannot be written.
void copy_to_boot_drive(std::span<const std::uint8_t> uf2,
                        const std::filesystem::path& drive,
                        const std::string& name,
                        const SyncFile& sync);

}  // namespace echomap::flashing
