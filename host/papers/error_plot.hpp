// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace echomap::papers {

/// An error in each iteration of a filter and the bound that it is to stay within, both in metres.
struct ErrorCurve {
  std::string title;  ///< In the letters of picture_font.hpp.
  std::vector<double> error_m;
  std::vector<double> bound_m;  ///< As many as errors; drawn above and below zero.
};

/// Plots errors and bounds over the iterations, one curve below the other, within `limit_m` of
/// zero; what is beyond is drawn at the edge. Writes the plot to `file` and returns the bytes of
/// the PNG file. Throws files::FileError.
std::vector<std::uint8_t> draw_errors(const std::filesystem::path& file,
                                      const std::vector<ErrorCurve>& curves,
                                      double limit_m);

}  // namespace echomap::papers
