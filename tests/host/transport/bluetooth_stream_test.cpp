// SPDX-License-Identifier: MIT
#include "host/transport/bluetooth_stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::string& address) {
  try {
    open_bluetooth_stream(address);
  } catch (const TransportError& error) {
    return error.what();
  }
  return "no error";
}

TEST(BluetoothStream, SaysWhatAnAddressLooksLike) {
  EXPECT_THAT(error_of("bt://robot"), HasSubstr("bt://00:11:22:33:44:55"));
}

/// No machine has this module, and most test machines have no adapter.
TEST(BluetoothStream, SaysHowToPairAModuleThatDoesNotAnswer) {
  EXPECT_THAT(error_of("bt://00:00:00:00:00:00"), HasSubstr("bluetoothctl pair 00:00:00:00:00:00"));
  EXPECT_TRUE(error_of("bt://00:00:00:00:00:00/3").ends_with("pair 00:00:00:00:00:00"));
}

}  // namespace
}  // namespace echomap::transport
