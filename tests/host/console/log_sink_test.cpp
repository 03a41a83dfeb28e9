// SPDX-License-Identifier: MIT
#include "host/console/log_sink.hpp"

#include <memory>

#include <gtest/gtest.h>
#include <spdlog/logger.h>

#include "host/console/progress_bar.hpp"
#include "tests/host/console/terminal.hpp"

namespace echomap::console {
namespace {

TEST(LogSink, ItsLinesDoNotStandBehindAProgressBar) {
  const Terminal terminal;
  spdlog::logger log("test", std::make_shared<LogSink>(terminal.file()));
  log.set_pattern("%l: %v");
  ProgressBar bar(terminal.file());
  bar.show("4 stops");
  log.warn("the robot is away");
  log.warn("the robot is back");
  bar.show("5 stops");
  EXPECT_EQ(terminal.shown(),
            "\r\033[K4 stops\r\033[Kwarning: the robot is away\n"
            "warning: the robot is back\n"
            "\r\033[K5 stops");
}

}  // namespace
}  // namespace echomap::console
