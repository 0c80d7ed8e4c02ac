// A CAN interface as it is in a cabin: there, down, gone, back again.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/can/frame.hpp"
#include "rigsound/can/signal_layout.hpp"

namespace rigsound {
class Complaints;
}

namespace rigsound::can {

class CanPort;
class CanLink;

struct Arrival {
  Frame frame;
  double realtime_s = 0;  ///< when the kernel got it, seconds since 1970; 0: it did not say
};

/// Told what happens on the interface, from the thread that runs the bus.
class CanListener {
 public:
  virtual ~CanListener() = default;
  virtual void frames(const Arrival* first, std::size_t count) = 0;  ///< data frames, in order of arrival
  virtual void up() = 0;                                             ///< the interface delivers from now on
  virtual void down(const std::string& why) = 0;     ///< it no longer does; every signal of it is in doubt
  virtual void notice(const std::string& text) = 0;  ///< worth a line in the log
};

struct CanBusOptions {
  std::string interface;
  bool fd = false;
  bool everything = false;           ///< no filter: all data frames (for recording)
  std::vector<MessageMatch> wanted;  ///< otherwise the kernel passes these and controller errors only
};

struct CanCounters {
  std::uint64_t frames = 0;  ///< data frames received
  std::uint64_t error_frames = 0;
  std::uint64_t dropped = 0;  ///< by the kernel, because nobody fetched them in time
  std::uint64_t lost = 0;     ///< times the interface went away
};

/// Opens the interface, reads it, and opens it again after every loss: when the kernel reports a change of
/// links, at the latest after a pause of 0.1 s doubling to 5 s.
class CanBus {
 public:
  CanBus(CanBusOptions options, CanListener& listener);
  CanBus(CanBusOptions options, CanListener& listener, std::unique_ptr<CanPort> port);  ///< for tests
  ~CanBus();

  void run(const std::atomic<bool>& stop);  ///< until `stop`, noticed within 0.2 s. Thread: the bus's own
  void step();                              ///< one round of run(): waits at most 0.2 s

  CanCounters counters() const noexcept;  ///< Thread: any

 private:
  void look_for_interface();
  void sort(const Arrival* first, std::size_t count);
  void controller_error(const Frame& frame);
  void lose(const std::string& why);

  CanBusOptions options_;
  CanListener& listener_;
  std::unique_ptr<CanPort> port_;
  std::unique_ptr<CanLink> link_;
  std::unique_ptr<Complaints> complaints_;
  std::vector<Arrival> batch_;
  std::string last_problem_;
  int pause_ms_;
  bool bus_off_ = false;
  std::uint64_t dropped_before_ = 0;  // on links that are closed
  std::atomic<std::uint64_t> frames_{0}, error_frames_{0}, dropped_{0}, lost_{0};
};

}  // namespace rigsound::can
