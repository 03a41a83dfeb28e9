// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/paper_report/measured.hpp"

namespace echomap::paper_report {

/// One quantity of a paper beside our measurements of it: a row of a table.
struct Finding {
  std::string quantity{};
  std::string where{};                ///< Place in the paper, as in "figure 8" or "section 4.5".
  std::string paper{};                ///< The paper's value in words, or "no figure given".
  std::optional<Measured> as_told{};  ///< Measured with the paper's settings, in `unit`.
  std::optional<Measured> ours{};     ///< Measured with our method, in `unit`.
  std::string unit{};                 ///< Unit of both, as in "cm", "%" or "of 60".
  int decimals = 0;                   ///< How many digits follow the decimal point.
};

/// A picture of an experiment, like one of the paper or of our own.
struct PaperPicture {
  std::string title{};
  std::string where{};  ///< The paper's picture to compare it with, as in "figure 8"; empty: none.
  std::string caption{};
  std::vector<std::uint8_t> png{};  ///< The bytes of a PNG file.
};

/// An equation or algorithm of a paper and where the source code computes it.
struct Equation {
  std::string name{};    ///< As in "equation 1" or "algorithm 2, resampling wheel".
  std::string text{};    ///< Mathematics in Unicode; line breaks and indentation are kept.
  std::string file{};    ///< Path from the root of the repository.
  std::string symbol{};  ///< A text of the line in that file that begins the computation.
};

/// One experiment of a paper, repeated. Blank lines separate the paragraphs of a text; an empty
/// text leaves its part out of the page.
struct Experiment {
  std::string title{};
  std::string question{};
  std::string as_told{};  ///< How the paper does it, which is repeated.
  std::string our_way{};  ///< How our method does it.
  std::string answer{};
  std::vector<Finding> findings{};
  std::vector<PaperPicture> pictures{};
  std::vector<Equation> equations{};
  std::vector<std::string> open{};  ///< Questions that the paper leaves open.
};

/// The experiments of one paper, and what repeats them with the same result.
struct PaperReport {
  std::string number{};  ///< As in "000".
  std::string title{};
  std::string authors{};
  std::string summary{};
  std::vector<Experiment> experiments{};
  std::uint32_t seed = 0;
  std::string version{};  ///< Version of echomap.
  std::string command{};  ///< The command line to paste.
};

}  // namespace echomap::paper_report
