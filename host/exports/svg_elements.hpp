// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exports/picture.hpp"

namespace echomap::exports {

/// A number with up to four decimals, none that is 0.
std::string svg_number(double number);

/// Both coordinates, with a blank between.
std::string svg_point(const Eigen::Vector2d& point);

/// Text of a profile or a file's name, as XML holds it.
std::string svg_escaped(const std::string& text);

/// Path data of a polyline, or of a polygon.
std::string svg_polyline(const std::vector<Eigen::Vector2d>& points);
std::string svg_polygon(const std::vector<Eigen::Vector2d>& corners);

/// Path data of a circle.
std::string svg_circle(const Eigen::Vector2d& center, double radius);

/// A path element of that id and that path data, filled.
std::string svg_filled(const std::string& id, Colour colour, const std::string& path);

/// The same as a line with round ends.
std::string svg_stroked(const std::string& id,
                        Colour colour,
                        double width,
                        const std::string& path);

/// A rectangle with a thin dark edge.
std::string svg_rectangle(const Eigen::Vector2d& corner,
                          const Eigen::Vector2d& size,
                          Colour colour);

/// A line of text; `from` is the left end of its base line.
std::string svg_text(const Eigen::Vector2d& from, double size, const std::string& text);

}  // namespace echomap::exports
