// SPDX-License-Identifier: MIT
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace echomap {
namespace boards {

/// Of the longest path, its end included.
constexpr size_t kPathBytes = 256;

/// A folder of sysfs, such as /sys/class/tacho-motor/motor0.
struct DeviceFolder {
  char path[kPathBytes];
};

/// Finds the device of a class ("tacho-motor") that is plugged into a port ("outA") by its address,
/// because its number says nothing; false where nothing is.
bool find_device(const char* sysfs, const char* class_name, const char* port, DeviceFolder& folder);

/// What a file is opened for. Sysfs has files that may only be read, and some only be written.
enum class Access : uint8_t { kRead, kWrite, kReadAndWrite };

/// One file of a device. It is kept open, to be read and written with one call each, and never
/// closed: it is needed as long as the program is.
class Attribute {
 public:
  /// False where there is none, or where this user has not the right.
  bool open(const DeviceFolder& folder, const char* name, Access access);
  bool is_open() const { return file_ >= 0; }

  /// The first word; false when the device has gone.
  bool read_word(char* word, size_t size) const;
  bool read(int32_t& number) const;
  /// False when the kernel refuses it. Both may be called by a signal's handler.
  bool write(const char* text) const;
  bool write(int32_t number) const;

 private:
  int file_ = -1;
};

}  // namespace boards
}  // namespace echomap
