#include "log/modbus_conversation.hpp"

#include <algorithm>

#include "modbus/request.hpp"

namespace rigsound::log {
namespace {

using Frame = std::vector<std::uint8_t>;

constexpr std::size_t kMbap = 7;
constexpr std::size_t kMaxWaiting = 256;

/// The values of the answer to a read of `count`: bits or registers after the byte count.
bool take_values(const Frame& answer, modbus::Table table, int count, std::vector<std::uint16_t>& values) {
  const bool bits = modbus::holds_bits(table);
  const std::size_t bytes = bits ? (count + 7) / 8 : 2 * count;
  if (answer.size() != kMbap + 2 + bytes || answer[kMbap + 1] != bytes) return false;
  const std::uint8_t* data = answer.data() + kMbap + 2;
  for (int i = 0; i < count; ++i)
    values.push_back(
        static_cast<std::uint16_t>(bits ? data[i / 8] >> (i % 8) & 1 : data[2 * i] << 8 | data[2 * i + 1]));
  return true;
}

}  // namespace

void Conversation::request(const Frame& frame) {
  if (waiting_.size() >= kMaxWaiting) waiting_.clear();
  waiting_[static_cast<unsigned>(frame[0] << 8 | frame[1])] = frame;
}

Conversation::Answer Conversation::answer(const Frame& frame, std::vector<modbus::Exchange>& out) {
  const auto asked = waiting_.find(static_cast<unsigned>(frame[0] << 8 | frame[1]));
  if (asked == waiting_.end()) return Answer::kUnpaired;
  const Frame question = std::move(asked->second);
  waiting_.erase(asked);
  if (frame[kMbap] == (question[kMbap] | 0x80)) return Answer::kRefused;
  modbus::Request request;
  const auto doubt = modbus::parse(question.data() + kMbap, question.size() - kMbap, request);
  if (doubt == modbus::Refusal::kFunction) return Answer::kOtherFunction;
  if (doubt || frame[kMbap] != question[kMbap]) return Answer::kUnpaired;

  const int unit = question[kMbap - 1];
  if (request.write) {
    modbus::Exchange written{unit, request.table, true, request.write->address, request.values};
    if (request.masked) {
      const int old = held_[{unit, written.address}];
      written.values = {
          static_cast<std::uint16_t>((old & request.and_mask) | (request.or_mask & ~request.and_mask))};
    }
    out.push_back(written);
  }
  if (request.read) {
    modbus::Exchange read{unit, request.table, false, request.read->address, {}};
    if (!take_values(frame, request.table, request.read->count, read.values)) return Answer::kUnpaired;
    out.push_back(read);
  }
  for (const modbus::Exchange& exchange : out)
    if (exchange.table == modbus::Table::kHolding)
      for (std::size_t i = 0; i < exchange.values.size(); ++i)
        held_[{unit, static_cast<std::uint16_t>(exchange.address + i)}] = exchange.values[i];
  return Answer::kAgreed;
}

}  // namespace rigsound::log
