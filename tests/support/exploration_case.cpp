// SPDX-License-Identifier: MIT
#include "tests/support/exploration_case.hpp"

#include <stdexcept>

#include "host/files/atomic_file.hpp"

namespace echomap::tests {
namespace {

namespace fs = std::filesystem;

constexpr int kCameraPort = 17200;

void replace(std::string& text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  if (at == std::string::npos) {
    throw std::runtime_error("no '" + before + "' to be replaced");
  }
  text.replace(at, before.size(), after);
}

std::string read_source(const std::string& path) {
  return files::read_text_file(fs::path(ECHOMAP_SOURCE_DIR) / path);
}

}  // namespace

std::vector<std::string> demo_arguments(const ExplorationCase& what, int seed) {
  std::vector<std::string> arguments{
      "--world=" + what.room,
      "--strategy=" + what.strategy,
      "--robot=" + what.robot,
      what.board.empty() ? "--emulator=" + what.emulator : "--board=" + what.board,
      "--seed=" + std::to_string(seed)};
  if (!what.course.empty()) {
    arguments.push_back("--waypoints=" + what.course.string());
  }
  if (!what.slam.empty()) {
    arguments.push_back("--slam=" + what.slam);
  }
  if (!what.body.empty()) {
    arguments.push_back("--body=" + what.body.string());
  }
  if (what.under_camera) {
    arguments.push_back("--fixes=udp:127.0.0.1:" + std::to_string(kCameraPort + seed));
    arguments.emplace_back("--camera-params=rate=10,delay=0.1,noise=0.001,heading=0.6");
  }
  return arguments;
}

ExplorationCase nxt_in_its_room() {
  ExplorationCase what{"nxt_room", "nxt-farthest", "nxt_tribot", {}, false, "uno"};
  what.slam = "none";
  return what;
}

ExplorationCase create_in(const std::string& arena) {
  return {arena, "coastal", "create", {}, false, "mega"};
}

ExplorationCase epuck_on_its_field() { return {"epuck_field", "epuck", "epuck", {}, true, "mega"}; }

ExplorationCase ev3_at_its_door() {
  ExplorationCase what{"playground_door", "tangent-bug", "ev3_mega", "playground", false, "mega"};
  what.slam = "none";
  return what;
}

ExplorationCase brick_at_its_door() {
  ExplorationCase what = ev3_at_its_door();
  what.robot = "ev3";
  what.board = "ev3";
  return what;
}

ExplorationCase brick_in_the_nxts_room() {
  ExplorationCase what = nxt_in_its_room();
  what.robot = "ev3";
  what.board = "ev3";
  return what;
}

ExplorationCase stretched_create_in(const std::string& arena, const fs::path& folder) {
  std::string body = read_source("hil_mock/robots/create.toml");
  replace(body, "wheel_diameter_m = 0.065", "wheel_diameter_m = 0.0676");
  replace(body, "track_m = 0.258 ", "track_m = 0.26832 ");
  auto what = create_in(arena);
  what.body = folder / "stretched_create_body.toml";
  files::write_text_file(what.body, body);
  return what;
}

ExplorationCase measured_create_in(const std::string& arena, const fs::path& folder) {
  std::string profile = read_source("host/profiles/create.toml");
  replace(profile,
          "[body]",
          "[odometry]\nmeasured_m = [[0.5, 0.52], [1.0, 1.04], [2.0, 2.08]]\n\n[body]");
  auto what = stretched_create_in(arena, folder);
  what.robot = (folder / "measured_create.toml").string();
  files::write_text_file(what.robot, profile);
  return what;
}

}  // namespace echomap::tests
