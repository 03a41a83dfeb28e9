// SPDX-License-Identifier: MIT
#include "protocol/configuration.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/messages.hpp"
#include "tests/protocol/frames.hpp"

namespace echomap::protocol {
namespace {

struct FillRandomly {
  std::mt19937& generator;
  template <class M>
  void operator()(M& message) {
    message = random_message<M>(generator);
  }
};

struct CollectSettings {
  std::vector<std::vector<std::int64_t>> settings;
  template <class M>
  void operator()(const M& message) {
    settings.push_back(values_of(message));
    settings.back().front() = 0;  // the command_id
  }
};

struct CollectIds {
  std::vector<int> ids;
  template <class M>
  void operator()(const M& /*message*/) {
    ids.push_back(M::kId);
  }
};

Configuration random_configuration(std::mt19937& generator) {
  Configuration configuration{};
  FillRandomly fill{generator};
  Configuration::each(configuration, fill);
  return configuration;
}

std::vector<std::vector<std::int64_t>> settings_of(const Configuration& configuration) {
  CollectSettings collect;
  Configuration::each(configuration, collect);
  return collect.settings;
}

TEST(Configuration, IsEveryConfigureMessageInTheOrderOfIds) {
  CollectIds collect;
  const Configuration configuration{};
  Configuration::each(configuration, collect);
  EXPECT_EQ(collect.ids,
            (std::vector<int>{ConfigureDrive::kId,
                              ConfigureSonar::kId,
                              ConfigurePan::kId,
                              ConfigurePins::kId,
                              ConfigureSensors::kId,
                              ConfigureSafety::kId,
                              ConfigureWiring::kId,
                              ConfigureScalar::kId}));
}

TEST(Configuration, WritesTheIdInThePlaceOfTheCommandId) {
  Configuration configuration{};
  configuration.sonar = ConfigureSonar{99, 0x5DC0, 40};
  const ConfigurationBytes written = configuration_bytes(configuration);
  const std::uint8_t* sonar = written.bytes + payload_size_of<ConfigureDrive>();
  EXPECT_EQ(Bytes(sonar, sonar + 4), (Bytes{ConfigureSonar::kId, 0xC0, 0x5D, 40}));
}

TEST(Configuration, ComesBackFromItsBytes) {
  std::mt19937 generator(17);
  for (int i = 0; i < 1000; ++i) {
    const Configuration configuration = random_configuration(generator);
    Configuration again{};
    ASSERT_TRUE(read_configuration(configuration_bytes(configuration), again));
    ASSERT_EQ(settings_of(again), settings_of(configuration));
    ASSERT_EQ(again.safety.command_id, 0);
  }
}

TEST(Configuration, IsNotReadWhereAnIdIsWrong) {
  std::mt19937 generator(18);
  const ConfigurationBytes right = configuration_bytes(random_configuration(generator));
  Configuration configuration{};
  ConfigurationBytes wrong = right;
  wrong.bytes[0] = ConfigureSonar::kId;
  EXPECT_FALSE(read_configuration(wrong, configuration));
  wrong = right;
  wrong.bytes[ConfigurationBytes::kSize - payload_size_of<ConfigureScalar>()] ^= 1;
  EXPECT_FALSE(read_configuration(wrong, configuration));
}

}  // namespace
}  // namespace echomap::protocol
