#include "app/web/client.h"

#include <cstring>
#include <utility>

namespace quicksand {

bool Client::may_speak() {
  const auto now = std::chrono::steady_clock::now();
  const double since = std::chrono::duration<double>(now - counted_).count();
  allowance_ = std::min(limits_.most_at_once, allowance_ + since * limits_.messages_per_second);
  counted_ = now;
  if (allowance_ < 1) return false;
  allowance_ -= 1;
  return true;
}

Client::Heard Client::hear(std::string_view piece, bool binary, bool ends) {
  if (refusal_ == Refusal::none && said_.size() + piece.size() > limits_.message)
    refusal_ = Refusal::too_large;
  if (refusal_ != Refusal::none) return Heard::refused;
  said_ += piece;
  if (!ends) return Heard::piece;
  if (!may_speak()) {
    refusal_ = Refusal::too_many;
    return Heard::refused;
  }
  if (!binary) return Heard::text;
  std::uint32_t number = 0;
  if (said_.size() == sizeof number) std::memcpy(&number, said_.data(), sizeof number);
  said_.clear();
  seen_ = std::clamp<std::uint64_t>(number, seen_, frame_);
  return Heard::seen;
}

std::string Client::take_text() { return std::exchange(said_, {}); }

Client::Message Client::next(Exchange& exchange) {
  if (!answers_.empty()) {
    auto text = std::make_shared<const std::string>(std::move(answers_.front()));
    answers_.pop_front();
    answer_bytes_ -= text->size();
    return {std::move(text), false};
  }
  for (const Newest kind : {Newest::state, Newest::frame, Newest::plots}) {
    if (kind == Newest::frame && !has_room()) continue;
    Published newest = exchange.newest(kind);
    std::uint64_t& sent = sent_[static_cast<std::size_t>(kind)];
    if (newest.number == sent) continue;
    sent = newest.number;
    if (kind == Newest::frame) ++frame_;
    if (kind == Newest::frame && has_room()) exchange.want_frame_after(sent);
    return {std::move(newest.bytes), kind != Newest::state};
  }
  return {};
}

std::string& Client::room_for(const std::string& bytes, std::size_t before) {
  room_.resize(before + bytes.size());
  std::copy(bytes.begin(), bytes.end(), room_.begin() + static_cast<std::ptrdiff_t>(before));
  return room_;
}

}  // namespace quicksand
