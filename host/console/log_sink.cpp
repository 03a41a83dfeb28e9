// SPDX-License-Identifier: MIT
#include "host/console/log_sink.hpp"

#include "host/console/drawn_in_place.hpp"

namespace echomap::console {

LogSink::LogSink(std::FILE* out) : ansicolor_sink(out, spdlog::color_mode::automatic) {}

void LogSink::log(const spdlog::details::log_msg& message) {
  make_way_for_a_line();
  ansicolor_sink::log(message);
}

}  // namespace echomap::console
