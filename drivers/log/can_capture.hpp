// A capture of SocketCAN.
#pragma once

#include <optional>

#include "log/capture_file.hpp"
#include "rigsound/log/can_reader.hpp"

namespace rigsound::log {

/// A frame in a packet of link type 227 (SocketCAN), or of Linux "cooked" captures (SLL, SLL2) with a CAN
/// protocol; nothing for any other packet. Without a name of the capture the interface is `can0`, in SLL2
/// `ifN` by its index.
std::optional<CanRecord> parse_can_packet(const CapturedPacket& packet);

/// Packets that are no CAN are counted. Thread: CT, one thread at a time.
class CanCapture : public CanReader {
 public:
  /// Errors: InputError when it is no capture.
  explicit CanCapture(const LogFile& file) : file_(file) {}

  bool next(CanRecord& record) override;
  int line() const override { return 0; }
  double share() const override { return file_.share(); }

 private:
  CaptureFile file_;
};

}  // namespace rigsound::log
