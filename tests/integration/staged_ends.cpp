// SPDX-License-Identifier: MIT
#include "tests/integration/staged_ends.hpp"

#include <algorithm>
#include <csignal>
#include <regex>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"

namespace echomap::test {
namespace {

namespace fs = std::filesystem;

/// A robot without cliff sensors lies on its belly there, and its wheels turn.
constexpr const char* kHoleInTheFloor = R"(name = "hole_in_the_floor"
[start]
x_m = 0.5
y_m = 0.8
heading_deg = 0.0
[room]
corners_m = [[0.0, 0.0], [2.4, 0.0], [2.4, 1.6], [0.0, 1.6]]
[[hole]]
name = "all across"
corners_m = [[0.9, 0.0], [1.2, 0.0], [1.2, 1.6], [0.9, 1.6]]
)";

/// From its middle, every wall is out of the sonar's range.
constexpr const char* kLargeEmptyHall = R"(name = "large_empty_hall"
[start]
x_m = 6.0
y_m = 6.0
heading_deg = 20.0
[room]
corners_m = [[0.0, 0.0], [12.0, 0.0], [12.0, 12.0], [0.0, 12.0]]
)";

/// Two rooms and a gap of 0.22 m between them, for a robot of 0.18 m that keeps 4 cm off walls. The
/// cone of the sonar is wider than the gap: its sides answer, and nobody knows of the other room.
constexpr const char* kNarrowGap = R"(name = "narrow_gap"
[start]
x_m = 0.6
y_m = 0.8
heading_deg = 0.0
[room]
corners_m = [[0.0, 0.0], [3.2, 0.0], [3.2, 1.6], [0.0, 1.6]]
[[obstacle]]
name = "one side of the gap"
corners_m = [[1.60, 0.00], [1.70, 0.00], [1.70, 0.69], [1.60, 0.69]]
[[obstacle]]
name = "the other side"
corners_m = [[1.60, 0.91], [1.70, 0.91], [1.70, 1.60], [1.60, 1.60]]
)";

/// A robot at a port, as a real one is, until the host has gone. Throws std::runtime_error where it
/// does not come.
class RobotAtAPort {
 public:
  RobotAtAPort(const StageFolder& folder, std::vector<std::string> options)
      : robot_("echomap-mock", at_port(folder, std::move(options)), folder.root / "robot_log") {
    if (!eventually([&] { return exists(folder.lockstep) && exists(folder.port); })) {
      throw std::runtime_error("the emulated robot did not start");
    }
  }

 private:
  static std::vector<std::string> at_port(const StageFolder& folder,
                                          std::vector<std::string> options) {
    options.insert(options.end(),
                   {"--link=" + folder.port.string(), "--lockstep=" + folder.lockstep.string()});
    return options;
  }

  Program robot_;
};

