// SPDX-License-Identifier: MIT
#include "hil_mock/world/part_faults.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::world {
namespace {

using ::testing::HasSubstr;

std::string faults_error_of(const std::string& text) {
  try {
    parse_part_faults(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(PartFaults, ReadsKindTimeDurationAndValue) {
  const auto faults = parse_part_faults("sonar-dead@30,slip-left@20:2:0.25,sonar-stuck@5:inf:1.2");
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].kind, PartFaultKind::kSonarDead);
  EXPECT_EQ(faults[0].at_s, 30.0);
  EXPECT_TRUE(std::isinf(faults[0].for_s));
  EXPECT_EQ(faults[1].kind, PartFaultKind::kSlipLeft);
  EXPECT_EQ(faults[1].for_s, 2.0);
  EXPECT_EQ(faults[1].value, 0.25);
  EXPECT_TRUE(std::isinf(faults[2].for_s));
  EXPECT_EQ(faults[2].value, 1.2);
  EXPECT_TRUE(parse_part_faults("").empty());
  EXPECT_EQ(parse_part_faults("board-reset@30").front().for_s, 1.0);
}

TEST(PartFaults, EveryNameIsReadAgain) {
  EXPECT_GE(part_fault_names().size(), 20U);
  for (const std::string& name : part_fault_names()) {
    const auto faults = parse_part_faults(name + "@1");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(name_of(faults[0].kind), name);
  }
}

TEST(PartFaults, SaysWhatIsWrong) {
  EXPECT_THAT(faults_error_of("sonar-daed@3"), HasSubstr("unknown part 'sonar-daed'"));
  EXPECT_THAT(faults_error_of("sonar-daed@3"), HasSubstr("sonar-dead"));
  EXPECT_THAT(faults_error_of("sonar-dead"), HasSubstr("it takes NAME@AT"));
  EXPECT_THAT(faults_error_of("sonar-dead@"), HasSubstr("it takes NAME@AT"));
  EXPECT_THAT(faults_error_of("sonar-dead@3:1:2:3"), HasSubstr("it takes NAME@AT"));
  EXPECT_THAT(faults_error_of("sonar-dead@soon"), HasSubstr("'soon' is no number"));
  EXPECT_THAT(faults_error_of("sonar-dead@-1"),
              HasSubstr("'-1' is no time: it takes seconds, 0 or more"));
  EXPECT_THAT(faults_error_of("sonar-dead@1:-2"), HasSubstr("'-2' is no time"));
  EXPECT_THAT(faults_error_of("sonar-dead@nan"), HasSubstr("'nan' is no number"));
  EXPECT_THAT(faults_error_of("sonar-dead@inf"), HasSubstr("begin at some time"));
  EXPECT_THAT(faults_error_of("sonar-dead@1:2:3"), HasSubstr("takes no value"));
  EXPECT_THAT(faults_error_of("slip-left@1:2:1.5"), HasSubstr("its value is from 0 to 1"));
  EXPECT_THAT(faults_error_of("sonar-stuck@1:2:99"), HasSubstr("its value is from 0 to 10"));
}

TEST(PartFaults, OnlyAnAngleMayBeNegative) {
  EXPECT_EQ(parse_part_faults("pan-off@0:inf:-7").front().value, -7.0);
  EXPECT_THAT(faults_error_of("pan-off@0:inf:-91"), HasSubstr("its value is from -90 to 90"));
  EXPECT_THAT(faults_error_of("slip-left@0:inf:-0.1"), HasSubstr("its value is from 0 to 1"));
  EXPECT_THAT(faults_error_of("wheel-left@0:inf:-1"), HasSubstr("its value is from 0.5 to 2"));
  EXPECT_THAT(faults_error_of("motors-swapped@0:inf:-1"), HasSubstr("takes no value"));
}

TEST(PartFaults, AFaultIsThereFromItsBeginningToItsEnd) {
  const auto faults = parse_part_faults("slip-left@20:2:0.25");
  EXPECT_FALSE(fault_at(faults, PartFaultKind::kSlipLeft, 19.999));
  EXPECT_EQ(fault_at(faults, PartFaultKind::kSlipLeft, 20.0), 0.25);
  EXPECT_EQ(fault_at(faults, PartFaultKind::kSlipLeft, 21.999), 0.25);
  EXPECT_FALSE(fault_at(faults, PartFaultKind::kSlipLeft, 22.0));
  EXPECT_FALSE(fault_at(faults, PartFaultKind::kSlipRight, 21.0));
}

}  // namespace
}  // namespace echomap::world
