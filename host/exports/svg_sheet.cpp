// SPDX-License-Identifier: MIT
#include "host/exports/svg_sheet.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "host/exports/svg_elements.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::exports {
namespace {

/// What of A4 is left beside the margins, the title and the legend.
const Eigen::Vector2d kPageMm(180.0, 230.0);
constexpr double kMarginMm = 6.0;
constexpr double kHeaderMm = 8.0;
constexpr double kFooterMm = 14.0;
constexpr double kLineMm = 6.0;
constexpr double kSwatchMm = 3.6;
constexpr double kFontMm = 3.8;
/// Of a letter, on average.
constexpr double kLetterMm = 0.6 * kFontMm;
constexpr double kBarMm = 0.6;
constexpr double kGridMm = 0.18;

/// Of maps and plans: 1, 2 or 5 times a power of ten, not larger than 1 : 5.
double scale_for(const Eigen::Vector2d& size_m) {
  const double least = 1000.0 * (size_m.array() / kPageMm.array()).maxCoeff();
  for (double decade = 1.0;; decade *= 10.0) {
    for (const double scale : {1.0, 2.0, 5.0}) {
      if (scale * decade >= std::max(5.0, least)) {
        return scale * decade;
      }
    }
  }
}

double width_mm(const std::string& text) { return kLetterMm * static_cast<double>(text.size()); }

}  // namespace

SvgSheet::SvgSheet(const PictureFrame& frame, std::string title, std::vector<LegendEntry> legend)
    : frame_(frame),
      title_(std::move(title)),
      legend_(std::move(legend)),
      scale_(scale_for(frame.size_m)),
      map_corner_mm_(kMarginMm, kMarginMm + kHeaderMm),
      map_size_mm_(1000.0 / scale_ * frame.size_m) {
  title_ += fmt::format("{}1 : {:.0f}", title_.empty() ? "" : ", ", scale_);
  for (const LegendEntry& entry : legend_) {
    column_mm_ = std::max(column_mm_, 3.0 * kSwatchMm + width_mm(entry.text));
  }
  const double inner_mm =
      std::max({map_size_mm_.x(), width_mm(title_), column_mm_, scale_width_mm()});
  columns_ = legend_.empty() ? 1 : static_cast<std::size_t>(inner_mm / column_mm_);
  const std::size_t lines = (legend_.size() + columns_ - 1) / columns_;
  size_mm_ = {inner_mm + 2.0 * kMarginMm,
              map_corner_mm_.y() + map_size_mm_.y() + kFooterMm +
                  kLineMm * static_cast<double>(lines) + kMarginMm};
}

std::string SvgSheet::header() const {
  const double per_m = 1000.0 / scale_;
  const Eigen::Vector2d origin_mm(map_corner_mm_.x() - per_m * frame_.low_m.x(),
                                  map_corner_mm_.y() + map_size_mm_.y() + per_m * frame_.low_m.y());
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"0 0 {0} {1}\">\n<title>echomap: metres in the map frame</title>\n",
      svg_number(size_mm_.x()),
      svg_number(size_mm_.y()));
  const std::string map = svg_rectangle(map_corner_mm_, map_size_mm_, kUnknownColour);
  text += svg_rectangle({0.0, 0.0}, size_mm_, kFloorColour) + map + "<clipPath id=\"map\">" + map +
          "</clipPath>\n";
  text += svg_text({kMarginMm, kMarginMm + kFontMm}, kFontMm, title_);
  const std::string turn = frame_.turn_rad == 0.0
                               ? ""
                               : " rotate(" + svg_number(geometry::degrees(-frame_.turn_rad)) + ")";
  return text + "<g clip-path=\"url(#map)\"><g transform=\"translate(" + svg_point(origin_mm) +
         ") scale(" + svg_number(per_m) + ",-" + svg_number(per_m) + ")" + turn + "\">\n";
}

Eigen::Vector2d SvgSheet::legend_place(std::size_t entry) const {
  const std::size_t line = entry / columns_;
  const std::size_t column = entry % columns_;
  return {kMarginMm + static_cast<double>(column) * column_mm_,
          map_corner_mm_.y() + map_size_mm_.y() + kFooterMm + static_cast<double>(line) * kLineMm};
}

double SvgSheet::bar_m() const { return scale_bar_m(metres(map_size_mm_.x() / 3.0)); }

std::string SvgSheet::bar_text() const {
  return scale_text(bar_m(), grid_spacing_m(frame_.size_m));
}

double SvgSheet::scale_width_mm() const {
  return kBarMm + 1000.0 / scale_ * bar_m() + kSwatchMm + width_mm(bar_text());
}

std::string SvgSheet::grid() const {
  const double spacing_m = grid_spacing_m(frame_.size_m);
  const Eigen::Vector2d high_m = frame_.low_m + frame_.size_m;
  std::string path;
  const auto add_line = [&](const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
    path += svg_polyline({frame_.in_map_m(from_m), frame_.in_map_m(to_m)});
  };
  const Eigen::Vector2d first = (frame_.low_m / spacing_m).array().ceil();
  const Eigen::Vector2d end = (high_m / spacing_m).array().ceil();
  for (int i = static_cast<int>(first.x()); i < end.x(); ++i) {
    add_line({i * spacing_m, frame_.low_m.y()}, {i * spacing_m, high_m.y()});
  }
  for (int i = static_cast<int>(first.y()); i < end.y(); ++i) {
    add_line({frame_.low_m.x(), i * spacing_m}, {high_m.x(), i * spacing_m});
  }
  return svg_stroked("grid", kGridColour, metres(kGridMm), path);
}

std::string SvgSheet::footer() const {
  const double length_m = bar_m();
  const double length_mm = 1000.0 / scale_ * length_m;
  const Eigen::Vector2d from_mm(kMarginMm + kBarMm,
                                map_corner_mm_.y() + map_size_mm_.y() + kFooterMm / 2.0);
  const Eigen::Vector2d tick_mm(0.0, 1.5);
  std::string text =
      "</g></g>\n" + svg_stroked("scale",
                                 kInkColour,
                                 kBarMm,
                                 "M" + svg_point(from_mm) + "h" + svg_number(length_mm) +
                                     "m0 -1.5v3M" + svg_point(from_mm - tick_mm) + "v3");
  text += svg_text(
      {from_mm.x() + length_mm + kSwatchMm, from_mm.y() + 0.35 * kFontMm}, kFontMm, bar_text());
  for (std::size_t i = 0; i < legend_.size(); ++i) {
    const Eigen::Vector2d place_mm = legend_place(i);
    text += svg_rectangle(place_mm, {kSwatchMm, kSwatchMm}, legend_[i].colour);
    text += svg_text({place_mm.x() + 1.5 * kSwatchMm, place_mm.y() + 0.85 * kSwatchMm},
                     kFontMm,
                     legend_[i].text);
  }
  return text + "</svg>\n";
}

}  // namespace echomap::exports
