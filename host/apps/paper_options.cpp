// SPDX-License-Identifier: MIT
#include "host/apps/paper_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/apps/commands.hpp"
#include "host/apps/map_options.hpp"
#include "host/papers/paper_list.hpp"

namespace echomap::apps {

void add_paper(CLI::App& app, CommandAction& action) {
  CLI::App* command = app.add_subcommand(
      "paper", "Repeat a paper's experiments, as told and as we would do them, and write a report");
  const auto options = std::make_shared<PaperOptions>();
  command
      ->add_option("number",
                   options->number,
                   fmt::format("Number of the paper: {}", fmt::join(papers::paper_numbers(), ", ")))
      ->required()
      ->check(CLI::IsMember(papers::paper_numbers()));
  command->add_option("--seed", options->seed, "Seed of the first run; the others count on from it")
      ->capture_default_str();
  command->add_option("--runs", options->runs, "Runs of each experiment with a random outcome")
      ->check(CLI::Range(std::size_t{2}, std::size_t{1000}))
      ->capture_default_str();
  add_out_options(*command, options->out, options->force);
  command->add_option("--json", options->json, "Write the figures to this file, '-' for stdout");
  command->add_flag("--headless", options->headless, "No progress line");
  command->footer(
      "Writes report.html, report.json, pictures and the runs; takes some minutes.\n"
      "Example: echomap paper 000 --out paper_000");
  command->callback([&action, options] { action = [options] { return run_paper(*options); }; });
}

}  // namespace echomap::apps
