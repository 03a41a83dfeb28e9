// SPDX-License-Identifier: MIT
#include "host/papers/explorations.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"

namespace echomap::papers {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kJobs = 2;
constexpr std::chrono::milliseconds kLookAgain{20};

/// A run that is going on.
struct Job {
  std::size_t index = 0;
  fs::path folder;
  fs::path log;
  std::unique_ptr<session::ChildProcess> process;
};

Job start(const Explorations& explorations, const fs::path& folder, std::size_t index) {
  const std::string seed = std::to_string(explorations.first_seed + index);
  Job job;
  job.index = index;
  job.folder = folder / explorations.name / seed;
  job.log = folder / explorations.name / (seed + ".log");
  fs::create_directories(job.folder);
  std::vector<std::string> command{session::program_folder() / "echomap"};
  command.insert(command.end(), explorations.command.begin(), explorations.command.end());
  command.insert(command.end(), {"--headless", "--force", "--seed", seed, "--out", job.folder});
  command.insert(command.end(), explorations.arguments.begin(), explorations.arguments.end());
  job.process = std::make_unique<session::ChildProcess>(command, job.log);
  return job;
}

/// The last line of a log that does not say what to do next.
std::string last_line(const fs::path& log) {
  std::istringstream lines(files::read_text_file(log));
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    last = line.empty() || line.starts_with("  ") ? last : line;
  }
  return last;
}

ExplorationRun result_of(const Explorations& explorations, const Job& job, int status) {
  using console::ExitCode;
  if (status != static_cast<int>(ExitCode::kOk) &&
      status != static_cast<int>(ExitCode::kUnfinished)) {
    throw console::CommandError(ExitCode::kRuntimeError,
                                fmt::format("echomap {} has failed: {}\n  next: see {}",
                                            fmt::join(explorations.command, " "),
                                            last_line(job.log),
                                            job.log.string()));
  }
  const std::string text = files::read_text_file(job.folder / "summary.json");
  return {job.folder, nlohmann::json::parse(text)};
}

}  // namespace

std::vector<ExplorationRun> run_explorations(const Explorations& explorations,
                                             const fs::path& folder,
                                             const Progress& progress) {
  std::vector<ExplorationRun> runs(explorations.runs);
  std::vector<Job> jobs;
  std::size_t started = 0;
  std::size_t ended = 0;
  while (ended < explorations.runs) {
    if (console::interrupted()) {
      throw console::CommandError(console::ExitCode::kInterrupted, "interrupted");
    }
    while (jobs.size() < kJobs && started < explorations.runs) {
      jobs.push_back(start(explorations, folder, started++));
    }
    for (auto job = jobs.begin(); job != jobs.end();) {
      if (const auto status = job->process->wait_for(kLookAgain)) {
        runs[job->index] = result_of(explorations, *job, *status);
        job = jobs.erase(job);
        progress(++ended);
      } else {
        ++job;
      }
    }
  }
  return runs;
}

std::vector<double> numbers_of(const std::vector<ExplorationRun>& runs,
                               const std::string& pointer) {
  const nlohmann::json::json_pointer where(pointer);
  std::vector<double> numbers;
  for (const ExplorationRun& run : runs) {
    if (run.summary.contains(where) && run.summary.at(where).is_number()) {
      numbers.push_back(run.summary.at(where).get<double>());
    }
  }
  return numbers;
}

}  // namespace echomap::papers
