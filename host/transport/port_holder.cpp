// SPDX-License-Identifier: MIT
#include "host/transport/port_holder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <unistd.h>

#include <sys/stat.h>
#include <sys/sysmacros.h>

namespace echomap::transport {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::optional<int> pid_of(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  int pid = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = begin == std::string::npos
                          ? std::from_chars_result{end, std::errc::invalid_argument}
                          : std::from_chars(text.data() + begin, end, pid);
  return parsed.ec == std::errc() && pid > 0 ? std::optional(pid) : std::nullopt;
}

PortHolder process(int pid, const fs::path& proc) {
  const fs::path folder = proc / std::to_string(pid);
  std::string name = content_of(folder / "comm");
  name.erase(std::find(name.begin(), name.end(), '\n'), name.end());
  // The words end with a NUL each.
  std::string command = content_of(folder / "cmdline");
  while (!command.empty() && command.back() == '\0') {
    command.pop_back();
  }
  std::replace_if(
      command.begin(), command.end(), [](unsigned char letter) { return letter < ' '; }, ' ');
  return {pid, name, command.empty() ? name : command};
}

std::vector<int> pids_below(const fs::path& proc) {
  std::vector<int> pids;
  std::error_code none;
  for (auto entry = fs::directory_iterator(proc, none); !none && entry != fs::directory_iterator();
       entry.increment(none)) {
    if (const auto pid = pid_of(entry->path().filename().string())) {
      pids.push_back(*pid);
    }
  }
  return pids;
}

/// False for processes of other users, too, whose descriptors are not readable.
bool has_open(const fs::path& process, const std::string& device) {
  std::error_code none;
  for (auto entry = fs::directory_iterator(process / "fd", none);
       !none && entry != fs::directory_iterator();
       entry.increment(none)) {
    std::error_code closed;
    if (fs::read_symlink(entry->path(), closed) == device) {
      return true;
    }
  }
  return false;
}

/// "/dev/pts/3" has the lock file LCK..pts_3.
std::string lock_name_of(const std::string& device) {
  constexpr std::string_view kFolder = "/dev/";
  std::string name = device.starts_with(kFolder) ? device.substr(kFolder.size()) : device;
  std::replace(name.begin(), name.end(), '/', '_');
  return "LCK.." + name;
}

}  // namespace

std::vector<PortHolder> port_holders(const std::string& device, const fs::path& proc) {
  std::vector<PortHolder> holders;
  for (const int pid : pids_below(proc)) {
    if (pid != ::getpid() && has_open(proc / std::to_string(pid), device)) {
      holders.push_back(process(pid, proc));
    }
  }
  return holders;
}

std::optional<PortHolder> lock_file_holder(const std::string& device,
                                           const fs::path& folder,
                                           const fs::path& proc) {
  const auto pid = pid_of(content_of(folder / lock_name_of(device)));
  if (!pid || *pid == ::getpid() || (::kill(*pid, 0) != 0 && errno == ESRCH)) {
    return std::nullopt;
  }
  return process(*pid, proc);
}

/// A line is "1: FLOCK  ADVISORY  WRITE 1234 00:18:5 0 EOF": major and minor number, in
/// hexadecimal, and inode of the file (proc_locks(5)).
std::optional<PortHolder> flock_holder(const std::string& device, const fs::path& proc) {
  struct stat status {};
  if (::stat(device.c_str(), &status) != 0) {
    return std::nullopt;
  }
  std::array<char, 64> file{};
  std::snprintf(file.data(),
                file.size(),
                "%02x:%02x:%llu",
                major(status.st_dev),
                minor(status.st_dev),
                static_cast<unsigned long long>(status.st_ino));
  std::ifstream locks(proc / "locks");
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, mode, access, inode;
    int pid = 0;
    if (words >> number >> kind >> mode >> access >> pid >> inode && kind == "FLOCK" && pid > 0 &&
        inode == file.data()) {
      return process(pid, proc);
    }
  }
  return std::nullopt;
}

std::optional<PortHolder> process_named(const std::string& name, const fs::path& proc) {
  for (const int pid : pids_below(proc)) {
    PortHolder found = process(pid, proc);
    if (found.name == name) {
      return found;
    }
  }
  return std::nullopt;
}

std::string in_words(const PortHolder& holder) {
  const std::string process = "process " + std::to_string(holder.pid);
  return holder.command.empty() ? process : process + " (" + holder.command + ')';
}

std::string remedy_against(const PortHolder& holder, const std::string& device) {
  if (holder.name == "ModemManager") {
    return "sudo echomap ports --install-rules, which tells ModemManager to leave robots alone, "
           "then replug the robot";
  }
  if (holder.name == "brltty") {
    return "sudo systemctl mask --now brltty-udev.service brltty.service, unless you use a "
           "braille display, then replug the robot";
  }
  const std::string pid = std::to_string(holder.pid);
  return holder.name == "echomap"
             ? "end that run with Ctrl-C in its terminal, or with: kill " + pid
             : "end that program, or: kill " + pid + "; then fuser -v " + device + " shows nothing";
}

}  // namespace echomap::transport
