// SPDX-License-Identifier: MIT
#include "tests/structure/papers_page.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tests/structure/command_blocks.hpp"

namespace echomap::structure {
namespace {

[[noreturn]] void refuse(std::size_t line, const std::string& why) {
  throw std::runtime_error("docs/papers.md:" + std::to_string(line) + ": " + why);
}

/// The cells of a row, without the spaces around them.
std::vector<std::string> cells_of(const std::string& row) {
  static const std::regex cell(R"(\|\s*((?:\\\||[^|])*?)\s*(?=\|))");
  std::vector<std::string> cells;
  for (std::sregex_iterator match(row.begin(), row.end(), cell), end; match != end; ++match) {
    cells.push_back(std::regex_replace((*match)[1].str(), std::regex(R"(\\\|)"), "|"));
  }
  return cells;
}

CommandNeed need_named(const std::string& word, std::size_t line) {
  static const std::map<std::string, CommandNeed> needs{
      {"simulated", CommandNeed::kNothing},
      {"recording", CommandNeed::kRecording},
      {"log", CommandNeed::kLog},
      {"two programs", CommandNeed::kTwoPrograms}};
  const auto need = needs.find(word);
  if (need == needs.end()) {
    refuse(line, "'" + word + ":' before a command is none of the words of the page");
  }
  return need->second;
}

std::vector<PaperCommand> commands_in(const std::string& cell, std::size_t line) {
  static const std::regex pattern(R"(([a-z ]+[a-z]): `([^`]+)`)");
  std::vector<PaperCommand> commands;
  for (std::sregex_iterator match(cell.begin(), cell.end(), pattern), end; match != end; ++match) {
    const std::string word = std::regex_replace((*match)[1].str(), std::regex("^ +"), "");
    commands.push_back({need_named(word, line), (*match)[2].str()});
  }
  if (commands.empty() != (cell.rfind("not yet", 0) == 0)) {
    refuse(line, "a row has either commands, as in simulated: `COMMAND`, or 'not yet'");
  }
  return commands;
}

/// As in "Exit code 8" and "exit code 0 or 8".
std::set<int> exit_codes_in(const std::string& cell) {
  static const std::regex pattern(R"([Ee]xit code (\d+)(?: or (\d+))?)");
  std::set<int> codes;
  for (std::sregex_iterator match(cell.begin(), cell.end(), pattern), end; match != end; ++match) {
    codes.insert(std::stoi((*match)[1].str()));
    if ((*match)[2].matched) {
      codes.insert(std::stoi((*match)[2].str()));
    }
  }
  return codes;
}

PaperFeature feature_of(const std::string& row, std::size_t line) {
  const std::vector<std::string> cells = cells_of(row);
  if (cells.size() != 4) {
    refuse(line, std::to_string(cells.size()) + " cells in a row of four");
  }
  return {line, cells[0], commands_in(cells[2], line), exit_codes_in(cells[3])};
}

/// The commands of a script, each with the lines that continue it.
std::vector<std::string> statements_of(const std::string& script) {
  std::vector<std::string> statements(1);
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) {
    statements.back() += line + "\n";
    if (line.empty() || line.back() != '\\') {
      statements.emplace_back();
    }
  }
  statements.pop_back();
  return statements;
}

void add_preparations(const std::string& script, std::vector<Preparation>& preparations) {
  for (const std::string& statement : statements_of(script)) {
    const std::vector<std::string> words = words_of(statement);
    if (words.empty()) {
      continue;
    }
    if (words.front() == "timeout" && !preparations.empty() && preparations.back().is_robot) {
      preparations.back().script += statement;
      continue;
    }
    const bool is_robot = words.back() == "&";
    Preparation preparation{statement, {}, is_robot};
    for (const std::string option : {"--out", "--link", "--lockstep"}) {
      const std::string value = value_in(words, option);
      if (!value.empty() && is_robot == (option != "--out")) {
        preparation.made.push_back(value);
      }
    }
    if (!preparation.made.empty()) {
      preparations.push_back(preparation);
    }
  }
}

bool makes(const Preparation& preparation, const std::string& thing) {
  const std::vector<std::string>& made = preparation.made;
  return std::find(made.begin(), made.end(), thing) != made.end();
}

bool is_row_of_feature(const std::string& line) {
  return line.rfind("| ", 0) == 0 && line.rfind("| feature |", 0) != 0;
}

}  // namespace

PapersPage parse_papers_page(const std::vector<std::string>& lines) {
  PapersPage page;
  const std::vector<CommandBlock> blocks = command_blocks_of(lines);
  auto block = blocks.begin();
  bool is_in_a_paper = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    static const std::regex heading(R"(## (\d{3}): .*)");
    if (std::smatch match; std::regex_match(lines[i], match, heading)) {
      page.papers.push_back({match[1].str(), {}, {}});
      is_in_a_paper = true;
    } else if (lines[i].rfind("## ", 0) == 0) {
      is_in_a_paper = false;
    } else if (is_in_a_paper && is_row_of_feature(lines[i])) {
      page.papers.back().features.push_back(feature_of(lines[i], i + 1));
    }
    if (block != blocks.end() && block->line == i + 1) {
      if (is_in_a_paper) {
        add_preparations(block->script, page.papers.back().preparations);
      } else {
        page.files += block->script;
      }
      ++block;
    }
  }
  return page;
}

std::vector<PageCommand> commands_of(const PaperSection& paper) {
  std::vector<PageCommand> all;
  for (const PaperFeature& feature : paper.features) {
    for (const PaperCommand& command : feature.commands) {
      auto known = std::find_if(all.begin(), all.end(), [&](const PageCommand& each) {
        return each.command.text == command.text;
      });
      if (known == all.end()) {
        known = all.insert(all.end(), {feature.line, command, {}});
      }
      known->exit_codes.insert(feature.exit_codes.begin(), feature.exit_codes.end());
    }
  }
  for (PageCommand& command : all) {
    if (command.exit_codes.empty()) {
      command.exit_codes = {0};
    }
  }
  return all;
}

std::string script_for(const PageCommand& command,
                       const PaperSection& paper,
                       const std::function<bool(const std::string&)>& exists) {
  std::vector<std::string> read = words_of(command.command.text);
  const std::string gate = value_in(read, "--lockstep");
  const std::string out = value_in(read, "--out");
  read.erase(std::remove(read.begin(), read.end(), out), read.end());
  std::string before;
  std::string robot;
  for (const Preparation& preparation : paper.preparations) {
    if (preparation.is_robot) {
      robot = makes(preparation, gate) ? preparation.script : robot;
    } else if (std::any_of(read.begin(), read.end(), [&](const std::string& word) {
                 return makes(preparation, word) && !exists(word);
               })) {
      before += preparation.script;
    }
  }
  if (command.command.need == CommandNeed::kTwoPrograms) {
    if (robot.empty()) {
      refuse(command.line, "no block below the table starts a robot with --lockstep " + gate);
    }
    before += "trap 'kill $! 2>/dev/null || :' EXIT\n" + robot;
  }
  return before + command.command.text + "\n";
}

std::vector<std::string> words_of(const std::string& command) {
  std::istringstream stream(command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

std::string value_in(const std::vector<std::string>& words, const std::string& option) {
  const auto found = std::find(words.begin(), words.end(), option);
  return found == words.end() || found + 1 == words.end() ? "" : *(found + 1);
}

}  // namespace echomap::structure
