// SPDX-License-Identifier: MIT
#include "host/transport/usb_devices.hpp"

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

class UsbDevices : public testing::Test {
 protected:
  void device(const std::string& name,
              const std::vector<std::pair<std::string, std::string>>& attributes) {
    std::filesystem::create_directory(folder / name);
    for (const auto& [attribute, value] : attributes) {
      std::ofstream(folder / name / attribute) << value << "\n";
    }
  }

  tests::ScratchFolder folder;
};

TEST_F(UsbDevices, AreThoseWithAnId) {
  device("1-2",
         {{"idVendor", "0483"}, {"idProduct", "3748"}, {"product", "STM32"}, {"serial", "55FF"}});
  device("1-1", {{"idVendor", "2341"}, {"idProduct", "0043"}});
  device("1-1:1.0", {{"bInterfaceNumber", "00"}});
  device("1-3", {{"idVendor", "04zz"}, {"idProduct", "3748"}});
  const auto devices = list_usb_devices(folder.path());
  ASSERT_EQ(devices.size(), 2U);
  EXPECT_EQ(devices[0].id, (UsbId{0x2341, 0x0043}));
  EXPECT_EQ(devices[0].description, "");
  EXPECT_EQ(devices[1].id, (UsbId{0x0483, 0x3748}));
  EXPECT_EQ(devices[1].description, "STM32");
  EXPECT_EQ(devices[1].serial_number, "55FF");
}

TEST_F(UsbDevices, AreNoneWithoutAUsb) { EXPECT_TRUE(list_usb_devices(folder / "absent").empty()); }

}  // namespace
}  // namespace echomap::transport
