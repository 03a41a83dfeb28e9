// SPDX-License-Identifier: MIT
#include "host/exports/pose_graph_g2o.hpp"

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

void append_line(std::string& text,
                 std::string_view tag,
                 std::initializer_list<std::size_t> ids,
                 std::span<const double> values) {
  text += tag;
  for (const std::size_t id : ids) {
    text += ' ' + std::to_string(id);
  }
  text += ' ';
  append_row(text, values, ' ');
}

void append_edge(std::string& text, const slam::PoseEdge& edge) {
  const geometry::Pose2& T_from_to = edge.T_from_to;
  const Eigen::Matrix3d& known = edge.information;
  append_line(text,
              "EDGE_SE2",
              {edge.from, edge.to},
              std::array{T_from_to.x_m(),
                         T_from_to.y_m(),
                         T_from_to.heading_rad(),
                         known(0, 0),
                         known(0, 1),
                         known(0, 2),
                         known(1, 1),
                         known(1, 2),
                         known(2, 2)});
}

}  // namespace

void write_pose_graph_g2o(const std::filesystem::path& path, const slam::FactorGraph& graph) {
  const std::size_t nodes = graph.T_map_nodes.size();
  std::string text;
  for (std::size_t i = 0; i < nodes; ++i) {
    const geometry::Pose2& node = graph.T_map_nodes[i];
    append_line(text, "VERTEX_SE2", {i}, std::array{node.x_m(), node.y_m(), node.heading_rad()});
  }
  for (std::size_t i = 0; i < graph.landmarks_m.size(); ++i) {
    const Eigen::Vector2d& place_m = graph.landmarks_m[i];
    append_line(text, "VERTEX_XY", {nodes + i}, std::array{place_m.x(), place_m.y()});
  }
  text += nodes > 0 ? "FIX 0\n" : "";
  for (const slam::PoseEdge& edge : graph.edges) {
    append_edge(text, edge);
  }
  for (const slam::LandmarkEdge& edge : graph.landmark_edges) {
    const Eigen::Matrix2d& known = edge.information;
    append_line(
        text,
        "EDGE_SE2_XY",
        {edge.from, nodes + edge.landmark},
        std::array{edge.place_m.x(), edge.place_m.y(), known(0, 0), known(0, 1), known(1, 1)});
  }
  for (const geometry::Segment& wall : graph.walls) {
    append_line(text,
                "# WALL",
                {},
                std::array{wall.from_m.x(), wall.from_m.y(), wall.to_m.x(), wall.to_m.y()});
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::exports
