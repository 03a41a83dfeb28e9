// SPDX-License-Identifier: MIT
#include "host/localization/localizer_outcome.hpp"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(LocalizerOutcome, IsToldApartInWords) {
  std::set<std::string_view> texts;
  for (std::size_t i = 0; i < kLocalizerOutcomes; ++i) {
    texts.insert(text_of(static_cast<LocalizerOutcome>(i)));
  }
  EXPECT_EQ(texts.size(), kLocalizerOutcomes);
  EXPECT_EQ(text_of(LocalizerOutcome::kTimeRanBack), "time ran backwards");
  EXPECT_EQ(text_of(LocalizerOutcome::kUnknownMap), "no cell of the map is known");
}

}  // namespace
}  // namespace echomap::localization
