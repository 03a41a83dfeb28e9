// SPDX-License-Identifier: MIT
#include "host/exports/geojson.hpp"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/support/random_polygon.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using geometry::Polygon;
using ::testing::HasSubstr;

const Polygon kL{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 3}, {0, 3}};
const Polygon kTable{{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.5, 1}};

class GeoJsonTest : public ::testing::Test {
 protected:
  nlohmann::json written() {
    return nlohmann::json::parse(files::read_text_file(folder / "a.geojson"));
  }
  std::string complaint_about(const std::string& text) {
    files::write_text_file(folder / "a.geojson", text);
    return tests::thrown_text<files::FileError>(
        [&] { read_outline_geojson(folder / "a.geojson"); });
  }

  tests::ScratchFolder folder;
};

TEST_F(GeoJsonTest, ReadsBackTheSameOutline) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const mapping::PolygonMap map(tests::random_polygon(random, 12), {});
    write_outline_geojson(folder / "a.geojson", map);
    const auto read = read_outline_geojson(folder / "a.geojson");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->outline_m(), map.outline_m()) << trial;
  }
  const mapping::PolygonMap with_hole(kL, {kTable});
  write_outline_geojson(folder / "a.geojson", with_hole);
  EXPECT_EQ(read_outline_geojson(folder / "a.geojson")->holes_m(), with_hole.holes_m());
}

TEST_F(GeoJsonTest, ClosesRingsAndTurnsThemAsTheStandardSays) {
  write_outline_geojson(folder / "a.geojson", mapping::PolygonMap(kL, {kTable}));
  const auto rings = written()["features"][0]["geometry"]["coordinates"];
  ASSERT_EQ(rings.size(), 2U);
  for (const auto& ring : rings) {
    EXPECT_EQ(ring.front(), ring.back());
  }
  EXPECT_EQ(rings[0].size(), 7U);
  EXPECT_EQ(rings[0][1], nlohmann::json({4.0, 0.0})) << "the outline runs counter-clockwise";
  EXPECT_EQ(rings[1][1], nlohmann::json({1.0, 1.0})) << "a hole runs clockwise";
}

TEST_F(GeoJsonTest, SaysThatItsPositionsAreLocal) {
  write_outline_geojson(folder / "a.geojson", mapping::PolygonMap(kL));
  const auto properties = written()["features"][0]["properties"];
  EXPECT_THAT(properties["crs"].get<std::string>(), HasSubstr("not longitude"));
  EXPECT_EQ(properties["area_m2"], 8.0);
  EXPECT_EQ(properties["corners"][3], "reflex");
  EXPECT_EQ(properties["corners"][4], "non-reflex");
}

TEST_F(GeoJsonTest, WithoutAMapHasNoFeature) {
  write_outline_geojson(folder / "a.geojson", std::nullopt);
  EXPECT_EQ(written()["features"].size(), 0U);
  EXPECT_FALSE(read_outline_geojson(folder / "a.geojson"));
}

TEST_F(GeoJsonTest, HoldsWallsWithWhatTheFitKnows) {
  const std::vector<Eigen::Vector2d> points{{0.0, 2.0}, {1.0, 2.0}, {2.0, 2.0}};
  const auto line = mapping::fit_line(points, 0.03);
  write_lines_geojson(folder / "a.geojson", {line});
  const auto pieces = read_line_strings(folder / "a.geojson");
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].from_m, line.segment.from_m);
  EXPECT_EQ(pieces[0].to_m, line.segment.to_m);
  const auto properties = written()["features"][0]["properties"];
  EXPECT_NEAR(properties["offset_m"].get<double>(), 2.0, 1e-12);
  EXPECT_NEAR(properties["normal_sd_rad"].get<double>(), 0.03 / std::sqrt(2.0), 1e-9);
  EXPECT_EQ(properties["points"], 3);
}

TEST_F(GeoJsonTest, NamesTheFileThatIsBroken) {
  const std::string name = (folder / "a.geojson").string();
  for (const char* text :
       {"{",
        "[]",
        R"({"features": [{"geometry": {"type": "Polygon"}}]})",
        R"({"features": [{"geometry": {"type": "Polygon", "coordinates": []}}]})",
        R"({"features": [{"geometry": {"type": "Polygon", "coordinates":
                              [[[0, 0], [1, 1], [1, 0], [0, 1], [0, 0]]]}}]})",
        R"({"features": [{"geometry": {"type": "Polygon", "coordinates":
                              [[["x", 0]]]}}]})"}) {
    EXPECT_THAT(complaint_about(text), HasSubstr(name)) << text;
  }
}

}  // namespace
}  // namespace echomap::exports
