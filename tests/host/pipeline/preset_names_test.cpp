// SPDX-License-Identifier: MIT
#include "host/pipeline/preset_names.hpp"

#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::pipeline {
namespace {

TEST(PresetNames, EachNamesAPresetOfItsOwn) {
  std::set<localization::LocalizerPreset> presets;
  for (const std::string& name : preset_names()) {
    presets.insert(preset_named(name));
    EXPECT_EQ(name_of(preset_named(name)), name);
  }
  EXPECT_EQ(presets.size(), 4U);
  EXPECT_EQ(preset_named("epuck"), localization::LocalizerPreset::kEpuck);
}

TEST(PresetNames, AWrongNameLeadsToTheNearest) {
  const auto wrong = [] { preset_named("nxr"); };
  EXPECT_THAT(wrong,
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::StrEq("unknown preset 'nxr'; did you mean 'nxt'?")));
}

}  // namespace
}  // namespace echomap::pipeline
