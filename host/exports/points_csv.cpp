// SPDX-License-Identifier: MIT
#include "host/exports/points_csv.hpp"

#include <array>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

constexpr NumberTableFormat kPointsFormat{"x_m,y_m,pose_index", ',', 3};

}  // namespace

void write_points_csv(const std::filesystem::path& path,
                      const std::vector<mapping::MapPoint>& points) {
  std::string text(kPointsFormat.header);
  text.push_back('\n');
  for (const auto& point : points) {
    const std::array row{
        point.position_m.x(), point.position_m.y(), static_cast<double>(point.pose_index)};
    append_row(text, row, kPointsFormat.separator);
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::exports
