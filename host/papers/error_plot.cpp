// SPDX-License-Identifier: MIT
#include "host/papers/error_plot.hpp"

#include <algorithm>

#include <Eigen/Core>
#include <fmt/format.h>

#include "host/exports/map_view.hpp"
#include "host/papers/picture_file.hpp"

namespace echomap::papers {
namespace {

constexpr int kPlotWidthPx = 800;
constexpr int kPanelHeightPx = 240;
constexpr int kPanelLeftPx = 112;
constexpr int kPanelRightPx = 16;
constexpr int kPanelTopPx = 28;
constexpr int kPanelBottomPx = 28;
constexpr int kPlotTextScale = 2;
constexpr exports::Colour kPaper{255, 255, 255};

/// One curve's part of the plot.
class Panel {
 public:
  Panel(exports::Picture& picture, int top_px, std::size_t iterations, double limit_m)
      : picture_(picture),
        top_px_(top_px + kPanelTopPx),
        height_px_(kPanelHeightPx - kPanelTopPx - kPanelBottomPx),
        iterations_(static_cast<double>(std::max<std::size_t>(iterations, 2) - 1)),
        limit_m_(limit_m) {}

  void draw_axes(const std::string& title, std::size_t iterations) {
    picture_.draw_text(kPanelLeftPx, top_px_ - 20, title, kPlotTextScale, exports::kInkColour);
    for (const double value_m : {limit_m_, 0.0, -limit_m_}) {
      const Eigen::Vector2d from = place(0, value_m);
      picture_.draw_line(from, {place_right(), from.y()}, 1.0, exports::kUnknownColour);
      write_before(static_cast<int>(from.y()) - 7, fmt::format("{:.0f} mm", 1000.0 * value_m));
    }
    const int below_px = top_px_ + height_px_ + 8;
    picture_.draw_text(kPanelLeftPx, below_px, "iteration 1", kPlotTextScale, exports::kInkColour);
    const std::string last = std::to_string(iterations);
    picture_.draw_text(
        static_cast<int>(place_right()) - exports::Picture::text_width(last, kPlotTextScale),
        below_px,
        last,
        kPlotTextScale,
        exports::kInkColour);
  }
  void draw_curve(const std::vector<double>& values_m, double sign, exports::Colour colour) {
    for (std::size_t i = 1; i < values_m.size(); ++i) {
      picture_.draw_line(
          place(i - 1, sign * values_m[i - 1]), place(i, sign * values_m[i]), 1.5, colour);
    }
  }

 private:
  static double place_right() { return kPlotWidthPx - kPanelRightPx; }
  Eigen::Vector2d place(std::size_t i, double value_m) const {
    const double share = std::clamp(value_m / limit_m_, -1.0, 1.0);
    return {kPanelLeftPx + (place_right() - kPanelLeftPx) * static_cast<double>(i) / iterations_,
            top_px_ + 0.5 * height_px_ * (1.0 - share)};
  }
  void write_before(int y_px, const std::string& text) {
    picture_.draw_text(kPanelLeftPx - 8 - exports::Picture::text_width(text, kPlotTextScale),
                       y_px,
                       text,
                       kPlotTextScale,
                       exports::kInkColour);
  }

  exports::Picture& picture_;
  int top_px_;
  int height_px_;
  double iterations_;
  double limit_m_;
};

void draw_plot_legend(exports::Picture& picture, int y_px) {
  int x_px = kPanelLeftPx;
  for (const auto& [colour, text] : std::vector<exports::LegendEntry>{
           {exports::kVermilion, "error"}, {exports::kBlue, "3 standard deviations"}}) {
    picture.fill_rectangle(x_px, y_px, 14, 14, colour);
    picture.draw_text(x_px + 22, y_px, text, kPlotTextScale, exports::kInkColour);
    x_px += 46 + exports::Picture::text_width(text, kPlotTextScale);
  }
}

}  // namespace

std::vector<std::uint8_t> draw_errors(const std::filesystem::path& file,
                                      const std::vector<ErrorCurve>& curves,
                                      double limit_m) {
  const int panels_px = kPanelHeightPx * static_cast<int>(curves.size());
  exports::Picture picture(kPlotWidthPx, panels_px + 28, kPaper);
  int top_px = 0;
  for (const ErrorCurve& curve : curves) {
    Panel panel(picture, top_px, curve.error_m.size(), limit_m);
    panel.draw_axes(curve.title, curve.error_m.size());
    panel.draw_curve(curve.bound_m, 1.0, exports::kBlue);
    panel.draw_curve(curve.bound_m, -1.0, exports::kBlue);
    panel.draw_curve(curve.error_m, 1.0, exports::kVermilion);
    top_px += kPanelHeightPx;
  }
  draw_plot_legend(picture, panels_px + 4);
  return write_picture(picture, file);
}

}  // namespace echomap::papers
