// SPDX-License-Identifier: MIT
#include "host/paper_report/report_json.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace echomap::paper_report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kConfidence = 0.95;
/// Longer titles are cut in the names of files.
constexpr std::size_t kMaxNameLetters = 60;

Json measured_json(const std::optional<Measured>& measured) {
  if (!measured) {
    return nullptr;
  }
  return {{"value", measured->value},
          {"low", measured->low},
          {"high", measured->high},
          {"runs", measured->runs}};
}

Json finding_json(const Finding& finding) {
  return {{"quantity", finding.quantity},
          {"where", finding.where},
          {"paper", finding.paper},
          {"unit", finding.unit},
          {"as_told", measured_json(finding.as_told)},
          {"ours", measured_json(finding.ours)}};
}

Json equation_json(const Equation& equation, const SourceLines& source_lines) {
  const auto line = source_lines.line(equation.file, equation.symbol);
  return {{"name", equation.name},
          {"text", equation.text},
          {"file", equation.file},
          {"line", line ? Json(*line) : Json()}};
}

Json experiment_json(const Experiment& experiment,
                     const SourceLines& source_lines,
                     int& last_picture) {
  Json json{{"title", experiment.title},
            {"question", experiment.question},
            {"answer", experiment.answer},
            {"findings", Json::array()},
            {"pictures", Json::array()},
            {"equations", Json::array()},
            {"open", experiment.open}};
  for (const Finding& finding : experiment.findings) {
    json["findings"].push_back(finding_json(finding));
  }
  for (const PaperPicture& picture : experiment.pictures) {
    json["pictures"].push_back({{"title", picture.title},
                                {"where", picture.where},
                                {"caption", picture.caption},
                                {"file", picture_file_name(++last_picture, picture.title)}});
  }
  for (const Equation& equation : experiment.equations) {
    json["equations"].push_back(equation_json(equation, source_lines));
  }
  return json;
}

}  // namespace

std::string report_json(const PaperReport& report, const SourceLines& source_lines) {
  Json json{
      {"format", "echomap-paper-report"},
      {"version", kReportJsonVersion},
      {"paper", {{"number", report.number}, {"title", report.title}, {"authors", report.authors}}},
      {"echomap_version", report.version},
      {"command", report.command},
      {"seed", report.seed},
      {"confidence", kConfidence},
      {"experiments", Json::array()}};
  int last_picture = 0;
  for (const Experiment& experiment : report.experiments) {
    json["experiments"].push_back(experiment_json(experiment, source_lines, last_picture));
  }
  constexpr int kIndent = 2;
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string picture_file_name(int number, const std::string& title) {
  constexpr std::string_view kUpper = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  constexpr std::string_view kLower = "abcdefghijklmnopqrstuvwxyz";
  std::string name;
  for (const char letter : title) {
    const std::size_t upper = kUpper.find(letter);
    const bool is_plain =
        kLower.find(letter) != std::string_view::npos || (letter >= '0' && letter <= '9');
    if (upper != std::string_view::npos) {
      name += kLower[upper];
    } else if (is_plain) {
      name += letter;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  name.resize(std::min(name.size(), kMaxNameLetters));
  while (!name.empty() && name.back() == '_') {
    name.pop_back();
  }
  return fmt::format("{:02}_{}.png", number, name.empty() ? "picture" : name);
}

}  // namespace echomap::paper_report
