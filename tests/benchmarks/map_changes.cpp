// SPDX-License-Identifier: MIT
// How often `echomap diff` finds a box that was put into a simulated room, taken out or moved, and
// how often it finds something where nothing has changed.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/evaluation/map_difference.hpp"
#include "tests/benchmarks/box_scene.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {
namespace {

using evaluation::ChangeKind;
using geometry::Pose2;

/// What was asked and what was found.
struct Tally {
  double found = 0.0;
  double asked = 0.0;
  double false_regions = 0.0;
  double pairs = 0.0;
  double unaligned = 0.0;

  void add(const Tally& other) {
    found += other.found;
    asked += other.asked;
    false_regions += other.false_regions;
    pairs += other.pairs;
    unaligned += other.unaligned;
  }
  double share() const { return asked > 0.0 ? found / asked : 1.0; }
};

/// A box that appeared or vanished: its place in the first map's frame.
struct Expected {
  ChangeKind kind = ChangeKind::kAppeared;
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
};

bool is_at(const evaluation::ChangedRegion& region, const Expected& expected) {
  return region.kind == expected.kind &&
         (region.center_m - expected.place_m).norm() < 0.5 * kBoxM + 0.25;
}

void compare(const mapping::RasterMap& before,
             const mapping::RasterMap& after,
             const std::vector<Expected>& expected,
             Tally& tally) {
  const auto difference = evaluation::find_difference(before, after);
  ++tally.pairs;
  tally.asked += static_cast<double>(expected.size());
  if (!difference) {
    ++tally.unaligned;
    return;
  }
  for (const Expected& one : expected) {
    const auto& regions = difference->regions;
    tally.found +=
        std::any_of(
            regions.begin(), regions.end(), [&](const auto& region) { return is_at(region, one); })
            ? 1.0
            : 0.0;
  }
  for (const auto& region : difference->regions) {
    const bool hit = std::any_of(
        expected.begin(), expected.end(), [&](const Expected& one) { return is_at(region, one); });
    tally.false_regions += hit ? 0.0 : 1.0;
  }
}

/// Of one room, over the seeds.
struct Tallies {
  Tally unchanged;
  Tally put_in;
  Tally taken_out;
  Tally moved;

  void add(const Tallies& other) {
    unchanged.add(other.unchanged);
    put_in.add(other.put_in);
    taken_out.add(other.taken_out);
    moved.add(other.moved);
  }
};

void add_scene(const std::string& room, std::uint32_t seed, Tallies& tallies) {
  BoxScene scene(room, seed);
  const Pose2 T_map_world = scene.before_start().inverse();
  const Eigen::Vector2d first_m = T_map_world * scene.place_m(0);
  const Eigen::Vector2d second_m = T_map_world * scene.place_m(1);
  const auto empty = scene.mapped({}, false);
  const auto empty_again = scene.mapped({}, true);
  const auto one_box = scene.mapped({0}, false);
  const auto one_box_later = scene.mapped({0}, true);
  const auto moved_box = scene.mapped({1}, true);
  compare(empty, empty_again, {}, tallies.unchanged);
  compare(one_box, one_box_later, {}, tallies.unchanged);
  compare(empty, one_box_later, {{ChangeKind::kAppeared, first_m}}, tallies.put_in);
  compare(one_box, empty_again, {{ChangeKind::kVanished, first_m}}, tallies.taken_out);
  compare(one_box,
          moved_box,
          {{ChangeKind::kVanished, first_m}, {ChangeKind::kAppeared, second_m}},
          tallies.moved);
}

std::vector<Figure> figures_of(const std::string& room, const Tallies& tallies) {
  const auto runs = [](const Tally& tally) { return static_cast<std::size_t>(tally.pairs); };
  const double pairs = tallies.put_in.pairs + tallies.taken_out.pairs + tallies.moved.pairs;
  const double unaligned = tallies.unchanged.unaligned + tallies.put_in.unaligned +
                           tallies.taken_out.unaligned + tallies.moved.unaligned;
  const double false_regions =
      tallies.put_in.false_regions + tallies.taken_out.false_regions + tallies.moved.false_regions;
  return {
      {room + "_put_in_found", tallies.put_in.share(), "share", runs(tallies.put_in), {}},
      {room + "_taken_out_found", tallies.taken_out.share(), "share", runs(tallies.taken_out), {}},
      {room + "_moved_found", tallies.moved.share(), "share", runs(tallies.moved), {}},
      {room + "_false_regions_unchanged",
       tallies.unchanged.false_regions / tallies.unchanged.pairs,
       "a pair",
       runs(tallies.unchanged),
       {}},
      {room + "_false_regions_changed",
       false_regions / pairs,
       "a pair",
       static_cast<std::size_t>(pairs),
       {}},
      {room + "_not_aligned",
       unaligned / (pairs + tallies.unchanged.pairs),
       "share",
       static_cast<std::size_t>(pairs + tallies.unchanged.pairs),
       {}}};
}

/// Whether a map difference is as good as it was: bounds a little below what it does over all
/// rooms.
bool is_within_bounds(const Tallies& tallies) {
  return tallies.put_in.share() >= 0.8 && tallies.taken_out.share() >= 0.8 &&
         tallies.moved.share() >= 0.7 &&
         tallies.unchanged.false_regions <= 0.2 * tallies.unchanged.pairs;
}

/// Measures and reports; answers the exit code.
int run(const std::vector<std::string>& rooms,
        std::uint32_t seeds,
        const std::filesystem::path& json,
        bool check) {
  std::vector<Figure> figures;
  Tallies all;
  for (const std::string& room : rooms) {
    Tallies tallies;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
      add_scene(room, seed, tallies);
    }
    all.add(tallies);
    for (const Figure& figure : figures_of(room, tallies)) {
      figures.push_back(figure);
    }
  }
  const std::vector<Figure> of_all = figures_of("all", all);
  figures.insert(figures.end(), of_all.begin(), of_all.end());
  report(figures, json);
  return check && !is_within_bounds(all) ? 1 : 0;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  std::uint32_t seeds = 20;
  std::vector<std::string> rooms{"living_room", "l_room", "landing"};
  std::filesystem::path json;
  bool check = false;
  CLI::App app("How often a map difference finds a box that was moved, in simulated rooms");
  app.add_option("--seeds", seeds, "Run seeds 1 to this")->capture_default_str();
  app.add_option("--rooms", rooms, "Bundled rooms")->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  app.add_flag("--check", check, "Fail outside of wide bounds");
  CLI11_PARSE(app, argc, argv);
  try {
    return echomap::bench::run(rooms, seeds, json, check);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
