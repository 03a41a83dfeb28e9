// SPDX-License-Identifier: MIT
#include "host/live_page/map_publisher.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/live_page/read_messages.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::live_page {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A tile's x, y and how many of its cells have evidence.
using SeenTile = std::vector<int>;

class MapPublisherTest : public testing::Test {
 protected:
  MapPublisherTest() { snapshot.last_scan = nullptr; }

  void add_evidence(geometry::CellIndex cell) {
    grid.add(cell, 100);
    snapshot.grid = std::make_shared<const mapping::OccupancyGrid>(grid);
  }
  void make_a_stop(const mapping::Scan& scan = {}) {
    snapshot.last_scan = std::make_shared<const mapping::Scan>(scan);
  }
  /// What a look at the snapshot adds.
  std::vector<SharedMessage> look() {
    const std::size_t before = history->since(0).size();
    publisher.look_at(time_s += 1.0, snapshot);
    return history->since(before);
  }
  static std::vector<SeenTile> tiles_in(const std::vector<SharedMessage>& messages) {
    std::vector<SeenTile> tiles;
    for (const SharedMessage& message : messages) {
      if (message->kind == MessageKind::kTile) {
        const std::string cells = body_of(*message).substr(8);
        tiles.push_back({i32_at(message->bytes, kHeaderBytes),
                         i32_at(message->bytes, kHeaderBytes + 4),
                         static_cast<int>(cells.size()) -
                             static_cast<int>(std::count(cells.begin(), cells.end(), '\0'))});
      }
    }
    return tiles;
  }
  nlohmann::json room() {
    const auto rooms = of_kind(*history, MessageKind::kRoom);
    return rooms.empty() ? nlohmann::json() : json_in(*rooms.back());
  }

  std::shared_ptr<History> history = std::make_shared<History>();
  MapPublisher publisher{history};
  mapping::OccupancyGrid grid;
  pipeline::Snapshot snapshot = tests::snapshot_of(grid);
  double time_s = 0.0;
};

TEST_F(MapPublisherTest, SendsTheTilesThatHaveEvidence) {
  add_evidence({0, 0});
  add_evidence({200, -1});
  EXPECT_THAT(tiles_in(look()), ElementsAre(SeenTile{0, 0, 1}, SeenTile{3, -1, 1}));
}

TEST_F(MapPublisherTest, SendsNothingWhereNothingHasChanged) {
  add_evidence({0, 0});
  make_a_stop();
  look();
  EXPECT_EQ(publisher.changes(), 1U);
  EXPECT_THAT(look(), IsEmpty());
  EXPECT_EQ(publisher.changes(), 1U);
}

TEST_F(MapPublisherTest, SendsOfAChangedMapTheChangedTileAlone) {
  add_evidence({0, 0});
  add_evidence({100, 0});
  look();
  add_evidence({101, 3});
  const auto messages = look();
  EXPECT_THAT(tiles_in(messages), ElementsAre(SeenTile{1, 0, 2}));
  EXPECT_EQ(byte_at(body_of(*messages.front()), 8 + 3 * 64 + (101 - 64)), 128U + 20U)
      << "100 hundredths of log-odds in steps of 5";
  EXPECT_EQ(publisher.changes(), 2U);
}

TEST_F(MapPublisherTest, SeesThatTheSameGridHasGrown) {
  const auto growing = std::make_shared<mapping::OccupancyGrid>();
  growing->add({0, 0}, 100);
  snapshot.grid = growing;
  look();
  growing->add({1, 0}, 100);
  EXPECT_THAT(tiles_in(look()), ElementsAre(SeenTile{0, 0, 2}));
}

TEST_F(MapPublisherTest, SendsATileThatIsGoneEmptyAndOnce) {
  add_evidence({0, 0});
  add_evidence({100, 0});
  look();
  grid = mapping::OccupancyGrid();
  add_evidence({0, 0});
  EXPECT_THAT(tiles_in(look()), ElementsAre(SeenTile{1, 0, 0}));
  add_evidence({1, 0});
  EXPECT_THAT(tiles_in(look()), ElementsAre(SeenTile{0, 0, 2}));
}

TEST_F(MapPublisherTest, SendsTrailAndRoomOnceAStop) {
  add_evidence({0, 0});
  look();
  EXPECT_THAT(of_kind(*history, MessageKind::kTrail), IsEmpty());
  EXPECT_THAT(of_kind(*history, MessageKind::kRoom), IsEmpty());
  make_a_stop();
  look();
  add_evidence({1, 0});
  look();
  EXPECT_EQ(of_kind(*history, MessageKind::kTrail).size(), 1U);
  EXPECT_EQ(of_kind(*history, MessageKind::kRoom).size(), 1U);
  make_a_stop();
  look();
  EXPECT_EQ(of_kind(*history, MessageKind::kTrail).size(), 2U);
}

