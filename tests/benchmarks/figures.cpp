// SPDX-License-Identifier: MIT
#include "tests/benchmarks/figures.hpp"

#include <algorithm>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::bench {
namespace {

std::string cpu_name() {
  std::ifstream lines("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(key) && line.find(": ") != std::string::npos) {
      return line.substr(line.find(": ") + 2);
    }
  }
  return "unknown";
}

constexpr const char* isa_name() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__SSE4_2__)
  return "SSE4.2";
#elif defined(__SSE2__)
  return "SSE2";
#else
  return "no vectors";
#endif
}

}  // namespace

void report(const std::vector<Figure>& figures,
            const std::filesystem::path& json,
            const Notes& notes) {
  const std::string cpu = cpu_name();
  fmt::print("on {}, compiled for {}\n", cpu, isa_name());
  for (const auto& [name, text] : notes) {
    fmt::print("{}: {}\n", name, text);
  }
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
    nlohmann::ordered_json all{{"cpu", cpu}, {"isa", isa_name()}, {"figures", list}};
    if (!notes.empty()) {
      all["notes"] = notes;
    }
    files::write_text_file(json, all.dump(2) + "\n");
  }
}

}  // namespace echomap::bench
