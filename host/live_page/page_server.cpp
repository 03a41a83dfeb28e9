// SPDX-License-Identifier: MIT
#include "host/live_page/page_server.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/live_page/http_connection.hpp"
#include "host/live_page/live_clients.hpp"
#include "host/live_page/page_url.hpp"
#include "host/live_page/queued_sender.hpp"
#include "host/live_page/server_clock.hpp"

namespace echomap::live_page {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

/// After an error of the system, as when no descriptor is left.
constexpr std::chrono::milliseconds kAcceptPause{100};
constexpr std::chrono::seconds kWatchPeriod{1};
constexpr std::chrono::seconds kBlockedPatience{10};
constexpr std::size_t kMaxInboxBytes = std::size_t{256} << 20;

/// The run that /ws shows: the live one, else the first.
const ServedRun* shown_run(const std::vector<ServedRun>& runs) {
  const auto live =
      std::find_if(runs.begin(), runs.end(), [](const ServedRun& run) { return run.live; });
  if (live != runs.end()) {
    return &*live;
  }
  return runs.empty() ? nullptr : &runs.front();
}

CommandHandler handler_of(const PageServerParams& params, const std::vector<ServedRun>& runs) {
  const ServedRun* run = shown_run(runs);
  const bool is_live = run != nullptr && run->live;
  return {is_live ? std::optional(params.can) : std::nullopt, server_clock_ms};
}

std::shared_ptr<History> history_of(const std::vector<ServedRun>& runs) {
  const ServedRun* run = shown_run(runs);
  return run == nullptr ? nullptr : run->history;
}

/// A browser that is started must not hold the port when this program has ended.
void keep_from_children(int descriptor) { ::fcntl(descriptor, F_SETFD, FD_CLOEXEC); }

tcp::acceptor open_acceptor(asio::io_context& io,
                            const ListenAddress& address,
                            std::uint16_t port) {
  try {
    tcp::acceptor acceptor(io, tcp::endpoint(asio::ip::make_address(address.number), port));
    keep_from_children(acceptor.native_handle());
    return acceptor;
  } catch (const boost::system::system_error& error) {
    throw console::CommandError(console::ExitCode::kRuntimeError,
                                "cannot serve the live page on " + address.number + ":" +
                                    std::to_string(port) + ": " + error.code().message() +
                                    "\n  next: name another port or address, or end what listens "
                                    "there");
  }
}

[[noreturn]] void fail_to_read(const files::FileError& error) {
  throw console::CommandError(console::ExitCode::kRuntimeError,
                              std::string("the live page is not whole: ") + error.what());
}

PageAssets read_assets(const std::filesystem::path& folder) {
  try {
    return PageAssets(folder);
  } catch (const files::FileError& error) {
    fail_to_read(error);
  }
}

std::string read_openapi(const std::filesystem::path& file) {
  try {
    return files::read_text_file(file);
  } catch (const files::FileError& error) {
    fail_to_read(error);
  }
}

}  // namespace

