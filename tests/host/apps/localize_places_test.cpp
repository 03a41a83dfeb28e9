// SPDX-License-Identifier: MIT
#include "host/apps/localize_places.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

/// 36 ranges in centimetres around a robot that is turned by so many steps, in a room whose shape
/// is `seed`.
std::string sweep(int seed, int turned = 0, int readings = 36) {
  std::string text;
  for (int i = 0; i < readings; ++i) {
    const double bearing = 6.2831853 * (i + turned) / 36.0;
    text += std::to_string(100.0 + 40.0 * std::sin(seed * bearing) + 5.0 * seed) + "\n";
  }
  return text;
}

class LocalizePlaces : public ::testing::Test {
 protected:
  LocalizePlaces() {
    std::filesystem::create_directories(scratch / "learned");
    std::filesystem::create_directories(scratch / "out");
    learn("hall", 1);
    learn("kitchen", 3);
    options.log = scratch / "now.dat";
    options.format = "nxt";
    options.map = "places=" + (scratch / "learned").string();
  }
  void learn(const std::string& name, int seed, int readings = 36) {
    files::write_text_file(scratch / "learned" / (name + ".dat"), sweep(seed, 0, readings));
  }
  ExitCode localize(const std::string& text) {
    files::write_text_file(options.log, text);
    return localize_in_places(options, scratch / "out");
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(files::read_text_file(scratch / "out/summary.json"));
  }

  tests::ScratchFolder scratch;
  LocalizeOptions options;
};

TEST_F(LocalizePlaces, NamesThePlaceAndHowTheRobotIsTurned) {
  EXPECT_EQ(localize(sweep(3, 4)), ExitCode::kOk);
  EXPECT_EQ(summary().at("place"), "kitchen");
  EXPECT_NEAR(std::fmod(summary().at("turn_deg").get<double>(), 120.0), 40.0, 1e-6)
      << "its shape repeats every 120 degrees";
  EXPECT_EQ(summary().at("finished"), true);
}

TEST_F(LocalizePlaces, IsUnsureBetweenPlacesThatLookAlike) {
  learn("other_kitchen", 3);
  EXPECT_EQ(localize(sweep(3)), ExitCode::kUnfinished);
  EXPECT_THAT(summary().at("why").get<std::string>(), HasSubstr("ambiguous"));
}

TEST_F(LocalizePlaces, SaysThatNoLearnedPlaceFits) {
  std::string elsewhere;
  for (int i = 0; i < 36; ++i) {
    elsewhere += "20\n";
  }
  EXPECT_EQ(localize(elsewhere), ExitCode::kUnfinished);
  EXPECT_THAT(summary().at("why").get<std::string>(), HasSubstr("no learned place fits"));
}

TEST_F(LocalizePlaces, RefusesASweepThatIsNotAllRound) {
  std::filesystem::remove_all(scratch / "learned");
  std::filesystem::create_directories(scratch / "learned");
  options.log = scratch / "learned/ahead.clf";
  files::write_text_file(options.log, "FLASER 3 1.0 1.1 1.2 0 0 0 0 0 0 0 robot 0\n");
  options.format = "carmen";
  EXPECT_THAT(tests::thrown_text<console::CommandError>(
                  [&] { localize_in_places(options, scratch / "out"); }),
              HasSubstr("does not look all round"));
}

TEST_F(LocalizePlaces, RefusesSweepsOfOtherStepsAndAFolderWithoutPlaces) {
  learn("lab", 2, 72);
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { localize(sweep(3)); }),
              HasSubstr("lab has 72 readings"));
  options.map = "places=" + (scratch / "out").string();
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { localize(sweep(3)); }),
              HasSubstr("has no place"));
}

TEST(PlacesOf, IsEmptyForAMap) {
  EXPECT_FALSE(places_of("kitchen"));
  EXPECT_EQ(places_of("places=learned"), "learned");
}

}  // namespace
}  // namespace echomap::apps
