// SPDX-License-Identifier: MIT
#include "host/exports/observations_file.hpp"

#include <system_error>
#include <utility>

#include "host/exports/observations_csv.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

ObservationsFile::ObservationsFile(std::filesystem::path path) : path_(std::move(path)) {}

void ObservationsFile::save(const pipeline::ObservationLog& record, bool goes_on) {
  ObservationRecorder recorder;
  if (goes_on && is_as_it_was()) {
    record.replay(recorder, observations_);
    files::append_text(path_, recorder.lines());
    bytes_ += recorder.lines().size();
  } else {
    record.replay(recorder);
    recorder.save(path_);
    bytes_ = std::filesystem::file_size(path_);
  }
  observations_ = record.observations();
}

bool ObservationsFile::is_as_it_was() const {
  std::error_code unknown;
  return bytes_ > 0 && std::filesystem::file_size(path_, unknown) == bytes_ && !unknown;
}

}  // namespace echomap::exports
