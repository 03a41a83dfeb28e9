// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "host/pipeline/observation_log.hpp"

namespace echomap::exports {

/// The file of a record that grows, as ObservationRecorder writes it. What a record has got since
/// it was saved last is added to the end: whoever is killed in the midst of it leaves half a line
/// there at most, which replay_observations_csv leaves out.
class ObservationsFile {
 public:
  explicit ObservationsFile(std::filesystem::path path);

  /// The file is that of the record then. `goes_on`: it begins with all that was saved last, else
  /// it is another one, and the file is written anew, whole or not at all; so it is where the file
  /// is not what was left there. Throws files::FileError.
  void save(const pipeline::ObservationLog& record, bool goes_on);

 private:
  bool is_as_it_was() const;

  std::filesystem::path path_;
  std::uintmax_t bytes_ = 0;  ///< Of the file, where it is ours.
  std::size_t observations_ = 0;
};

}  // namespace echomap::exports
