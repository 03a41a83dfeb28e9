// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/apps/commands.hpp"
#include "host/console/interrupt.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"
#include "tests/host/apps/live_page_visit.hpp"
#include "tests/host/apps/said_by_command_line.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::apps {
namespace {

using testing::HasSubstr;

void write_run(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  tests::WrittenRecording recording(session::load_robot_profile("uno_2wd"));
  recording.add_stop(1.0);
  recording.save(folder / recording::kSessionFileName);
}

/// What a person sees who looks at the runs and then presses Ctrl-C.
std::string runs_seen_at(const std::string& url) {
  const std::uint16_t port = port_in(url);
  const std::string runs =
      live_page::WebClient(port).ask(live_page::get(port, "/api/v1/runs")).body;
  const auto kitchen = visited_history(port, "1");
  const bool has_tile = !of_kind(kitchen, live_page::MessageKind::kTile).empty();
  const bool is_obeyed =
      live_page::WebClient(port).ask(live_page::post(port, R"({"do": "stop"})")).status == 200;
  return runs + (has_tile ? " with tiles" : "") + (is_obeyed ? " obeys" : " obeys nobody");
}

TEST(ServeCommand, ShowsAllRunsUntilCtrlC) {
  const tests::ScratchFolder scratch;
  write_run(scratch / "first_map");
  write_run(scratch / "kitchen");
  const std::string said_file = scratch / "said";
  const std::string seen_file = scratch / "seen";
  const auto serve_and_interrupt = [&] {
    console::catch_interrupts();
    if (std::freopen(said_file.c_str(), "w", stderr) == nullptr) {
      std::_Exit(99);
    }
    std::thread person([&] {
      const bool is_served = tests::eventually([&] {
        std::fflush(stderr);
        return files::read_text_file(said_file).find("Ctrl-C") != std::string::npos;
      });
      files::write_text_file(
          seen_file, is_served ? runs_seen_at(files::read_text_file(said_file)) : "nothing");
      std::raise(SIGINT);
    });
    const ExitCode code =
        run_serve({{scratch / "first_map", scratch / "kitchen"}, page_at_any_port()});
    person.join();
    std::_Exit(static_cast<int>(code));
  };
  EXPECT_EXIT(serve_and_interrupt(), testing::ExitedWithCode(0), "");
  const std::string seen = files::read_text_file(seen_file);
  EXPECT_THAT(seen, HasSubstr(R"("id":"0","name":"first_map","live":false)"));
  EXPECT_THAT(seen, HasSubstr(R"("id":"1","name":"kitchen","live":false)"));
  EXPECT_THAT(seen, HasSubstr("with tiles obeys nobody"));
  EXPECT_THAT(files::read_text_file(said_file),
              testing::ContainsRegex("reading .*/first_map\nreading .*/kitchen\nlive page: http"));
}

TEST(ServeCommand, NeedsRunsThatAreThere) {
  const Said none = run({"serve"});
  EXPECT_EQ(none.code, ExitCode::kUsage);
  EXPECT_THAT(none.err, HasSubstr("runs is required"));
  const Said missing = run({"serve", "/nowhere/first_map"});
  EXPECT_EQ(missing.code, ExitCode::kUsage);
  EXPECT_THAT(missing.err, HasSubstr("/nowhere/first_map"));
}

TEST(ServeCommand, SaysWhichRunHasNoRecording) {
  const tests::ScratchFolder scratch;
  const Said said = run({"serve", scratch.path().string(), "--no-browser"});
  EXPECT_EQ(said.code, ExitCode::kRuntimeError);
  EXPECT_THAT(said.err, HasSubstr(scratch.path().string() + ": neither a run directory"));
  EXPECT_THAT(said.err, HasSubstr("next: "));
}

}  // namespace
}  // namespace echomap::apps