std::vector<std::string> explore_at_port(const StageFolder& folder,
                                         const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"explore",
                                     "--headless",
                                     "--port=" + folder.port.string(),
                                     "--lockstep=" + folder.lockstep.string(),
                                     "--out=" + folder.run.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Option with a bundled file of the robot uno_2wd that has a wheel-drop switch at its first spare
/// pin.
std::string with_wheel_drop(const StageFolder& folder,
                            const std::string& bundled,
                            const std::string& wiring) {
  const fs::path path = folder.root / (wiring + ".toml");
  files::write_text_file(path,
                         files::read_text_file(files::bundled_file("uno_2wd", bundled, "a robot")) +
                             "\n[" + wiring + "]\npin_0 = \"wheel_drop\"\n");
  return "--robot=" + path.string();
}

/// The robot is lifted and not put down.
Ended lift(const StageFolder& folder) {
  const RobotAtAPort robot(folder,
                           {"--world=nxt_room",
                            "--kidnap=30,100000,1,1,0",
                            with_wheel_drop(folder, "hil_mock/robots", "wiring.native")});
  const auto arguments =
      explore_at_port(folder, {with_wheel_drop(folder, "host/profiles", "wiring")});
  return Program("echomap", arguments, folder.root / "log").wait();
}

/// The user stops the run, by Ctrl-C, once something is saved.
Ended interrupt(const StageFolder& folder) {
  const RobotAtAPort robot(folder, {"--world=living_room"});
  Program host("echomap", explore_at_port(folder), folder.root / "log");
  if (!eventually([&] { return exists(folder.run / "summary.json"); })) {
    throw std::runtime_error("the run did not save its first stop");
  }
  host.send(SIGINT);
  return host.wait();
}

std::string without_names(const StageFolder& folder, const std::string& said) {
  const std::size_t begin = std::min(said.find("finished: the map"), said.find("echomap: error"));
  std::string text = begin == std::string::npos ? said : said.substr(begin);
  for (const auto& [path, word] : {std::pair(folder.run, "RUN"),
                                   std::pair(folder.world, "WORLD"),
                                   std::pair(folder.port, "PORT"),
                                   std::pair(folder.lockstep, "LOCKSTEP")}) {
    for (std::size_t at = 0; (at = text.find(path.string(), at)) != std::string::npos;) {
      text.replace(at, path.string().size(), word);
    }
  }
  text = std::regex_replace(text, std::regex("lost /[^:]*:"), "lost PORT:");
  return std::regex_replace(text, std::regex("-?[0-9]+(\\.[0-9]+)?"), "N");
}

/// Null where there is no such field.
nlohmann::json field(const nlohmann::json& summary, const char* name) {
  return summary.value(name, nlohmann::json());
}

std::string field_text(const nlohmann::json& summary, const char* name) {
  const nlohmann::json value = field(summary, name);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void find_differences_in_summary(const StagedEnd& golden,
                                 const StagedRun& run,
                                 std::vector<std::string>& found) {
  const nlohmann::json& summary = *run.summary;
  if (const std::string outcome = field_text(summary, "outcome"); outcome != golden.outcome) {
    found.push_back(
        fmt::format("summary.json has outcome = {} in place of {}", outcome, golden.outcome));
  }
  if (const auto finished = field(summary, "finished"); finished != (golden.status == 0)) {
    found.push_back("summary.json has finished = " + finished.dump());
  }
  const std::string why = field_text(summary, "why");
  const std::string next = "\n  next: " + field_text(summary, "next") + "\n";
  if (run.ended.said.find(why) == std::string::npos) {
    found.push_back("only summary.json has the reason: " + why);
  }
  if (run.ended.said.find(next) == std::string::npos) {
    found.push_back("only summary.json has the next step:" + next);
  }
  const auto mapped_m2 = field(summary, "free_area_m2");
  if (golden.mapped_m2 &&
      !(mapped_m2.is_number() && mapped_m2 > *golden.mapped_m2 && run.saved.count("map.png") > 0)) {
    found.push_back("the map so far is not saved");
  }
}

std::vector<StagedEnd> make_ends() {
  return {
      {"Finished",
       demo_stage({"--world=nxt_room"}),
       0,
       "complete",
       "finished: the map has N % of the floor that the robot can reach, N m², walls off by about "
       "N cm (N in N such maps: by less than N cm)\n"
       "  next: echomap eval RUN --truth RUN/truth --picture RUN/score.png\n"},
      {"StopLimit",
       demo_stage({"--world=nxt_room", "--stops=1"}),
       kUnfinished,
       "stop-limit",
       "echomap: error: not finished; the map so far is saved: it came to the limit of its stops; "
       "the map has N % of the floor that the robot can reach, N m²; most of what is unseen is "
       "near "
       "(N, N)\n  next: echomap demo --world nxt_room --emulator mock\n"},
      {"SonarDead",
       demo_stage({"--part-faults=sonar-dead@60"}),
       1,
       "sonar-silent",
       "echomap: error: not finished; the map so far is saved: the sonar does not answer: it is "
       "not connected, or it is dead\n"
       "  next: check the sonar's wiring and its supply, then start again\n"},
      {"LargeEmptyHall",
       demo_stage({"--stops=12"}, kLargeEmptyHall),
       kUnfinished,
       "stop-limit",
       "echomap: error: not finished; the map so far is saved: it came to the limit of its stops; "
       "the map has N % of the floor that the robot can reach, N m², walls off by about N cm (N in "
       "N such maps: by less than N cm); most of what is unseen is near "
       "(N, N)\n  next: echomap demo --world WORLD --emulator mock\n"},
      {"TooNarrow",
       demo_stage({}, kNarrowGap),
       0,
       "complete",
       "finished: the map has N % of the floor that the robot can reach, N m², walls off by about "
       "N cm (N in N such maps: by less than N cm)\n"
       "  next: echomap eval RUN --truth RUN/truth --picture RUN/score.png\n"},
      {"Stuck",
       demo_stage({}, kHoleInTheFloor),
       9,
       "robot-fault",
       "echomap: error: not finished; the map so far is saved: the wheels turn and the robot stays "
       "where it is\n"
       "  next: free it, put it on the floor and see whether its wheels grip, then: echomap demo "
       "--world WORLD --emulator mock\n"},
      {"Cable",
       demo_stage({"--faults=away=60:1000"}),
       5,
       "link-lost",
       "echomap: error: not finished; the map so far is saved: lost PORT: the robot stopped "
       "sending\n"
       "  next: check its cable and its supply, then start again; --reconnect N waits longer\n"},
      {"Battery",
       demo_stage({"--robot=create",
                   "--world=create_l",
                   "--strategy=coastal",
                   "--part-faults=battery-low@20"}),
       7,
       "battery-low",
       "echomap: error: not finished; the map so far is saved: the battery is low\n"
       "  next: charge it without moving the robot, then: echomap demo --world create_l --emulator "
       "mock --robot create --strategy coastal\n"},
      {"Lost",
       demo_stage({"--robot=ev3_mega",
                   "--world=playground",
                   "--strategy=tangent-bug",
                   "--waypoints=playground",
                   "--seed=2",
                   "--part-faults=slip-left@60:8:0.6"}),
       1,
       "lost",
       "echomap: error: not finished; the map so far is saved: sonar readings contradict the map: "
       "the robot was carried, or its wheels slipped\n"
       "  next: start again, or find it in its map: echomap localize --map RUN --robot "
       "evN_mega\n"},
      {"Lifted",
       lift,
       7,
       "safety-stop",
       "echomap: error: not finished; the map so far is saved: the robot was lifted and not put "
       "down within N minutes\n"
       "  next: put it down and start again\n",
       0.5},
      {"FullDisk",
       full_disk_stage(2, 32),
       1,
       "",
       "echomap: error: the run is not saved, or only up to an earlier stop: cannot write "
       "RUN/trajectory.tum: File too large\n"
       "  next: make room there, or name another directory with --out; then start again\n"},
      {"Interrupted",
       interrupt,
       130,
       "interrupted",
       "echomap: error: not finished; the map so far is saved: interrupted\n"
       "  next: echomap explore --port PORT --resume RUN --out RUN\n",
       0.5},
  };
}

}  // namespace

StageFolder::StageFolder(const fs::path& folder)
    : root(folder),
      run(folder / "run"),
      world(folder / "world.toml"),
      port(folder / "robot"),
      lockstep(folder / "grants") {}

Stage demo_stage(std::vector<std::string> options, std::string world) {
  return [options = std::move(options), world = std::move(world)](const StageFolder& folder) {
    std::vector<std::string> arguments{
        "demo", "--emulator=mock", "--headless", "--no-kidnap", "--out=" + folder.run.string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    if (!world.empty()) {
      files::write_text_file(folder.world, world);
      arguments.push_back("--world=" + folder.world.string());
    }
    return Program("echomap", arguments, folder.root / "log").wait();
  };
}

Stage full_disk_stage(int stops, int max_file_kb) {
  return [=](const StageFolder& folder) {
    const RobotAtAPort robot(folder, {"--world=nxt_room"});
    const auto arguments = explore_at_port(folder, {"--stops=" + std::to_string(stops)});
    return Program("echomap", arguments, folder.root / "log", max_file_kb).wait();
  };
}

const std::vector<StagedEnd>& staged_ends() {
  static const std::vector<StagedEnd> ends = make_ends();
  return ends;
}

StagedRun drive(const StagedEnd& end, const fs::path& folder) {
  const StageFolder stage(folder);
  StagedRun run;
  run.ended = end.stage(stage);
  run.closing_paragraph = without_names(stage, run.ended.said);
  if (const fs::path summary = stage.run / "summary.json"; exists(summary)) {
    run.summary = nlohmann::json::parse(files::read_text_file(summary));
  }
  if (exists(stage.run)) {
    for (const auto& entry : fs::directory_iterator(stage.run)) {
      run.saved.insert(entry.path().filename().string());
    }
  }
  return run;
}

std::vector<std::string> differences(const StagedEnd& golden, const StagedRun& run) {
  std::vector<std::string> found;
  if (run.ended.status != golden.status) {
    found.push_back(fmt::format("exit code {} in place of {}", run.ended.status, golden.status));
  }
  if (run.closing_paragraph != golden.closing_paragraph) {
    found.push_back("says: " + run.closing_paragraph);
  }
  const bool is_saved = *golden.outcome != '\0';
  if (!is_saved && run.saved.count("summary.json") != 0) {
    found.push_back("calls what is cut off a run");
  }
  if (is_saved && !run.summary) {
    found.push_back("there is no summary.json");
  } else if (is_saved) {
    find_differences_in_summary(golden, run, found);
  }
  return found;
}

}  // namespace echomap::test
