// SPDX-License-Identifier: MIT
#include "host/team_map/join_tree.hpp"

#include <gtest/gtest.h>

namespace echomap::team_map {
namespace {

using geometry::Pose2;

const Pose2 kAB(2.0, 0.0, 1.0);
const Pose2 kBC(0.0, 3.0, -0.5);

MapLink link(const std::string& one, const std::string& other, const Pose2& T, double weight) {
  return {one, other, T, weight, {1.0, 1.0}};
}

TEST(JoinTree, HasEachMapForItselfWithoutLinks) {
  const JoinTree tree = join_tree({"b", "a"}, {}, {});
  ASSERT_EQ(tree.components.size(), 2U);
  EXPECT_EQ(tree.components[0].robots, std::vector<std::string>{"a"});
  EXPECT_EQ(tree.components[1].robots, std::vector<std::string>{"b"});
  EXPECT_TRUE(tree.contradicted.empty());
}

TEST(JoinTree, ReachesMapsByWayOfOthersInTheFrameOfTheFirst) {
  const JoinTree tree =
      join_tree({"a", "b", "c", "d"}, {link("b", "c", kBC, 9.0), link("a", "b", kAB, 5.0)}, {});
  ASSERT_EQ(tree.components.size(), 2U);
  EXPECT_EQ(tree.components[0].robots, (std::vector<std::string>{"a", "b", "c"}));
  const Pose2 expected = kAB * kBC;
  EXPECT_EQ(tree.components[0].T_first_maps[0].x_m(), 0.0);
  EXPECT_NEAR(tree.components[0].T_first_maps[2].x_m(), expected.x_m(), 1e-9);
  EXPECT_NEAR(tree.components[0].T_first_maps[2].y_m(), expected.y_m(), 1e-9);
  EXPECT_NEAR(tree.components[0].T_first_maps[2].heading_rad(), expected.heading_rad(), 1e-9);
}

TEST(JoinTree, KeepsACycleThatCloses) {
  const Pose2 nearly = kAB * kBC * Pose2(0.2, 0.1, 0.05);
  const JoinTree tree =
      join_tree({"a", "b", "c"},
                {link("a", "b", kAB, 5.0), link("a", "c", nearly, 1.0), link("b", "c", kBC, 9.0)},
                {});
  EXPECT_TRUE(tree.contradicted.empty());
}

TEST(JoinTree, GivesUpTheWeakestLinkOfACycleThatDoesNotClose) {
  const Pose2 turned = kAB * kBC * Pose2(0.0, 0.0, 3.1);
  const Pose2 shifted = kAB * kBC * Pose2(1.0, 0.0, 0.0);
  for (const Pose2& wrong : {turned, shifted}) {
    const JoinTree tree =
        join_tree({"a", "b", "c"},
                  {link("a", "c", wrong, 1.0), link("a", "b", kAB, 5.0), link("b", "c", kBC, 9.0)},
                  {});
    EXPECT_EQ(tree.contradicted, std::vector<std::size_t>{0});
    ASSERT_EQ(tree.components.size(), 1U);
    EXPECT_NEAR(tree.components[0].T_first_maps[2].x_m(), (kAB * kBC).x_m(), 1e-9);
  }
}

TEST(JoinTree, NamesTheWeakestLinkOfAWay) {
  const std::vector<MapLink> links{
      link("a", "b", kAB, 5.0), link("b", "c", kBC, 9.0), link("c", "d", kAB, 2.0)};
  EXPECT_EQ(weakest_between("a", "c", links), 0U);
  EXPECT_EQ(weakest_between("b", "c", links), 1U);
  EXPECT_EQ(weakest_between("a", "d", links), 2U);
  EXPECT_EQ(weakest_between("a", "e", links), links.size());
}

}  // namespace
}  // namespace echomap::team_map
