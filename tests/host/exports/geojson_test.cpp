// SPDX-License-Identifier: MIT
#include "host/exports/geojson.hpp"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/mapping/polygon_map.hpp"
#include "tests/support/random_polygon.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/wean_map.hpp"

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

TEST_F(GeoJsonTest, SaysWhichSidesAreOpen) {
  write_outline_geojson(
      folder / "a.geojson", mapping::PolygonMap({{0, 0}, {1, 0}, {0, 1}}), {false, true, false});
  EXPECT_EQ(written()["features"][0]["properties"]["sides"],
            nlohmann::json({"wall", "open", "wall"}));
  write_outline_geojson(folder / "a.geojson", mapping::PolygonMap(kL));
  EXPECT_FALSE(written()["features"][0]["properties"].contains("sides"));
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

double twice_area(const nlohmann::json& ring) {
  double sum = 0.0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    sum += ring[i - 1][0].get<double>() * ring[i][1].get<double>() -
           ring[i][0].get<double>() * ring[i - 1][1].get<double>();
  }
  return sum;
}

/// Whether a position lies within a ring: how often a line to the right of it crosses.
bool is_within(const nlohmann::json& position, const nlohmann::json& ring) {
  const double x = position[0];
  const double y = position[1];
  bool is_inside = false;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const double y0 = ring[i - 1][1];
    const double y1 = ring[i][1];
    const double x0 = ring[i - 1][0];
    const double x1 = ring[i][0];
    if ((y0 > y) != (y1 > y) && x < x0 + (x1 - x0) * (y - y0) / (y1 - y0)) {
      is_inside = !is_inside;
    }
  }
  return is_inside;
}

/// RFC 7946, sections 3.1.1 and 3.1.6, by its own arithmetic: four or more positions of two finite
/// numbers, the last as the first; the outline counter-clockwise, holes clockwise and within it.
void expect_valid_polygon(const nlohmann::json& rings) {
  ASSERT_GE(rings.size(), 1U);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto& ring = rings[i];
    ASSERT_GE(ring.size(), 4U);
    for (const auto& position : ring) {
      ASSERT_EQ(position.size(), 2U);
      // JSON has no other numbers than finite ones: what is not becomes null.
      EXPECT_TRUE(position[0].is_number() && position[1].is_number()) << position;
    }
    EXPECT_EQ(ring.front(), ring.back());
    EXPECT_TRUE(i == 0 ? twice_area(ring) > 0.0 : twice_area(ring) < 0.0) << "ring " << i;
    for (const auto& position : ring) {
      EXPECT_TRUE(i == 0 || is_within(position, rings[0])) << position << " of hole " << i;
    }
  }
}

TEST_F(GeoJsonTest, IsValidByRfc7946ForMapsOfAnyShape) {
  std::mt19937 random(7);
  std::size_t holes = 0;
  for (int trial = 0; trial < 60; ++trial) {
    // From bare floor to a third of it taken.
    std::bernoulli_distribution is_taken(0.005 * trial);
    mapping::RasterMap map(40, 30, 0.05, {-1.0, 0.5});
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        map.set({x, y},
                is_taken(random) ? mapping::CellState::kOccupied : mapping::CellState::kFree);
      }
    }
    mapping::PolygonMapParams params;
    params.min_hole_m2 = trial % 2 == 0 ? params.min_hole_m2 : 0.0;
    write_outline_geojson(folder / "a.geojson", mapping::polygon_from_raster(map, params));
    SCOPED_TRACE(trial);
    const auto rings = written()["features"][0]["geometry"]["coordinates"];
    expect_valid_polygon(rings);
    holes += rings.size() - 1;
  }
  EXPECT_GT(holes, 100U);
}

TEST_F(GeoJsonTest, IsValidByRfc7946ForWeanHall) {
  const auto file = tests::real_data("wean_mcl/wean.dat.gz");
  ECHOMAP_SKIP_WITHOUT(file);
  write_outline_geojson(folder / "a.geojson",
                        mapping::polygon_from_raster(tests::read_wean_map(file)));
  const auto rings = written()["features"][0]["geometry"]["coordinates"];
  EXPECT_GT(rings.size(), 10U);
  expect_valid_polygon(rings);
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

TEST_F(GeoJsonTest, HasEveryPieceOfItsLineStrings) {
  files::write_text_file(folder / "a.geojson",
                         R"({"features": [
      {"geometry": {"type": "LineString", "coordinates": [[0, 2], [2, 2], [2, 0.5]]}},
      {"geometry": {"type": "Point", "coordinates": [5, 5]}}]})");
  const auto pieces = read_line_strings(folder / "a.geojson");
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].from_m, Eigen::Vector2d(0.0, 2.0));
  EXPECT_EQ(pieces[0].to_m, Eigen::Vector2d(2.0, 2.0));
  EXPECT_EQ(pieces[1].to_m, Eigen::Vector2d(2.0, 0.5));
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
