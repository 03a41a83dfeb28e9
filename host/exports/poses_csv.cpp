// SPDX-License-Identifier: MIT
#include "host/exports/poses_csv.hpp"

#include <array>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

constexpr NumberTableFormat kPosesFormat{"x_m,y_m,heading_rad", ',', 3};

}  // namespace

void write_poses_csv(const std::filesystem::path& path, const std::vector<geometry::Pose2>& poses) {
  std::string text(kPosesFormat.header);
  text.push_back('\n');
  for (const auto& pose : poses) {
    append_row(
        text, std::array{pose.x_m(), pose.y_m(), pose.heading_rad()}, kPosesFormat.separator);
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::exports
