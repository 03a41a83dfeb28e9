// SPDX-License-Identifier: MIT
#include "host/exports/landmarks_csv.hpp"

#include <array>
#include <chrono>
#include <string>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

void write_landmarks_csv(const std::filesystem::path& path,
                         const std::vector<pipeline::SeenLandmark>& landmarks) {
  std::string text = "stamp_s,id,range_m,bearing_rad,x_m,y_m\n";
  for (const auto& seen : landmarks) {
    const std::array row{std::chrono::duration<double>(seen.stamp.time_since_epoch()).count(),
                         static_cast<double>(seen.id),
                         seen.range_m,
                         seen.bearing_rad,
                         seen.position_m.x(),
                         seen.position_m.y()};
    append_row(text, row, ',');
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::exports
