// SPDX-License-Identifier: MIT
#include "host/diagnosis/fault.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace echomap::diagnosis {
namespace {

TEST(Fault, EachHasItsName) {
  std::set<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(FaultKind::kRightDirty); ++kind) {
    EXPECT_TRUE(names.insert(name_of(static_cast<FaultKind>(kind))).second) << kind;
  }
}

TEST(Fault, WhatBendsAMapALittleDoesNotForbidIt) {
  EXPECT_FALSE(forbids_a_map(FaultKind::kNone));
  EXPECT_FALSE(forbids_a_map(FaultKind::kPanOffset));
  EXPECT_TRUE(forbids_a_map(FaultKind::kLeftWheelSize));
  EXPECT_TRUE(forbids_a_map(FaultKind::kPanReversed));
}

}  // namespace
}  // namespace echomap::diagnosis
