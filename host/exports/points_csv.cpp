// SPDX-License-Identifier: MIT
#include "host/exports/points_csv.hpp"

#include <array>
#include <cmath>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

constexpr NumberTableFormat kFormat{"x_m,y_m,pose_index", ',', 3};

}  // namespace

void write_points_csv(const std::filesystem::path& path,
                      const std::vector<mapping::MapPoint>& points) {
  std::string text(kFormat.header);
  text.push_back('\n');
  for (const auto& point : points) {
    const std::array row{
        point.position_m.x(), point.position_m.y(), static_cast<double>(point.pose_index)};
    append_row(text, row, kFormat.separator);
  }
  files::write_text_file(path, text);
}

std::vector<mapping::MapPoint> read_points_csv(const std::filesystem::path& path) {
  std::vector<mapping::MapPoint> points;
  for (const auto& [row, line] : read_number_table(path, kFormat)) {
    const bool is_index = row[2] >= 0.0 && row[2] < 4294967296.0 && row[2] == std::floor(row[2]);
    if (!is_index) {
      fail_at_line(path, line, "pose_index must be a whole number from 0");
    }
    points.push_back({{row[0], row[1]}, static_cast<std::size_t>(row[2])});
  }
  return points;
}

}  // namespace echomap::exports
