// SPDX-License-Identifier: MIT
#include "host/live_page/foxglove_topics.hpp"

#include <algorithm>
#include <utility>

namespace echomap::live_page {

void FoxgloveTopics::on_topic(const recording::RecordedTopic& topic) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = channel_of_topic_.find(topic.id);
    if (known != channel_of_topic_.end()) {
      const FoxgloveChannel& old = *channels_.at(known->second);
      if (old.topic == topic.name && old.schema_name == topic.schema_name &&
          old.schema_text == topic.schema_text) {
        return;
      }
      forget(old.id);
    }
    if (channels_.size() >= kMaxChannels) {
      return;
    }
    const std::uint32_t id = ++last_channel_;
    channel_of_topic_[topic.id] = id;
    channels_[id] = std::make_shared<const FoxgloveChannel>(
        FoxgloveChannel{id, topic.name, topic.schema_name, topic.schema_text});
    ++generation_;
  }
  wake_up();
}

void FoxgloveTopics::forget(std::uint32_t channel) {
  std::erase_if(channel_of_topic_, [&](const auto& entry) { return entry.second == channel; });
  channels_.erase(channel);
  newest_.erase(channel);
  ++generation_;
}

void FoxgloveTopics::on_message(std::uint32_t topic,
                                std::uint64_t log_time_ns,
                                std::span<const std::uint8_t> bytes) {
  {
    const std::lock_guard lock(mutex_);
    const auto channel = channel_of_topic_.find(topic);
    if (channel == channel_of_topic_.end()) {
      return;
    }
    log_time_ns_ = log_time_ns;
    keep(std::make_shared<const FoxgloveMessage>(FoxgloveMessage{
        channel->second, ++last_number_, log_time_ns, {bytes.begin(), bytes.end()}}));
  }
  wake_up();
}

void FoxgloveTopics::keep(SharedFoxgloveMessage message) {
  kept_bytes_ += message->data.size();
  newest_[message->channel] = message;
  kept_.push_back(std::move(message));
  while (kept_.size() > kMaxKeptMessages || (kept_bytes_ > kMaxKeptBytes && kept_.size() > 1)) {
    kept_bytes_ -= kept_.front()->data.size();
    kept_.pop_front();
  }
}

void FoxgloveTopics::clear() {
  {
    const std::lock_guard lock(mutex_);
    channel_of_topic_.clear();
    channels_.clear();
    newest_.clear();
    kept_.clear();
    kept_bytes_ = 0;
    ++generation_;
  }
  wake_up();
}

std::uint64_t FoxgloveTopics::listen(WakeUp wake_up) {
  const std::lock_guard lock(wake_up_mutex_);
  wake_ups_[++last_wake_up_] = std::move(wake_up);
  return last_wake_up_;
}

void FoxgloveTopics::unlisten(std::uint64_t number) {
  const std::lock_guard lock(wake_up_mutex_);
  wake_ups_.erase(number);
}

void FoxgloveTopics::wake_up() const {
  const std::lock_guard lock(wake_up_mutex_);
  for (const auto& [number, wake_up] : wake_ups_) {
    wake_up();
  }
}

std::vector<SharedFoxgloveChannel> FoxgloveTopics::channels() const {
  const std::lock_guard lock(mutex_);
  std::vector<SharedFoxgloveChannel> channels;
  channels.reserve(channels_.size());
  for (const auto& [id, channel] : channels_) {
    channels.push_back(channel);
  }
  return channels;
}

SharedFoxgloveMessage FoxgloveTopics::newest(std::uint32_t channel) const {
  const std::lock_guard lock(mutex_);
  const auto found = newest_.find(channel);
  return found == newest_.end() ? nullptr : found->second;
}

FoxgloveTopics::News FoxgloveTopics::since(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  News news{{}, last_number_, log_time_ns_, generation_};
  const std::uint64_t first_kept = kept_.empty() ? last_number_ + 1 : kept_.front()->number;
  for (const auto& [channel, message] : newest_) {
    if (message->number > number && message->number < first_kept) {
      news.messages.push_back(message);
    }
  }
  std::ranges::sort(news.messages, {}, &FoxgloveMessage::number);
  const std::uint64_t skipped = number < first_kept ? 0 : number - first_kept + 1;
  const auto begin =
      kept_.begin() + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(skipped, kept_.size()));
  news.messages.insert(news.messages.end(), begin, kept_.end());
  return news;
}

}  // namespace echomap::live_page
