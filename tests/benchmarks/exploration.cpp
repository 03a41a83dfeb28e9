// SPDX-License-Identifier: MIT
// Every strategy in every room over many seeds, ours against the best of the others; the papers'
// own experiments; and what a decision takes.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/session/temporary_folder.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/benchmarks/exploration_decisions.hpp"
#include "tests/benchmarks/exploration_entry.hpp"
#include "tests/benchmarks/exploration_log.hpp"
#include "tests/benchmarks/exploration_papers.hpp"
#include "tests/benchmarks/exploration_runs.hpp"
#include "tests/benchmarks/exploration_score.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"

namespace echomap::bench {
namespace {

struct Options {
  std::string part = "all";
  SeedRange seeds;
  std::vector<std::string> rooms{"nxt_room",
                                 "create_l",
                                 "create_t",
                                 "epuck_field",
                                 "playground",
                                 "living_room",
                                 "corridor_rooms",
                                 "office",
                                 "round_room",
                                 "pillar_hall"};
  std::vector<std::string> strategies{"frontier", "nxt-farthest", "tangent-bug", "coastal"};
  std::vector<std::string> papers;  ///< Empty: all.
  std::string emulator;
  std::string board;
  std::size_t decisions = 20;
  std::filesystem::path log;
  std::filesystem::path json;
  std::filesystem::path markdown;

  bool has(const char* name) const { return part == "all" || part == name; }
};

/// Figures, and tables for docs.
struct Outcome {
  std::vector<Figure> figures;
  std::string markdown;

  void add(const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
  }
  void add(const MarkdownTable& table) {
    markdown += (markdown.empty() ? "" : "\n") + to_markdown(table);
  }
};

void say(const ExplorationCell& cell) {
  std::string line = fmt::format("{:16} {:13} {:15}",
                                 cell.entry.what.room,
                                 cell.entry.what.strategy,
                                 robot_name(cell.entry.what));
  const auto columns = score_columns();
  const auto texts = score_texts(cell);
  for (std::size_t i = 0; i < texts.size() && !texts[i].empty(); ++i) {
    line +=
        fmt::format("  {} {}", i == 0 && !cell.entry.why_not.empty() ? "" : columns[i], texts[i]);
  }
  fmt::print(stderr, "{}\n", line);
}

ExplorationCell measure(ExplorationEntry entry, const SeedRange& seeds, ExplorationLog& log) {
  ExplorationCell cell{std::move(entry), seeds.count};
  if (cell.entry.why_not.empty()) {
    cell.runs = explore_seeds(cell.entry.what, seeds, log);
  }
  say(cell);
  return cell;
}

/// The emulator and the board that were asked for, where they were.
void put_on(const Options& options, ExplorationCase& what) {
  if (!options.emulator.empty() || !options.board.empty()) {
    what.board = options.board;
  }
  if (!options.emulator.empty()) {
    what.emulator = options.emulator;
  }
}

void measure_rooms(const Options& options, ExplorationLog& log, Outcome& outcome) {
  const session::TemporaryFolder courses;
  std::vector<ExplorationCell> cells;
  for (const std::string& room : options.rooms) {
    for (const std::string& strategy : options.strategies) {
      ExplorationEntry entry = entry_of(room, strategy, courses.path());
      put_on(options, entry.what);
      cells.push_back(measure(std::move(entry), options.seeds, log));
      outcome.add(cell_figures(cells.back()));
    }
  }
  outcome.add(frontier_figures(cells));
  outcome.add(rooms_table(cells));
}

void measure_papers(const Options& options, ExplorationLog& log, Outcome& outcome) {
  const session::TemporaryFolder files;
  std::vector<MeasuredPaper> measured;
  for (auto& [paper, what] : paper_experiments(files.path())) {
    if (!options.papers.empty() && std::ranges::count(options.papers, paper) == 0) {
      continue;
    }
    put_on(options, what);
    measured.push_back({paper, measure({what}, options.seeds, log)});
    for (Figure figure : cell_figures(measured.back().cell)) {
      figure.name = paper + "." + figure.name;
      outcome.figures.push_back(figure);
    }
    outcome.add(paper_figures(paper, measured.back().cell));
  }
  outcome.add(papers_table(measured));
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--part", options.part, "Of what is measured")
      ->check(CLI::IsMember({"rooms", "papers", "decisions", "all"}))
      ->capture_default_str();
  app.add_option("--seeds", options.seeds.count, "How many")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first-seed", options.seeds.first)->capture_default_str();
  app.add_option("--jobs", options.seeds.jobs, "Runs at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--rooms", options.rooms)->delimiter(',')->capture_default_str();
  app.add_option("--strategies", options.strategies)
      ->delimiter(',')
      ->check(CLI::IsMember(strategies::strategy_names()))
      ->capture_default_str();
  app.add_option("--papers", options.papers, "As paper_001,paper_003; all where none is named")
      ->delimiter(',')
      ->check(CLI::IsMember({"paper_000",
                             "paper_001",
                             "paper_001_measured",
                             "paper_002",
                             "paper_003",
                             "paper_000_brick",
                             "paper_003_brick"}));
  auto* emulator = app.add_option(
      "--emulator", options.emulator, "Instead of the mock for rooms and simavr for papers");
  app.add_option("--board", options.board, "Instead of --emulator")->excludes(emulator);
  app.add_option("--decisions", options.decisions, "How many of frontier's are timed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option(
      "--log", options.log, "Add every run to this file, and make none that it has: for one build");
  app.add_option("--json", options.json, "Write the figures to this file");
  app.add_option("--markdown", options.markdown, "Write tables for docs to this file");
}

void run(const Options& options) {
  Outcome outcome;
  ExplorationLog log(options.log);
  if (options.has("rooms")) {
    measure_rooms(options, log, outcome);
  }
  if (options.has("papers")) {
    measure_papers(options, log, outcome);
  }
  if (options.has("decisions")) {
    outcome.add(decision_figures(options.decisions));
  }
  report(outcome.figures, options.json);
  if (!options.markdown.empty()) {
    files::write_text_file(options.markdown, outcome.markdown);
  }
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap::bench;
  Options options;
  CLI::App app(
      "Every strategy in every room over many seeds, the papers' own experiments, and what a "
      "decision takes");
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
