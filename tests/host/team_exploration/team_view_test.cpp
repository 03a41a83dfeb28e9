// SPDX-License-Identifier: MIT
#include "host/team_exploration/team_view.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "tests/host/team_exploration/team_rooms.hpp"

namespace echomap::team_exploration {
namespace {

TEST(TeamView, IsCompanyThatStandsAboutAndHasPromisedLooks) {
  TeamView view;
  view.grid = std::make_shared<const mapping::OccupancyGrid>(tests::open_hall());
  view.peers = {tests::peer_at("b", {1.0, 2.0, 0.5})};
  view.peers.front().position_stddev_m = 0.05;
  view.claims = {{"b", {3.0, 2.0}, 0.4, 2.5, ""}};
  const auto company = company_of(view);
  EXPECT_EQ(company.grid, view.grid);
  EXPECT_EQ(company.scans, nullptr);
  ASSERT_EQ(company.standing.size(), 1U);
  EXPECT_EQ(company.standing.front().at_m, Eigen::Vector2d(1.0, 2.0));
  EXPECT_NEAR(company.standing.front().radius_m, 0.14, 1e-12) << "as far as it may be off";
  ASSERT_EQ(company.promised.size(), 1U);
  EXPECT_EQ(company.promised.front().at_m, Eigen::Vector2d(3.0, 2.0));
  EXPECT_EQ(company.promised.front().reach_m, 2.5);
  EXPECT_EQ(company.promised.front().utility, 0.4);
}

}  // namespace
}  // namespace echomap::team_exploration
