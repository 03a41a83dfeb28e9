// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host/live_page/page_server.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::live_page {

/// A page, a run with files and a server of both, with what it is told to do.
class ServedPage {
 public:
  explicit ServedPage(PageServerParams params = {}, bool is_live = true)
      : history_(std::make_shared<History>()) {
    for (const char* name : {"index.html", "app.js", "app.css", "favicon.svg"}) {
      std::ofstream(folder_ / name) << "the file " << name << std::string(1000, 'x');
    }
    std::filesystem::create_directory(folder_ / "run");
    std::ofstream(folder_ / "run" / "map.png") << "a picture";
    std::ofstream(folder_ / "secret") << "a secret";
    params.page_folder = folder_.path();
    params.openapi_file = ECHOMAP_SOURCE_DIR "/host/live_page/openapi.json";
    params.can = {"stop", "drive", "go", "explore"};
    ServedRun run{"first_map", folder_ / "run", history_, is_live};
    server_ = std::make_unique<PageServer>(
        params, std::vector<ServedRun>{run}, [this](const session::OperatorCommand& command) {
          const std::lock_guard lock(mutex_);
          commands_.push_back(command);
        });
    const std::string& url = server_->url();
    port_ = static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
  }

  std::uint16_t port() const { return port_; }
  const tests::ScratchFolder& folder() const { return folder_; }
  History& history() { return *history_; }
  PageServer& server() { return *server_; }
  /// Ends the server.
  void stop() { server_.reset(); }
  std::vector<session::OperatorCommand> commands() const {
    const std::lock_guard lock(mutex_);
    return commands_;
  }

 private:
  const tests::ScratchFolder folder_;
  std::shared_ptr<History> history_;
  mutable std::mutex mutex_;
  std::vector<session::OperatorCommand> commands_;
  std::unique_ptr<PageServer> server_;
  std::uint16_t port_ = 0;
};

inline SharedMessage made_message(MessageKind kind, std::uint64_t key, std::string bytes) {
  return std::make_shared<const Message>(Message{kind, key, 0.0, std::move(bytes)});
}

}  // namespace echomap::live_page
