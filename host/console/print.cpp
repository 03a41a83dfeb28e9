// SPDX-License-Identifier: MIT
#include "host/console/print.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/console/drawn_in_place.hpp"

namespace echomap::console {

void print(const std::string& line) {
  if (spdlog::should_log(spdlog::level::info)) {
    make_way_for_a_line();
    fmt::print(stderr, "{}\n", line);
  }
}

}  // namespace echomap::console
