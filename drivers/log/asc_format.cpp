// Vector ASC (as CANalyzer, CANoe and python-can write it).
#include <optional>

#include "log/can_lines.hpp"
#include "log/token_list.hpp"

namespace rigsound::log {
namespace {

constexpr std::uint32_t kMostChannels = 255;
constexpr std::uint32_t kFdFlag = 0x1000;  // EDL, in the flags of a CANFD line

class AscFormat : public CanLineFormat {
 public:
  CanLine parse(std::string_view line, CanRecord& record) override {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    const TokenList tokens(line);
    if (tokens[0] == "base") return read_header(tokens), CanLine::kOther;
    const auto stamp = decimal_ns(tokens[0], kNano);
    if (!stamp) return CanLine::kOther;
    last_ns_ = relative_ ? std::min(last_ns_ + *stamp, kMaxSeconds * kNano) : *stamp;
    can::Frame frame;
    std::optional<std::uint32_t> channel;
    const bool good =
        tokens[1] == "CANFD" ? parse_fd(tokens, frame, channel) : parse_classic(tokens, frame, channel);
    if (!good) return CanLine::kOther;
    record = {last_ns_, interface_of_channel(*channel), frame};
    return CanLine::kFrame;
  }

  bool begins_a_frame(std::string_view line) const override {
    const TokenList tokens(line);
    const bool told = tokens.size() > 2 && tokens[2].back() == ':';  // Statistic: ...
    return tokens.size() > 2 && !told && decimal_ns(tokens[0], kNano) &&
           (tokens[1] == "CANFD" || number_of(tokens[1], 10, kMostChannels));
  }

 private:
  void read_header(const TokenList& tokens) {
    base_ = tokens[1] == "dec" ? 10 : 16;
    relative_ = tokens[2] == "timestamps" && tokens[3] == "relative";
  }

  /// `CF00400x` is an identifier of 29 bits.
  bool parse_id(std::string_view text, can::Frame& frame) const {
    frame.extended = !text.empty() && (text.back() == 'x' || text.back() == 'X');
    if (frame.extended) text.remove_suffix(1);
    const auto id = number_of(text, base_, frame.extended ? can::kMaxExtendedId : can::kMaxStandardId);
    frame.id = id.value_or(0);
    return id.has_value();
  }

  // TIME CHANNEL ID DIRECTION d LENGTH BYTES..., or TIME CHANNEL ErrorFrame
  bool parse_classic(const TokenList& tokens, can::Frame& frame,
                     std::optional<std::uint32_t>& channel) const {
    channel = number_of(tokens[1], 10, kMostChannels);
    if (!channel) return false;
    if (tokens[2] == "ErrorFrame") return frame.error = true;
    const bool sent = tokens[3] == "Rx" || tokens[3] == "Tx";  // TxRq asks for what comes as Tx
    if (!sent || !parse_id(tokens[2], frame)) return false;
    const auto code = number_of(tokens[5], 16, 15);
    frame.size = static_cast<std::uint8_t>(std::min<std::uint32_t>(code.value_or(0), 8));
    frame.remote = tokens[4] == "r";
    if (frame.remote) return true;
    return tokens[4] == "d" && code && take_bytes(tokens, 6, base_, frame);
  }

  // TIME CANFD CHANNEL DIRECTION ID [NAME] BRS ESI CODE LENGTH BYTES... DURATION BITS FLAGS ...
  bool parse_fd(const TokenList& tokens, can::Frame& frame, std::optional<std::uint32_t>& channel) const {
    channel = number_of(tokens[2], 10, kMostChannels);
    if (!channel || (tokens[3] != "Rx" && tokens[3] != "Tx")) return false;
    if (tokens[4] == "ErrorFrame") return frame.error = true;
    if (!parse_id(tokens[4], frame)) return false;
    const std::size_t at = number_of(tokens[5], 2, 1) && number_of(tokens[6], 2, 1) ? 5 : 6;
    const auto brs = number_of(tokens[at], 2, 1), esi = number_of(tokens[at + 1], 2, 1);
    const auto length = number_of(tokens[at + 3], 10, can::kMaxData);
    if (!brs || !esi || !length) return false;
    frame.size = static_cast<std::uint8_t>(*length);
    const std::size_t flags_at = at + 4 + *length + 2;
    const auto flags = number_of(tokens[flags_at], 16, 0xFFFFFFFF);
    frame.fd = !flags || (*flags & kFdFlag) != 0;
    frame.bit_rate_switch = frame.fd && *brs != 0;
    frame.error_passive = frame.fd && *esi != 0;
    return (frame.fd || frame.size <= 8) && take_bytes(tokens, at + 4, base_, frame);
  }

  int base_ = 16;
  bool relative_ = false;
  std::int64_t last_ns_ = 0;
};

}  // namespace

std::unique_ptr<CanLineFormat> asc_format() { return std::make_unique<AscFormat>(); }

}  // namespace rigsound::log
