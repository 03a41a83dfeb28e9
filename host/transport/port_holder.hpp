// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace echomap::transport {

/// A process that has a port, or has taken it away.
struct PortHolder {
  int pid = 0;
  std::string name;     ///< Of the program, 15 characters at most; empty where it is not readable.
  std::string command;  ///< Its whole command line; the same.
};

/// The other processes that have `device` open, a path without links, by the descriptors below
/// `proc`. Those of other users are seen by root alone.
std::vector<PortHolder> port_holders(const std::string& device,
                                     const std::filesystem::path& proc = "/proc");

/// The process that has `device` by a file LCK..NAME in `folder`, as minicom and other programs of
/// the UUCP family write it. Empty where there is none, and where its process has ended.
std::optional<PortHolder> lock_file_holder(const std::string& device,
                                           const std::filesystem::path& folder = "/var/lock",
                                           const std::filesystem::path& proc = "/proc");

/// The process that has locked `device` by flock(2), by /proc/locks; empty where there is none.
std::optional<PortHolder> flock_holder(const std::string& device,
                                       const std::filesystem::path& proc = "/proc");

/// The running process of this name; empty where there is none.
std::optional<PortHolder> process_named(const std::string& name,
                                        const std::filesystem::path& proc = "/proc");

/// "process 1234 (picocom /dev/ttyUSB0)".
std::string in_words(const PortHolder& holder);

/// What to type so that `holder` gives `device` back.
std::string remedy_against(const PortHolder& holder, const std::string& device);

}  // namespace echomap::transport
