// SPDX-License-Identifier: MIT
#include "tests/benchmarks/truth_rooms.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <future>

#include "hil_mock/world/floor_plan_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::bench {

const std::vector<std::string>& truth_room_names() {
  static const std::vector<std::string> names{"nxt_room",
                                              "create_l",
                                              "create_t",
                                              "epuck_field",
                                              "playground",
                                              "living_room",
                                              "corridor_rooms",
                                              "office",
                                              "round_room",
                                              "pillar_hall",
                                              "classroom",
                                              "garage",
                                              "attic",
                                              "studio",
                                              "hall",
                                              "corridor_t"};
  return names;
}

std::string TruthEmulators::of(const std::string& room) const {
  if (emulator != "mixed") {
    return emulator;
  }
  const bool is_real =
      std::find(simavr_rooms.begin(), simavr_rooms.end(), room) != simavr_rooms.end();
  return is_real ? "simavr" : "mock";
}

TruthRoom truth_room(const std::string& world, const TruthEmulators& emulators) {
  const std::filesystem::path file =
      files::bundled_file(world, "hil_mock/worlds", "world (--rooms)");
  TruthRoom room{
      file.stem().string(), world, world::read_floor_plan(files::TomlReader::load(file)), {}, {}};
  room.emulator = emulators.of(room.name);
  return room;
}

void for_each_in_jobs(std::size_t count, int jobs, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::vector<std::future<void>> workers;
  for (int job = 0; job < jobs; ++job) {
    workers.push_back(std::async(std::launch::async, [&] {
      for (std::size_t i = next++; i < count; i = next++) {
        task(i);
      }
    }));
  }
  for (auto& worker : workers) {
    worker.get();
  }
}

}  // namespace echomap::bench
