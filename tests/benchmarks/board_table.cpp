// SPDX-License-Identifier: MIT
#include "tests/benchmarks/board_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/benchmarks/edge_counts.hpp"

namespace echomap::bench {
namespace {

constexpr const char* kNoFigure = "-";
/// Counts and lost steps are modulo 2^16: what is near that says only that many were missed.
constexpr double kMaxToldMiscounts = 10'000.0;

const Figure* find_in(const BoardColumn& column, const std::string& name) {
  const auto found = std::find_if(column.figures.begin(),
                                  column.figures.end(),
                                  [&](const Figure& figure) { return figure.name == name; });
  return found != column.figures.end() ? &*found : nullptr;
}

std::string cell_of(const BoardColumn& column, const std::string& name, int decimals) {
  const Figure* figure = find_in(column, name);
  if (figure == nullptr) {
    return kNoFigure;
  }
  return std::isfinite(figure->value) ? fmt::format("{:.{}f}", figure->value, decimals) : "never";
}

/// "0", "17, 12 steps reported lost", "over 10000", "no report" where the robot did not say a count
/// in time, and "resets" where its chip was reset.
std::string miscounts_of(const BoardColumn& column, const std::string& suffix) {
  const Figure* lost = find_in(column, "lost_steps_" + suffix);
  if (lost == nullptr) {
    return column.counts_edges || column.figures.empty() ? kNoFigure : "counted by the motors";
  }
  if (find_in(column, "resets_" + suffix)->value > 0.0) {
    return "resets";
  }
  const Figure* miscounts = find_in(column, "miscounts_" + suffix);
  if (miscounts == nullptr) {
    return "no report";
  }
  if (miscounts->value > kMaxToldMiscounts) {
    return fmt::format("over {:.0f}", kMaxToldMiscounts);
  }
  return lost->value > 0.0
             ? fmt::format("{:.0f}, {:.0f} steps reported lost", miscounts->value, lost->value)
             : fmt::format("{:.0f}", miscounts->value);
}

/// A row whose figure has the same name on every board, or begins or ends with the board's.
std::vector<std::string> row_of(const std::vector<BoardColumn>& boards,
                                const std::string& title,
                                const std::string& name,
                                int decimals) {
  std::vector<std::string> row{title};
  for (const BoardColumn& column : boards) {
    const std::string before = name.starts_with('_') ? column.board : "";
    const std::string behind = name.ends_with('_') ? column.board : "";
    row.push_back(cell_of(column, before + name + behind, decimals));
  }
  return row;
}

void add_miscounts(const std::vector<BoardColumn>& boards, MarkdownTable& table) {
  for (const int rate_k : kRatesK) {
    for (const int jitter_percent : kJittersPercent) {
      std::vector<std::string> row{
          fmt::format("miscounts at {}k edges/s, {} % jitter", rate_k, jitter_percent)};
      for (const BoardColumn& column : boards) {
        row.push_back(miscounts_of(column, suffix_of(rate_k, jitter_percent)));
      }
      table.rows.push_back(row);
    }
  }
}

}  // namespace

MarkdownTable board_table(const std::vector<BoardColumn>& boards) {
  MarkdownTable table{{""}, {{"emulator"}}};
  for (const BoardColumn& column : boards) {
    table.header.push_back(column.board);
    table.rows.front().push_back(column.emulator);
  }
  table.rows.push_back(row_of(boards, "flash, B", "flash_bytes_", 0));
  table.rows.push_back(row_of(boards, "static RAM, B", "static_ram_bytes_", 0));
  table.rows.push_back(row_of(boards, "CPU at 20k edges/s, %", "cpu_percent_20k", 1));
  add_miscounts(boards, table);
  table.rows.push_back(row_of(boards, "stop after silence, ms", "link_loss_stop_ms", 0));
  table.rows.push_back(row_of(boards, "hang to off, ms", "hang_off_ms", 1));
  table.rows.push_back(row_of(boards, "crash to off, ms", "_crash_off_ms", 1));
  table.rows.push_back(row_of(boards, "echo error, us", "echo_error_us", 2));
  return table;
}

BoardReport read_board_report(const std::string& json, const std::string& board) {
  const auto all = nlohmann::json::parse(json);
  BoardReport report;
  report.emulator = all.at("notes").at(board).get<std::string>();
  for (const auto& figure : all.at("figures")) {
    const auto& value = figure.at("value");
    report.figures.push_back({figure.at("name").get<std::string>(),
                              value.is_null() ? INFINITY : value.get<double>(),
                              figure.at("unit").get<std::string>(),
                              figure.at("runs").get<std::size_t>(),
                              {}});
  }
  return report;
}

std::vector<Figure> figures_by_board(const std::vector<BoardColumn>& boards) {
  std::vector<Figure> all;
  for (const BoardColumn& column : boards) {
    for (Figure figure : column.figures) {
      if (!figure.name.ends_with("_" + column.board) &&
          !figure.name.starts_with(column.board + "_")) {
        figure.name = column.board + "_" + figure.name;
      }
      all.push_back(figure);
    }
  }
  return all;
}

}  // namespace echomap::bench
