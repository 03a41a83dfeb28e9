// SPDX-License-Identifier: MIT
#include "host/transport/udev_rules.hpp"

#include "host/transport/usb_table.hpp"

namespace echomap::transport {
namespace {

std::string match_of(UsbId id, const std::string& key) {
  const std::string text = to_string(id);
  return key + "{idVendor}==\"" + text.substr(0, 4) + "\", " + key + "{idProduct}==\"" +
         text.substr(5) + "\"";
}

}  // namespace

std::string udev_rules() {
  std::string rules =
      "# Serial ports at which an echomap robot may be; written by: echomap ports --install-rules\n"
      "ACTION==\"remove\", GOTO=\"echomap_end\"\n"
      "SUBSYSTEM==\"usb\", ENV{DEVTYPE}==\"usb_device\", GOTO=\"echomap_device\"\n"
      "SUBSYSTEM==\"tty\", GOTO=\"echomap_port\"\n"
      "GOTO=\"echomap_end\"\n";
  std::string devices = "\nLABEL=\"echomap_device\"\n";
  std::string ports = "GOTO=\"echomap_end\"\n\nLABEL=\"echomap_port\"\n";
  for (const KnownUsbId& known : known_usb_ids()) {
    if (may_be_robot(known.id)) {
      devices += match_of(known.id, "ATTR") + ", ENV{ID_MM_DEVICE_IGNORE}=\"1\"\n";
      // %b is the socket: the name of the USB device that has matched.
      ports += match_of(known.id, "ATTRS") +
               ", ENV{ID_MM_PORT_IGNORE}=\"1\", GROUP=\"dialout\", MODE=\"0660\", "
               "TAG+=\"uaccess\", SYMLINK+=\"echomap-%b\"\n";
    }
  }
  return rules + devices + ports + "\nLABEL=\"echomap_end\"\n";
}

}  // namespace echomap::transport
