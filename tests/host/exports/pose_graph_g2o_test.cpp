// SPDX-License-Identifier: MIT
#include "host/exports/pose_graph_g2o.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using geometry::Pose2;

/// No number of it is short, as decimals go.
slam::FactorGraph odd_graph() {
  const double third = 1.0 / 3.0;
  Eigen::Matrix3d information;
  information << 1e4 * third, 0.1, -0.7, 0.1, 2e17 * third, third, -0.7, third, 1e-9;
  Eigen::Matrix2d of_place;
  of_place << 40.0 * third, -0.3, -0.3, 17.0;
  return {{{}, {third, -1e5, 0.1}, {4321.0987654321, 2.0 * third, -3.0}},
          {{third, 7.0}, {-0.1, 1e-20}},
          {{0, 1, {third, 0.2, 0.3}, information, false},
           {2, 0, {-third, 1e6, -0.3}, 7.0 * information, false}},
          {{1, 0, {0.7, third}, of_place}, {2, 1, {0.1, 0.2}, 3.0 * of_place}}};
}

Eigen::Matrix3d read_information(std::istream& in) {
  Eigen::Matrix3d information;
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) {
      in >> information(row, column);
      information(column, row) = information(row, column);
    }
  }
  return information;
}

Pose2 read_pose(std::istream& in) {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
  in >> x_m >> y_m >> heading_rad;
  return {x_m, y_m, heading_rad};
}

/// Takes the lines in any order, as long as poses come before landmarks.
slam::FactorGraph read(const std::filesystem::path& path) {
  slam::FactorGraph graph;
  std::ifstream in(path);
  std::string tag;
  while (in >> tag) {
    std::size_t id = 0;
    std::size_t to = 0;
    in >> id;
    if (tag == "VERTEX_SE2") {
      EXPECT_EQ(id, graph.T_map_nodes.size());
      graph.T_map_nodes.push_back(read_pose(in));
    } else if (tag == "VERTEX_XY") {
      EXPECT_EQ(id, graph.T_map_nodes.size() + graph.landmarks_m.size());
      Eigen::Vector2d& place_m = graph.landmarks_m.emplace_back();
      in >> place_m.x() >> place_m.y();
    } else if (tag == "EDGE_SE2") {
      in >> to;
      const Pose2 T_from_to = read_pose(in);
      graph.edges.push_back({id, to, T_from_to, read_information(in), false});
    } else if (tag == "EDGE_SE2_XY") {
      slam::LandmarkEdge edge{id, 0, {}, {}};
      in >> to >> edge.place_m.x() >> edge.place_m.y() >> edge.information(0, 0) >>
          edge.information(0, 1) >> edge.information(1, 1);
      edge.information(1, 0) = edge.information(0, 1);
      edge.landmark = to - graph.T_map_nodes.size();
      graph.landmark_edges.push_back(edge);
    } else {
      EXPECT_EQ(tag, "FIX");
      EXPECT_EQ(id, 0U);
    }
  }
  return graph;
}

void expect_same(const Pose2& read, const Pose2& written) {
  EXPECT_EQ(read.position_m(), written.position_m());
  EXPECT_EQ(read.heading_rad(), written.heading_rad());
}

TEST(PoseGraphG2o, ReadsBackTheSameNumbers) {
  const tests::ScratchFolder folder;
  const slam::FactorGraph written = odd_graph();
  write_pose_graph_g2o(folder / "a.g2o", written);
  const slam::FactorGraph graph = read(folder / "a.g2o");
  ASSERT_EQ(graph.T_map_nodes.size(), written.T_map_nodes.size());
  for (std::size_t i = 0; i < written.T_map_nodes.size(); ++i) {
    expect_same(graph.T_map_nodes[i], written.T_map_nodes[i]);
  }
  EXPECT_EQ(graph.landmarks_m, written.landmarks_m);
  ASSERT_EQ(graph.edges.size(), written.edges.size());
  for (std::size_t i = 0; i < written.edges.size(); ++i) {
    EXPECT_EQ(graph.edges[i].from, written.edges[i].from);
    EXPECT_EQ(graph.edges[i].to, written.edges[i].to);
    expect_same(graph.edges[i].T_from_to, written.edges[i].T_from_to);
    EXPECT_EQ(graph.edges[i].information, written.edges[i].information);
  }
  ASSERT_EQ(graph.landmark_edges.size(), written.landmark_edges.size());
  for (std::size_t i = 0; i < written.landmark_edges.size(); ++i) {
    EXPECT_EQ(graph.landmark_edges[i].from, written.landmark_edges[i].from);
    EXPECT_EQ(graph.landmark_edges[i].landmark, written.landmark_edges[i].landmark);
    EXPECT_EQ(graph.landmark_edges[i].place_m, written.landmark_edges[i].place_m);
    EXPECT_EQ(graph.landmark_edges[i].information, written.landmark_edges[i].information);
  }
}

TEST(PoseGraphG2o, HasTheFieldsOfTheFormat) {
  const tests::ScratchFolder folder;
  Eigen::Matrix3d information;
  information << 11.0, 12.0, 13.0, 12.0, 22.0, 23.0, 13.0, 23.0, 33.0;
  Eigen::Matrix2d of_place;
  of_place << 44.0, 45.0, 45.0, 55.0;
  write_pose_graph_g2o(folder / "a.g2o",
                       {{{}, {1.0, 2.0, 0.5}},
                        {{3.0, 4.0}},
                        {{0, 1, {1.5, 2.5, 0.25}, information, false}},
                        {{1, 0, {6.0, 7.0}, of_place}},
                        {{{1.0, 2.0}, {3.0, 4.5}}}});
  EXPECT_EQ(files::read_text_file(folder / "a.g2o"),
            "VERTEX_SE2 0 0 0 0\n"
            "VERTEX_SE2 1 1 2 0.5\n"
            "VERTEX_XY 2 3 4\n"
            "FIX 0\n"
            "EDGE_SE2 0 1 1.5 2.5 0.25 11 12 13 22 23 33\n"
            "EDGE_SE2_XY 1 2 6 7 44 45 55\n"
            "# WALL 1 2 3 4.5\n");
}

TEST(PoseGraphG2o, NumbersOfManyPosesAreNotRounded) {
  const tests::ScratchFolder folder;
  slam::FactorGraph graph;
  graph.T_map_nodes.resize(100001);
  write_pose_graph_g2o(folder / "a.g2o", graph);
  EXPECT_NE(files::read_text_file(folder / "a.g2o").find("VERTEX_SE2 100000 0 0 0\n"),
            std::string::npos);
}

TEST(PoseGraphG2o, OfNothingIsEmpty) {
  const tests::ScratchFolder folder;
  write_pose_graph_g2o(folder / "a.g2o", {});
  EXPECT_EQ(files::read_text_file(folder / "a.g2o"), "");
}

}  // namespace
}  // namespace echomap::exports
