// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace echomap::structure {

/// What a command of docs/papers.md needs: the word before it.
enum class CommandNeed { kNothing, kRecording, kLog, kTwoPrograms };

/// A command of a row.
struct PaperCommand {
  CommandNeed need = CommandNeed::kNothing;
  std::string text;
};

/// A row of a paper's table: a feature, and the commands that show it.
struct PaperFeature {
  std::size_t line = 0;  ///< From 1.
  std::string name;
  std::vector<PaperCommand> commands;  ///< None where the page says `not yet`.
  std::set<int> exit_codes;            ///< That the row names; none where it names none.
};

/// A command of a marked block, which makes what a row needs.
struct Preparation {
  std::string script;             ///< With the wait for it, where it is a simulated robot.
  std::vector<std::string> made;  ///< Folder, port or channel that it makes.
  bool is_robot = false;          ///< It runs beside the command of a row.
};

/// What the page says of one paper.
struct PaperSection {
  std::string number;  ///< As 000.
  std::vector<PaperFeature> features;
  std::vector<Preparation> preparations;
};

/// docs/papers.md.
struct PapersPage {
  std::string files;  ///< Script that makes the files that some rows need.
  std::vector<PaperSection> papers;
};

/// A command of a paper, once, however many rows it is in.
struct PageCommand {
  std::size_t line = 0;  ///< Of its first row.
  PaperCommand command;
  std::set<int> exit_codes;  ///< With which it may end: 0 unless a row names others.
};

/// Reads the lines of docs/papers.md. Throws std::runtime_error, with the line, where a row has
/// neither a command nor `not yet`, or a code that stands below no known word.
PapersPage parse_papers_page(const std::vector<std::string>& lines);

/// The commands of a paper in the order of its rows.
std::vector<PageCommand> commands_of(const PaperSection& paper);

/// The shell script that runs a command of a paper: before it what makes the folders that it reads
/// and that `exists` does not find, beside it its simulated robot. Throws std::runtime_error where
/// it needs a robot and no block has one with its --lockstep.
std::string script_for(const PageCommand& command,
                       const PaperSection& paper,
                       const std::function<bool(const std::string&)>& exists);

/// The words of a command, of which none is quoted.
std::vector<std::string> words_of(const std::string& command);

/// The word after `option`, or empty.
std::string value_in(const std::vector<std::string>& words, const std::string& option);

}  // namespace echomap::structure
