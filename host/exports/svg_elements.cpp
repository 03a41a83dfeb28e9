// SPDX-License-Identifier: MIT
#include "host/exports/svg_elements.hpp"

#include <fmt/format.h>

namespace echomap::exports {
namespace {

std::string hex_of(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

}  // namespace

std::string svg_number(double number) {
  std::string text = fmt::format("{:.4f}", number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string svg_point(const Eigen::Vector2d& point) {
  return svg_number(point.x()) + " " + svg_number(point.y());
}

std::string svg_escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        escaped += "&lt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

std::string svg_polyline(const std::vector<Eigen::Vector2d>& points) {
  std::string path;
  for (const Eigen::Vector2d& point : points) {
    path += (path.empty() ? "M" : "L") + svg_point(point);
  }
  return path;
}

std::string svg_polygon(const std::vector<Eigen::Vector2d>& corners) {
  return corners.empty() ? "" : svg_polyline(corners) + "z";
}

std::string svg_circle(const Eigen::Vector2d& center, double radius) {
  const std::string half_turn = "a" + svg_number(radius) + " " + svg_number(radius) + " 0 1 0 ";
  const std::string diameter = svg_number(2.0 * radius);
  return "M" + svg_point({center.x() - radius, center.y()}) + half_turn + diameter + " 0" +
         half_turn + "-" + diameter + " 0z";
}

std::string svg_filled(const std::string& id, Colour colour, const std::string& path) {
  return "<path id=\"" + id + "\" fill=\"" + hex_of(colour) + "\" d=\"" + path + "\"/>\n";
}

std::string svg_stroked(const std::string& id,
                        Colour colour,
                        double width,
                        const std::string& path) {
  return "<path id=\"" + id + "\" fill=\"none\" stroke=\"" + hex_of(colour) + "\" stroke-width=\"" +
         svg_number(width) + "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"" + path +
         "\"/>\n";
}

std::string svg_rectangle(const Eigen::Vector2d& corner,
                          const Eigen::Vector2d& size,
                          Colour colour) {
  return fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"#141414\" "
      "stroke-width=\"0.2\"/>\n",
      svg_number(corner.x()),
      svg_number(corner.y()),
      svg_number(size.x()),
      svg_number(size.y()),
      hex_of(colour));
}

std::string svg_text(const Eigen::Vector2d& from, double size, const std::string& text) {
  return fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" font-family=\"sans-serif\">{}</text>\n",
      svg_number(from.x()),
      svg_number(from.y()),
      svg_number(size),
      svg_escaped(text));
}

}  // namespace echomap::exports
