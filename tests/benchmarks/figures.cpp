// SPDX-License-Identifier: MIT
#include "tests/benchmarks/figures.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::bench {

void report(const std::vector<Figure>& figures, const std::filesystem::path& json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::size_t width = 28;
  for (const Figure& figure : figures) {
    width = std::max(width, figure.name.size());
  }
  for (const Figure& figure : figures) {
    fmt::print("{:{}} {:10.4f} {:8} runs {}\n",
               figure.name,
               width,
               figure.value,
               figure.unit,
               figure.runs);
    for (const auto& [peer, value] : figure.peers) {
      fmt::print("  {:{}} {:10.4f} {:8} {:.2f} times\n",
                 peer,
                 width - 2,
                 value,
                 figure.unit,
                 figure.value / value);
    }
    list.push_back({{"name", figure.name},
                    {"value", figure.value},
                    {"unit", figure.unit},
                    {"runs", figure.runs},
                    {"peers", figure.peers}});
  }
  if (!json.empty()) {
    files::write_text_file(json, nlohmann::ordered_json{{"figures", list}}.dump(2) + "\n");
  }
}

}  // namespace echomap::bench
