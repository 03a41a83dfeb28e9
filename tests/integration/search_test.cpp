// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using files::read_text_file;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// 3.2 x 2.4 m, with a source in the far corner.
constexpr const char* kSmallRoom = R"(name = "small_source_room"
background_per_s = 0.4

[start]
x_m = 0.6
y_m = 0.6
heading_deg = 0.0

[room]
corners_m = [[0.0, 0.0], [3.2, 0.0], [3.2, 2.4], [0.0, 2.4]]

[[source]]
x_m = 2.6
y_m = 1.8
strength = 10.0
)";

/// The search of a simulated robot on the native mock.
class Search : public ::testing::Test {
 protected:
  Search() { files::write_text_file(scratch / "room.toml", kSmallRoom); }

  Ended search(std::vector<std::string> more) {
    more.insert(more.begin(), {"search", "--emulator=mock", "--force", "--out=" + path("run")});
    return Program("echomap", more, scratch / "log").wait();
  }
  std::string path(const std::string& name) const { return (scratch / name).string(); }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(read_text_file(scratch / name));
  }

  tests::ScratchFolder scratch;
};

TEST_F(Search, FindsASourceAndSaysWhere) {
  const Ended ended = search({"--world=" + path("room.toml")});
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_EQ(json("run/source.json").at("verdict"), "found");
  EXPECT_EQ(json("run/source.json").at("truth").at("right"), true)
      << json("run/source.json").dump();
  EXPECT_THAT(ended.said, HasSubstr("a source of"));
}

TEST_F(Search, ShowsThatThereIsNone) {
  const Ended ended = search({"--world=" + path("room.toml"), "--source=none"});
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_EQ(json("run/source.json").at("verdict"), "none");
  EXPECT_EQ(json("run/source.json").at("truth").at("right"), true);
}

TEST_F(Search, EndsUnsureWhenItsTimeIsOver) {
  const Ended ended = search({"--world=" + path("room.toml"), "--source=none", "--seconds=3"});
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_EQ(json("run/source.json").at("verdict"), "unsure");
  EXPECT_TRUE(json("run/source.json").at("truth").at("right").is_null());
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("unsure of a source: its time is over"),
                    HasSubstr("next: echomap search"),
                    HasSubstr("--source none")));
}

TEST_F(Search, SaysWhatIsWrongWithItsInputs) {
  const Ended tubeless = search({"--world=" + path("room.toml"), "--robot=uno_2wd"});
  EXPECT_EQ(tubeless.status, 6);
  EXPECT_THAT(tubeless.said, AllOf(HasSubstr("no [scalar] sensor"), HasSubstr("next: ")));
  const Ended worldless = search({"--world=nowhere_room"});
  EXPECT_EQ(worldless.status, 6) << worldless.said;
  EXPECT_THAT(worldless.said, HasSubstr("nowhere_room"));
  const Ended sourceless = search({"--world=" + path("room.toml"), "--source=here"});
  EXPECT_NE(sourceless.status, 0);
  EXPECT_THAT(sourceless.said, HasSubstr("here"));
}

}  // namespace
}  // namespace echomap::test
