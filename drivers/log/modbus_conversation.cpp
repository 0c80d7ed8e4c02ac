#include "log/modbus_conversation.hpp"

#include <algorithm>

#include "modbus/pdu.hpp"
#include "modbus/request.hpp"
#include "modbus/tcp_frame.hpp"

namespace rigsound::log {
namespace {

using modbus::kMbap;
using Frame = std::vector<std::uint8_t>;

constexpr std::size_t kMaxWaiting = 256;

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
    read.values.resize(request.read->count);
    if (!modbus::take_read(frame.data() + kMbap, frame.size() - kMbap, read)) return Answer::kUnpaired;
    out.push_back(read);
  }
  for (const modbus::Exchange& exchange : out)
    if (exchange.table == modbus::Table::kHolding)
      for (std::size_t i = 0; i < exchange.values.size(); ++i)
        held_[{unit, static_cast<std::uint16_t>(exchange.address + i)}] = exchange.values[i];
  return Answer::kAgreed;
}

}  // namespace rigsound::log