TEST_F(MapPublisherTest, LeavesOutPlacesOfTheTrailThatLieTogether) {
  std::vector<pipeline::StampedPose> trajectory;
  for (const double x_m : {0.0, 0.01, 0.02, 0.05, 0.06, 0.5}) {
    trajectory.push_back(tests::pose_at(x_m, {x_m, 1.0, 0.0}));
  }
  snapshot = tests::snapshot_of(grid, trajectory);
  look();
  const auto trails = of_kind(*history, MessageKind::kTrail);
  ASSERT_EQ(trails.size(), 1U);
  const std::string body = body_of(*trails.front());
  ASSERT_EQ(u32_at(body, 0), 3U);
  EXPECT_EQ(f32_at(body, 8), 0.0F);
  EXPECT_EQ(f32_at(body, 12), 1.0F);
  EXPECT_EQ(f32_at(body, 16), 0.05F);
  EXPECT_EQ(f32_at(body, 24), 0.5F);
}

TEST_F(MapPublisherTest, SendsTheRoomAsTheProtocolHasIt) {
  mapping::SonarFeatures features;
  features.walls = {{{0.0, -1.0}, {2.0, -1.0}}, {{2.0, -1.0}, {2.0, 1.0}}};
  features.circles = {{{0.5, 0.25}, 0.125, {}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  make_a_stop({{{0.0, 0.0, 0.0}, {0.5, 0.25, 1.0}, 1.5}, {{}, {0.5, 0.25, 2.0}, std::nullopt}});
  look();
  EXPECT_EQ(room()["walls"],
            nlohmann::json::parse("[[[0.0, -1.0], [2.0, -1.0]], [[2.0, -1.0], [2.0, 1.0]]]"));
  EXPECT_EQ(room()["cylinders"],
            nlohmann::json::parse(R"([{"at": [0.5, 0.25], "radius_m": 0.125}])"));
  EXPECT_EQ(room()["sweep"], nlohmann::json::parse(R"({"origin": [0.5, 0.25, 1.0],
                                 "bearings": [1.0, 2.0], "ranges_m": [1.5, null]})"));
  EXPECT_EQ(room()["outline"], nlohmann::json::array()) << "no floor is known yet";
}

TEST_F(MapPublisherTest, SendsTheOutlineOfTheFloorThatIsKnown) {
  for (int y = -20; y < 20; ++y) {
    for (int x = -30; x < 30; ++x) {
      grid.add({x, y}, x == -30 || x == 29 || y == -20 || y == 19 ? 400 : -400);
    }
  }
  add_evidence({0, 0});
  make_a_stop();
  look();
  const auto outline = room().at("outline");
  ASSERT_GE(outline.size(), 4U);
  for (const auto& point : outline) {
    ASSERT_EQ(point.size(), 2U);
    EXPECT_LE(std::abs(point[0].get<double>()), 1.6);
    EXPECT_LE(std::abs(point[1].get<double>()), 1.1);
  }
}

TEST_F(MapPublisherTest, AStopWithoutAReadingHasNoSweep) {
  make_a_stop();
  look();
  EXPECT_TRUE(room().at("sweep").is_null());
}

TEST_F(MapPublisherTest, ANewMapIsSentAsAWholeAndNothingOfTheOldOne) {
  add_evidence({0, 0});
  add_evidence({100, 0});
  make_a_stop();
  look();
  publisher.begin_new_map(5.0);
  const auto begins = of_kind(*history, MessageKind::kNewMap);
  ASSERT_EQ(begins.size(), 1U);
  EXPECT_EQ(begins.front()->time_s, 5.0);
  grid = mapping::OccupancyGrid();
  add_evidence({0, 0});
  EXPECT_THAT(tiles_in(look()), ElementsAre(SeenTile{0, 0, 1})) << "the same tile, and no other";
  EXPECT_EQ(of_kind(*history, MessageKind::kTrail).size(), 2U);
}

TEST_F(MapPublisherTest, SendsAMapWithoutAPath) {
  grid.add({0, 0}, 100);
  publisher.look_at(1.0, grid);
  EXPECT_THAT(tiles_in(history->since(0)), ElementsAre(SeenTile{0, 0, 1}));
  EXPECT_EQ(history->since(0).size(), 1U);
  EXPECT_EQ(publisher.changes(), 1U);
}

}  // namespace
}  // namespace echomap::live_page