/// Lives in the server's thread but for its constructor, destructor and what other threads ask.
class PageServer::Impl {
 public:
  Impl(const PageServerParams& params, std::vector<ServedRun> runs, TakeCommand take_command)
      : address_(listen_address(params.address, params.token)),
        history_(history_of(runs)),
        clients_(handler_of(params, runs), history_, std::move(take_command)),
        parts_{nullptr, params.protocols, ConnectionList(max_connections_of_this_process())},
        acceptor_(open_acceptor(io_, address_, params.port)),
        url_(page_url(address_, acceptor_.local_endpoint().port(), params.token)) {
    parts_.protocols.push_back(echomap_protocol(clients_));
    router_.emplace(content(params, std::move(runs)));
    parts_.router = &*router_;
    pass_messages_on();
    accept();
    watch();
    thread_ = std::thread([this] { run(); });
  }
  ~Impl() {
    if (history_) {
      history_->listen(nullptr);
    }
    inbox_->detach();
    asio::post(io_, [this] {
      clients_.stop_listening();
      parts_.connections.close_all();
      io_.stop();
    });
    thread_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  const std::string& url() const { return url_; }
  void set_can(std::vector<std::string> can) { clients_.set_can(std::move(can)); }
  std::string take_trouble() {
    const std::lock_guard lock(trouble_mutex_);
    return std::exchange(trouble_, {});
  }
  PageAudience audience() const {
    PageAudience audience;
    audience.clients = parts_.sockets;
    if (const auto driver = clients_.driver()) {
      audience.driver = driver->client;
      audience.driver_name = driver->name;
    }
    return audience;
  }

 private:
  PageContent content(const PageServerParams& params, std::vector<ServedRun> runs) {
    std::vector<std::string> names;
    names.reserve(parts_.protocols.size());
    for (const NamedProtocol& protocol : parts_.protocols) {
      names.push_back(protocol.name);
    }
    const std::uint16_t port = acceptor_.local_endpoint().port();
    return {RequestGuard(address_.literal, port, params.token),
            read_assets(params.page_folder),
            read_openapi(params.openapi_file),
            std::move(runs),
            std::move(names),
            [this](std::string_view text) { return clients_.take_post(text); }};
  }

  /// The run's thread adds messages; of those that wait for this thread, too, only the newest stay.
  void pass_messages_on() {
    inbox_ = std::make_shared<QueuedSender>([this] { asio::post(io_, [this] { send_waiting(); }); },
                                            kMaxInboxBytes);
    if (history_) {
      history_->listen([inbox = inbox_](const SharedMessage& message) {
        inbox->send(LiveClients::frame_of(message));
      });
    }
  }

  void send_waiting() {
    while (const auto frame = inbox_->take()) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      clients_.send(*frame);
    }
  }

  void accept() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) {
        return;
      }
      if (error) {
        accept_later();
        return;
      }
      serve(std::move(socket));
      accept();
    });
  }

  void accept_later() {
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([this](boost::system::error_code error) {
      if (!error) {
        accept();
      }
    });
  }

  void serve(tcp::socket socket) {
    boost::system::error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    keep_from_children(socket.native_handle());
    if (!parts_.connections.is_full()) {
      serve_http(std::move(socket), parts_);
    }
  }

  void watch() {
    watch_.expires_after(kWatchPeriod);
    watch_.async_wait([this](boost::system::error_code error) {
      if (!error) {
        parts_.connections.close_blocked(kBlockedPatience);
        watch();
      }
    });
  }

  void run() {
    while (!io_.stopped()) {
      try {
        io_.run();
      } catch (const std::exception& error) {
        const std::lock_guard lock(trouble_mutex_);
        trouble_ = error.what();
      }
    }
  }

  ListenAddress address_;
  std::shared_ptr<History> history_;
  LiveClients clients_;
  ServerParts parts_;
  std::optional<PageRouter> router_;
  std::shared_ptr<QueuedSender> inbox_;
  asio::io_context io_{1};  ///< Its connections still use the members before.
  tcp::acceptor acceptor_;
  std::string url_;
  asio::steady_timer pause_{io_};
  asio::steady_timer watch_{io_};
  std::mutex trouble_mutex_;
  std::string trouble_;
  std::thread thread_;
};

PageServer::PageServer(const PageServerParams& params,
                       std::vector<ServedRun> runs,
                       TakeCommand take_command)
    : impl_(std::make_unique<Impl>(params, std::move(runs), std::move(take_command))) {}

PageServer::~PageServer() = default;

const std::string& PageServer::url() const { return impl_->url(); }

void PageServer::set_can(std::vector<std::string> can) { impl_->set_can(std::move(can)); }

std::string PageServer::take_trouble() { return impl_->take_trouble(); }

PageAudience PageServer::audience() const { return impl_->audience(); }

}  // namespace echomap::live_page
