// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "host/ros_messages/serialization.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/all_ros_messages.hpp"
#include "tests/support/random_message.hpp"

namespace {

using echomap::fuzz::require;
namespace ros_messages = echomap::ros_messages;
using echomap::tests::AllRosMessages;

template <class M>
void read_as(std::span<const std::uint8_t> bytes) {
  try {
    const M message = ros_messages::deserialize<M>(bytes);
    // By their bytes: a float that is not a number equals nothing.
    const std::vector<std::uint8_t> again = ros_messages::serialize(message);
    require(again.size() <= 8 * (bytes.size() + 8), "a message is about as long as its bytes");
    require(ros_messages::serialize(ros_messages::deserialize<M>(again)) == again,
            "what is read serializes and reads back equal");
  } catch (const ros_messages::CdrError& error) {
    require(std::string_view(error.what()).size() < 200, "an error can be read");
  }
}

int count_of_messages() {
  int count = 0;
  AllRosMessages::for_each([&count]<class M>() { ++count; });
  return count;
}

}  // namespace

/// A message of each type with anything in it.
std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds;
  std::mt19937 random(1);
  AllRosMessages::for_each([&]<class M>() {
    Input& seed = seeds.emplace_back(Input{static_cast<std::uint8_t>(seeds.size())});
    const Input bytes = ros_messages::serialize(echomap::tests::random_message<M>(random));
    seed.insert(seed.end(), bytes.begin(), bytes.end());
  });
  return seeds;
}

/// One input is the number of a message type and a message in CDR. It is refused with a CdrError,
/// or read as a message that serializes and reads back equal.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  const std::vector<std::uint8_t> bytes(data + 1, data + size);
  static const int count = count_of_messages();
  int number = data[0] % count;
  AllRosMessages::for_each([&]<class M>() {
    if (number-- == 0) {
      read_as<M>(bytes);
    }
  });
  return 0;
}
