// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>

namespace echomap::bench {

/// How often what is told with a probability is so: a reliability diagram (Murphy and Winkler
/// 1977).
class Reliability {
 public:
  struct Bin {
    std::size_t told = 0;
    double probability_sum = 0.0;
    std::size_t happened = 0;

    double mean_probability() const { return probability_sum / static_cast<double>(told); }
    double frequency() const { return static_cast<double>(happened) / static_cast<double>(told); }
  };

  /// With a probability within [0, 1].
  void add(double probability, bool has_happened);

  /// Tenths of probability.
  const std::array<Bin, 10>& bins() const { return bins_; }
  std::size_t count() const;
  /// Mean distance of frequency and probability over all that was told; 0 for nothing.
  double mean_error() const;

 private:
  std::array<Bin, 10> bins_{};
};

/// Draws the diagram: a disc a bin, its area by how often it was told, and the diagonal that all
/// would lie on. Throws files::FileError.
void write_reliability_svg(const Reliability& reliability, const std::filesystem::path& path);

}  // namespace echomap::bench
