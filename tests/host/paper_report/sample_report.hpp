// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/paper_report/paper_report.hpp"
#include "tests/host/paper_report/tiny_png.hpp"

namespace echomap::paper_report {

/// An experiment with one of everything.
inline Experiment sample_localization() {
  Experiment experiment;
  experiment.title = "Where is the robot?";
  experiment.question = "Do 8 readings & a map suffice?";
  experiment.as_told = "250 particles, 8 readings at 45°.\n\nThe robot turns by 20°.";
  experiment.our_way = "KLD sampling with up to 5000 particles.";
  experiment.answer = "Not with the paper's noise <6 cm>.";
  experiment.findings = {
      {.quantity = "Position error",
       .where = "figure 8",
       .paper = "about 6 cm",
       .as_told = Measured{.value = 31.54, .low = 24.96, .high = 38.12, .runs = 20},
       .ours = Measured{.value = 3.04, .low = 2.55, .high = 3.53, .runs = 20},
       .unit = "cm",
       .decimals = 1},
      {.quantity = "Runs that find the robot",
       .where = "section 4.5",
       .paper = "no figure given",
       .as_told = std::nullopt,
       .ours = scaled(measured_share(20, 20), 100.0),
       .unit = "%",
       .decimals = 0}};
  experiment.pictures = {{.title = "Particles after 5 steps",
                          .where = "figure 8",
                          .caption = "Red: the \"true\" pose.",
                          .png = tiny_png(4, 4)}};
  experiment.equations = {{.name = "equation 1",
                           .text = "p(z | x) = N(z; ẑ, σ²)\n  for z < 2.5 m",
                           .file = "host/paper_report/source_lines.hpp",
                           .symbol = "class SourceLines"},
                          {.name = "algorithm 2, resampling wheel",
                           .text = "β ← β + 2 w_max u",
                           .file = "host/paper_report/absent.cpp",
                           .symbol = "resample"}};
  experiment.open = {"The noise of the sonar.", "How a step ends."};
  return experiment;
}

/// An experiment that has a picture only.
inline Experiment sample_scan() {
  Experiment experiment;
  experiment.title = "A scan";
  experiment.pictures = {
      {.title = "A scan of the room", .where = "", .caption = "", .png = tiny_png(9, 2)}};
  return experiment;
}

/// A report of two experiments.
inline PaperReport sample_report() {
  return {.number = "000",
          .title = "Map Construction & Localization",
          .authors = "J. Singh, P. Bedi",
          .summary = "A robot of Lego maps a room.",
          .experiments = {sample_localization(), sample_scan()},
          .seed = 7,
          .version = "0.1.0",
          .command = "echomap paper 000 --seed 7 --out <folder>"};
}

}  // namespace echomap::paper_report
