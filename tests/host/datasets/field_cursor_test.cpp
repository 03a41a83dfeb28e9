// SPDX-License-Identifier: MIT
#include "host/datasets/field_cursor.hpp"

#include <functional>
#include <string>

#include <gmock/gmock.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class FieldCursorTest : public ::testing::Test {
 protected:
  FieldCursorTest() {
    files::write_text_file(folder_ / "log", "first\nsecond\n");
    lines_.emplace(folder_ / "log");
    lines_->next();
    lines_->next();
  }
  FieldCursor of(std::string_view line, Separator separator = Separator::kBlanks) {
    return {*lines_, line, separator};
  }
  std::string error_of(const std::function<void()>& action) {
    return tests::thrown_text<files::FileError>(action);
  }

  tests::ScratchFolder folder_;
  std::optional<LineReader> lines_;
};

TEST_F(FieldCursorTest, TakesFieldsBetweenBlanks) {
  auto fields = of("  ODOM 1.5\t-2e3 +7  ");
  EXPECT_EQ(fields.word("kind"), "ODOM");
  EXPECT_EQ(fields.number("x"), 1.5);
  EXPECT_EQ(fields.number("y"), -2000.0);
  EXPECT_EQ(fields.integer("n"), 7);
  EXPECT_TRUE(fields.at_end());
  fields.expect_end();
}

TEST_F(FieldCursorTest, TakesFieldsBetweenCommas) {
  auto fields = of("1, 2 ,3", Separator::kComma);
  EXPECT_EQ(fields.integer("a"), 1);
  EXPECT_EQ(fields.integer("b"), 2);
  EXPECT_FALSE(fields.at_end());
  EXPECT_EQ(fields.integer("c"), 3);
  EXPECT_TRUE(fields.at_end());
}

TEST_F(FieldCursorTest, SkipsAWordOnlyWhereItIsThere) {
  for (const Separator separator : {Separator::kComma, Separator::kBlanks}) {
    auto fields = of(separator == Separator::kComma ? "1,silent,2" : "1 silent 2", separator);
    EXPECT_FALSE(fields.skip_word("silent"));
    EXPECT_EQ(fields.integer("a"), 1);
    EXPECT_FALSE(fields.skip_word("sil"));
    EXPECT_TRUE(fields.skip_word("silent"));
    EXPECT_EQ(fields.integer("b"), 2);
    EXPECT_FALSE(fields.skip_word("silent"));
  }
}

TEST_F(FieldCursorTest, NothingBetweenCommasIsAMissingField) {
  for (const char* line : {"1,,3", "1,", "1, "}) {
    auto fields = of(line, Separator::kComma);
    fields.integer("a");
    EXPECT_FALSE(fields.at_end()) << line;
    EXPECT_THAT(error_of([&] { fields.integer("the yaw"); }), HasSubstr("the yaw is missing"))
        << line;
  }
}

TEST_F(FieldCursorTest, ErrorsNameFileLineFieldAndReason) {
  EXPECT_THAT(error_of([&] { of("1.2.3").number("the yaw"); }),
              EndsWith("log:2: the yaw is '1.2.3', not a finite number"));
  EXPECT_THAT(error_of([&] { of("").number("the yaw"); }),
              EndsWith("log:2: the yaw is missing: the line ends before it"));
  EXPECT_THAT(error_of([&] { of("x y").expect_end(); }),
              EndsWith("log:2: 'x y' follows, the line should end before it"));
}

TEST_F(FieldCursorTest, ANumberMayBeNone) {
  EXPECT_EQ(of("none").number_or_none("x"), std::nullopt);
  EXPECT_EQ(of("0.5").number_or_none("x"), 0.5);
  EXPECT_THAT(error_of([&] { of("nine").number_or_none("x"); }), HasSubstr("x is 'nine'"));
}

TEST_F(FieldCursorTest, RefusesWhatIsNoFiniteNumber) {
  for (const char* text :
       {"nan", "inf", "-INF", "1e400", "0x10", "1,5", "--1", "+-1", "+", "1e16"}) {
    EXPECT_NE(error_of([&] { of(text).number("x"); }), "") << text;
  }
}

TEST_F(FieldCursorTest, RefusesWhatIsNoWholeNumber) {
  for (const char* text : {"1.0", "99999999999999999999", "a", "1e3"}) {
    EXPECT_NE(error_of([&] { of(text).integer("x"); }), "") << text;
  }
}

TEST_F(FieldCursorTest, ACountIsBelievedOnlyAsFarAsTheLineHasRoom) {
  EXPECT_EQ(of("3 1 2 3").count("n"), 3U);
  EXPECT_EQ(of("0").count("n"), 0U);
  for (const char* text : {"4 1 2 3", "-1 1", "1", "18446744073709551615 1", "1e2 1"}) {
    EXPECT_THAT(error_of([&] { of(text).count("n"); }), HasSubstr("not the number of values"))
        << text;
  }
}

TEST_F(FieldCursorTest, ErrorsShowBinaryAsText) {
  EXPECT_THAT(error_of([&] { of("\x1b[2J\xff").number("x"); }), HasSubstr("'\\x1b[2J\\xff'"));
  EXPECT_LT(error_of([&] { of(std::string(50000, 'z')).number("x"); }).size(), 200U);
}

}  // namespace
}  // namespace echomap::datasets
