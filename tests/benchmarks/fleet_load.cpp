// SPDX-License-Identifier: MIT
#include "tests/benchmarks/fleet_load.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "host/broker/broker.hpp"
#include "host/mqtt/connection.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::bench {
namespace {

using Clock = std::chrono::steady_clock;
using mqtt::Connection;
using mqtt::Delivery;

/// How long what is still on its way may take at the end.
constexpr std::chrono::seconds kTail{5};

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Processor time of a process, seconds: utime and stime of proc(5).
double cpu_s(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(text.rfind(')') + 2));
  std::string skipped;
  for (int i = 0; i < 11; ++i) {
    fields >> skipped;
  }
  double user = 0.0;
  double system = 0.0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// The time at which it is published, and bytes that stand for the rest.
std::string stamped_payload(std::size_t bytes) {
  const std::int64_t now_ns = Clock::now().time_since_epoch().count();
  std::string payload(std::max(bytes, sizeof now_ns), 'x');
  std::memcpy(payload.data(), &now_ns, sizeof now_ns);
  return payload;
}

double age_ms(const std::string& payload) {
  std::int64_t then_ns = 0;
  std::memcpy(&then_ns, payload.data(), sizeof then_ns);
  return 1e-6 * static_cast<double>(Clock::now().time_since_epoch().count() - then_ns);
}

/// A robot that goes through the record round and round, from a place of its own.
class ReplayingRobot {
 public:
  ReplayingRobot(const mqtt::ConnectionParams& params,
                 const std::vector<RecordedMessage>& record,
                 double record_s,
                 double begin_s)
      : name_(params.user),
        connection_(params),
        record_(record),
        record_s_(record_s),
        offset_s_(-begin_s) {
    while (next_ < record_.size() && record_[next_].at_s < begin_s) {
      ++next_;
    }
    wrap();
  }

  Connection& connection() { return connection_; }

  /// Publishes what is due; how many messages that were.
  std::size_t publish_until(double now_s) {
    std::size_t published = 0;
    while (offset_s_ + record_[next_].at_s <= now_s) {
      const RecordedMessage& message = record_[next_];
      connection_.publish("echomap/1/bench/" + name_ + "/" + message.kind,
                          stamped_payload(message.bytes),
                          message.delivery,
                          message.retain);
      ++published;
      ++next_;
      wrap();
    }
    return published;
  }

 private:
  void wrap() {
    if (next_ == record_.size()) {
      next_ = 0;
      offset_s_ += record_s_;
    }
  }

  std::string name_;
  Connection connection_;
  const std::vector<RecordedMessage>& record_;
  double record_s_;
  double offset_s_;
  std::size_t next_ = 0;
};

/// A broker, its robots and a hub, all of whom are served by one thread.
class LoadRun {
 public:
  LoadRun(const LoadParams& params, const LoadRecord& record)
      : params_(params),
        broker_(settings_of(params.robots), folder_ / "broker"),
        hub_(broker::connection_params(broker_.credentials("hub"))) {
    std::mt19937 random(params.seed);
    hub_.subscribe("echomap/1/bench/#");
    for (std::size_t i = 0; i < params.robots; ++i) {
      const double begin_s = record.duration_s * static_cast<double>(random()) / 4294967296.0;
      const auto member = broker::connection_params(broker_.credentials(name_of(i)));
      robots_.push_back(std::make_unique<ReplayingRobot>(
          member, record.robots[i % record.robots.size()], record.duration_s, begin_s));
      if (params.all_hear) {
        robots_.back()->connection().subscribe("echomap/1/bench/#");
      }
    }
    connect();
  }

  LoadResult run() {
    const double cpu_before_s = cpu_s(broker_.pid());
    const auto begin = Clock::now();
    std::size_t published = 0;
    while (seconds_since(begin) < params_.duration_s) {
      for (const auto& robot : robots_) {
        published += robot->publish_until(seconds_since(begin));
      }
      serve();
    }
    const double cpu_used_s = cpu_s(broker_.pid()) - cpu_before_s;
    const double duration_s = seconds_since(begin);
    const std::size_t expected = published * (params_.all_hear ? robots_.size() + 1 : 1);
    const auto end = Clock::now() + kTail;
    while (ages_ms_.size() < expected && Clock::now() < end) {
      serve();
    }
    return result(published, expected, duration_s, cpu_used_s);
  }

