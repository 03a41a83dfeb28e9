// SPDX-License-Identifier: MIT
#include "tests/benchmarks/reliability.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"

namespace echomap::bench {

namespace {

constexpr double kSide = 320.0;
constexpr double kMargin = 50.0;

double x_of(double probability) { return kMargin + kSide * probability; }
double y_of(double frequency) { return kMargin / 2.0 + kSide * (1.0 - frequency); }

std::string disc(const Reliability::Bin& bin, std::size_t all) {
  const double share = static_cast<double>(bin.told) / static_cast<double>(all);
  return fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"#1f6feb\" fill-opacity=\"0.7\"/>\n"
      "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
      x_of(bin.mean_probability()),
      y_of(bin.frequency()),
      std::max(3.0, 30.0 * std::sqrt(share)),
      x_of(bin.mean_probability()) + 8.0,
      y_of(bin.frequency()) + 16.0,
      bin.told);
}

std::string axes() {
  std::string svg = fmt::format(
      "<rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{2}\" fill=\"none\" stroke=\"#57606a\"/>\n"
      "<line x1=\"{3}\" y1=\"{4}\" x2=\"{5}\" y2=\"{6}\" stroke=\"#57606a\" "
      "stroke-dasharray=\"4\"/>\n",
      x_of(0.0),
      y_of(1.0),
      kSide,
      x_of(0.0),
      y_of(0.0),
      x_of(1.0),
      y_of(1.0));
  for (const double tick : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    svg += fmt::format(
        "<text x=\"{:.0f}\" y=\"{:.0f}\">{:.1f}</text>\n<text x=\"{:.0f}\" "
        "y=\"{:.0f}\">{:.1f}</text>\n",
        x_of(tick) - 9.0,
        y_of(0.0) + 18.0,
        tick,
        x_of(0.0) - 26.0,
        y_of(tick) + 4.0,
        tick);
  }
  return svg +
         fmt::format(
             "<text x=\"{:.0f}\" y=\"{:.0f}\">told: probability of being lost</text>\n"
             "<text transform=\"translate(14 {:.0f}) rotate(-90)\">share that was lost</text>\n",
             x_of(0.2),
             y_of(0.0) + 36.0,
             y_of(0.3));
}

}  // namespace

void Reliability::add(double probability, bool has_happened) {
  Bin& bin = bins_[std::min<std::size_t>(9, static_cast<std::size_t>(10.0 * probability))];
  ++bin.told;
  bin.probability_sum += probability;
  bin.happened += has_happened ? 1 : 0;
}

std::size_t Reliability::count() const {
  std::size_t all = 0;
  for (const Bin& bin : bins_) {
    all += bin.told;
  }
  return all;
}

double Reliability::mean_error() const {
  double sum = 0.0;
  for (const Bin& bin : bins_) {
    sum += std::abs(static_cast<double>(bin.happened) - bin.probability_sum);
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, count()));
}

void write_reliability_svg(const Reliability& reliability, const std::filesystem::path& path) {
  const double width = kMargin + kSide + kMargin / 2.0;
  const double height = kMargin / 2.0 + kSide + kMargin;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"white\"/>\n{2}",
      width,
      height,
      axes());
  for (const Reliability::Bin& bin : reliability.bins()) {
    if (bin.told > 0) {
      svg += disc(bin, reliability.count());
    }
  }
  files::write_text_file(path, svg + "</svg>\n");
}

}  // namespace echomap::bench
