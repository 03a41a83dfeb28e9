// SPDX-License-Identifier: MIT
#include "host/papers/paper_list.hpp"

#include <functional>
#include <map>
#include <stdexcept>

#include "host/papers/paper_000.hpp"
#include "host/papers/paper_001.hpp"
#include "host/papers/paper_002.hpp"
#include "host/papers/paper_003.hpp"
#include "host/papers/paper_004.hpp"

namespace echomap::papers {
namespace {

using Repeat = std::function<paper_report::PaperReport(const PaperSettings&)>;

const std::map<std::string, Repeat>& papers() {
  static const std::map<std::string, Repeat> by_number{{"000", paper_000},
                                                       {"001", paper_001},
                                                       {"002", paper_002},
                                                       {"003", paper_003},
                                                       {"004", paper_004}};
  return by_number;
}

}  // namespace

std::vector<std::string> paper_numbers() {
  std::vector<std::string> numbers;
  for (const auto& [number, repeat] : papers()) {
    numbers.push_back(number);
  }
  return numbers;
}

paper_report::PaperReport repeat_paper(const std::string& number, const PaperSettings& settings) {
  if (settings.runs == 0) {
    throw std::invalid_argument("papers: runs = 0 is below 1");
  }
  return papers().at(number)(settings);
}

}  // namespace echomap::papers