 private:
  static std::string name_of(std::size_t robot) { return "robot" + std::to_string(robot + 1); }

  static broker::BrokerSettings settings_of(std::size_t robots) {
    broker::BrokerSettings settings;
    settings.fleet = "bench";
    settings.users.push_back({"hub", broker::random_password()});
    for (std::size_t i = 0; i < robots; ++i) {
      settings.users.push_back({name_of(i), broker::random_password()});
    }
    return settings;
  }

  void connect() {
    const auto end = Clock::now() + std::chrono::seconds(60);
    const auto is_ready = [this](const Connection& connection, std::size_t filters) {
      return connection.is_connected() && connection.statistics().subscribed == filters;
    };
    for (bool all = false; !all;) {
      serve();
      const std::size_t filters = params_.all_hear ? 1 : 0;
      all = is_ready(hub_, 1) && std::ranges::all_of(robots_, [&](const auto& robot) {
              return is_ready(robot->connection(), filters);
            });
      if (Clock::now() > end) {
        throw std::runtime_error("not all robots can connect to the broker");
      }
    }
  }

  void serve() {
    hear(hub_);
    for (const auto& robot : robots_) {
      hear(robot->connection());
    }
  }

  void hear(Connection& connection) {
    for (const mqtt::Message& message : connection.take()) {
      ages_ms_.push_back(age_ms(message.payload));
    }
  }

  LoadResult result(std::size_t published,
                    std::size_t expected,
                    double duration_s,
                    double cpu_used_s) {
    LoadResult result;
    std::size_t bytes = 0;
    for (const auto& robot : robots_) {
      bytes += robot->connection().statistics().published_bytes;
    }
    result.published_per_s = static_cast<double>(published) / duration_s;
    result.delivered_per_s = static_cast<double>(ages_ms_.size()) / duration_s;
    result.missing = expected - std::min(expected, ages_ms_.size());
    result.broker_cpu_percent = 100.0 * cpu_used_s / duration_s;
    result.kbytes_per_s_per_robot =
        1e-3 * static_cast<double>(bytes) / duration_s / static_cast<double>(robots_.size());
    std::ranges::sort(ages_ms_);
    if (!ages_ms_.empty()) {
      result.p50_ms = ages_ms_[ages_ms_.size() / 2];
      result.p99_ms = ages_ms_[ages_ms_.size() * 99 / 100];
    }
    return result;
  }

  LoadParams params_;
  session::TemporaryFolder folder_;
  broker::Broker broker_;
  Connection hub_;
  std::vector<std::unique_ptr<ReplayingRobot>> robots_;
  std::vector<double> ages_ms_;
};

}  // namespace

LoadResult measure_load(const LoadParams& params, const LoadRecord& record) {
  const auto is_empty = [](const auto& robot) { return robot.empty(); };
  if (record.robots.empty() || record.duration_s <= 0.0 ||
      std::ranges::any_of(record.robots, is_empty)) {
    throw std::invalid_argument("load: there is a robot that has published nothing");
  }
  return LoadRun(params, record).run();
}

std::vector<Figure> load_figures(const LoadRecord& record, double duration_s) {
  std::vector<Figure> figures;
  for (const auto& [robots, all_hear] :
       {std::pair{std::size_t{10}, false}, {50, false}, {200, false}, {10, true}, {50, true}}) {
    const LoadResult result = measure_load({robots, duration_s, all_hear, 1}, record);
    const std::string name = fmt::format("robots_{}{}", robots, all_hear ? "" : "_to_hub");
    figures.push_back({name + "_published", result.published_per_s, "/s", 1, {}});
    figures.push_back({name + "_delivered", result.delivered_per_s, "/s", 1, {}});
    figures.push_back({name + "_p50_ms", result.p50_ms, "ms", 1, {}});
    figures.push_back({name + "_p99_ms", result.p99_ms, "ms", 1, {}});
    figures.push_back({name + "_broker_cpu", result.broker_cpu_percent, "% of a core", 1, {}});
    figures.push_back({name + "_missing", static_cast<double>(result.missing), "", 1, {}});
    figures.push_back(
        {name + "_published_per_robot", result.kbytes_per_s_per_robot, "kB/s", 1, {}});
  }
  return figures;
}

}  // namespace echomap::bench
