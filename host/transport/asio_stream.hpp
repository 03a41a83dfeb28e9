// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// A ByteStream over any asynchronous stream of Boost.Asio (socket, stream_descriptor), on an
/// io_context of its own. One read is always under way; its handler only runs inside of the calls
/// below, so there is no thread and no lock.
template <class Stream>
class AsioStream : public ByteStream {
 public:
  explicit AsioStream(std::string name) : name_(std::move(name)), stream_(io_) {}
  ~AsioStream() override { close("closed"); }

  /// For the opener, which connects or assigns the stream before it hands this object out.
  Stream& stream() { return stream_; }
  boost::asio::io_context& io_context() { return io_; }
  /// Done while the stream is open for the last time.
  void before_close(std::function<void()> action) { before_close_ = std::move(action); }

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds wait) override {
    if (begin_ == end_ && status_ == StreamStatus::kOpen) {
      fill(wait);
    }
    const std::size_t count = std::min(into.size(), end_ - begin_);
    std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), count, into.begin());
    begin_ += count;
    return count;
  }

  void write(std::span<const std::uint8_t> bytes) override {
    while (!bytes.empty() && status_ == StreamStatus::kOpen) {
      bytes = bytes.subspan(write_some(bytes));
    }
  }

  StreamStatus status() const override { return status_; }
  std::string close_reason() const override { return close_reason_; }
  std::string name() const override { return name_; }

 private:
  static constexpr std::chrono::microseconds kWritePatience{1'000'000};

  std::size_t write_some(std::span<const std::uint8_t> bytes) {
    bool done = false;
    boost::system::error_code result;
    std::size_t written = 0;
    const auto is_done = [&done] { return done; };
    stream_.async_write_some(boost::asio::buffer(bytes.data(), bytes.size()),
                             [&](const boost::system::error_code& error, std::size_t count) {
                               done = true;
                               result = error;
                               written = count;
                             });
    run_until(is_done, kWritePatience);
    if (!done) {
      // Closing cancels the write; its handler must run while the locals are there.
      close("it took no bytes for a second");
      run_until(is_done, kWritePatience);
    } else if (result) {
      close(reason_of(result));
    }
    return written;
  }

  void fill(std::chrono::microseconds wait) {
    if (!is_reading_) {
      start_read();
    }
    run_until([this] { return !is_reading_; }, wait);
  }

  void start_read() {
    is_reading_ = true;
    begin_ = end_ = 0;
    stream_.async_read_some(boost::asio::buffer(buffer_),
                            [this](const boost::system::error_code& error, std::size_t count) {
                              is_reading_ = false;
                              end_ = count;
                              if (error) {
                                close(reason_of(error));
                              }
                            });
  }

  /// Runs handlers until `is_done()` or until `wait` is over; at least those that are due now.
  template <class Done>
  void run_until(const Done& is_done, std::chrono::microseconds wait) {
    const auto deadline = std::chrono::steady_clock::now() + wait;
    do {
      io_.restart();
      if (io_.poll_one() == 0) {
        io_.run_one_until(deadline);
      }
    } while (!is_done() && std::chrono::steady_clock::now() < deadline);
  }

  void close(const std::string& reason) {
    if (status_ == StreamStatus::kOpen) {
      status_ = StreamStatus::kClosed;
      close_reason_ = reason;
      if (before_close_) {
        before_close_();
      }
      boost::system::error_code ignored;
      stream_.close(ignored);
    }
  }

  /// Both end-of-file and EIO are how a tty says that nobody is at the other end.
  static std::string reason_of(const boost::system::error_code& error) {
    const bool is_gone =
        error == boost::asio::error::eof ||
        error == boost::system::errc::make_error_code(boost::system::errc::io_error);
    return is_gone ? "the other end closed it" : error.message();
  }

  std::string name_;
  boost::asio::io_context io_{1};
  Stream stream_;
  std::array<std::uint8_t, 4096> buffer_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool is_reading_ = false;
  StreamStatus status_ = StreamStatus::kOpen;
  std::string close_reason_;
  std::function<void()> before_close_;
};

/// Runs the connection that `start(handler)` begins on a stream nobody reads yet, for at most
/// `patience`; its error, or that of a timeout.
template <class Stream, class Start>
boost::system::error_code connect_within(AsioStream<Stream>& stream,
                                         std::chrono::seconds patience,
                                         const Start& start) {
  boost::system::error_code error = boost::asio::error::timed_out;
  start([&](const boost::system::error_code& result, auto&&...) { error = result; });
  stream.io_context().run_for(patience);
  if (!stream.io_context().stopped()) {
    stream.stream().close();
    stream.io_context().run();
    return boost::asio::error::timed_out;
  }
  return error;
}

}  // namespace echomap::transport
