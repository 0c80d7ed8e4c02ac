// Frames of one CAN interface into readings.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "bus/bus_base.hpp"
#include "can/can_port.hpp"
#include "can/source_watch.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/can/frame_decoder.hpp"

namespace rigsound::can {

class CanBus final : public BusBase {
 public:
  /// `port`: kernel_can_port(), or what a test puts in its place. `tap` may be null.
  CanBus(const CanOptions& options, BusListener& listener, CanTap* tap, std::unique_ptr<CanPort> port);

  void step() override;
  std::vector<BusCounter> counters() const override;

 private:
  void open();
  void dispatch(const Arrival* first, std::size_t count);
  void data_frames(const Arrival* first, std::size_t count);
  void controller_error(const Frame& frame);
  void lose(const std::string& why);

  CanSocketOptions options_;
  FrameDecoder decoder_;
  SourceWatch sources_;
  CanTap* tap_;
  std::unique_ptr<CanPort> port_;
  std::unique_ptr<CanSocket> socket_;
  std::vector<Arrival> batch_;
  std::vector<Reading> readings_;
  bool bus_off_ = false;
  std::uint64_t dropped_before_ = 0;  // on sockets that are closed
  std::atomic<std::uint64_t> frames_{0}, used_{0}, error_frames_{0}, dropped_{0}, lost_{0};
};

}  // namespace rigsound::can
