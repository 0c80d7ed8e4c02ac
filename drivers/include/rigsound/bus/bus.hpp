// A live fieldbus of any kind: readings, news and counters come out of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/bus/stop_event.hpp"
#include "rigsound/machine/reading.hpp"

namespace rigsound {

/// Told what happens on a bus, from the thread that runs it.
class BusListener {
 public:
  virtual ~BusListener() = default;

  /// In the order of the bus; each carries the time its message came, in monotonic_s().
  virtual void readings(const Reading* first, std::size_t count) = 0;
  virtual void up() = 0;  ///< the bus delivers from now on
  /// It no longer does. Readings of kBusDown for every signal of the bus came just before.
  virtual void down(const std::string& why) = 0;
  virtual void notice(
      const std::string& text) = 0;  ///< worth a line in the log, seldom more than one a second
};

/// Told the raw traffic of a bus, for recording, from the thread that runs it.
template <typename Message>
class BusTap {
 public:
  virtual ~BusTap() = default;
  virtual void traffic(const Message* first, std::size_t count) = 0;  ///< in order of arrival
};

struct BusCounter {
  std::string_view name;  ///< as in `ctl status`: frames_seen, frames_used, losses, ...
  std::uint64_t count = 0;
};

/// Made by make_bus() of its kind. A device that is missing or goes away is no error: it is looked for with
/// pauses of 0.1 s doubling to 5 s.
class Bus {
 public:
  virtual ~Bus() = default;

  virtual const std::string& name() const = 0;               ///< "can can0", "modbus HOST:PORT"
  virtual const std::vector<SignalId>& signals() const = 0;  ///< what it delivers
  virtual std::vector<BusCounter> counters() const = 0;      ///< Thread: any

  /// Rounds until stop(). Thread: the bus's own
  void run() {
    while (!stopped()) step();
  }
  virtual void step() = 0;  ///< one round: waits at most 0.2 s unless the device itself takes longer

  /// Ends the round under way, whatever it waits for, and run(). Thread: any
  void stop() noexcept { stop_event_.set(); }
  bool stopped() const noexcept { return stop_event_.is_set(); }  ///< Thread: any

 protected:
  const StopEvent& stop_event() const noexcept { return stop_event_; }

 private:
  StopEvent stop_event_;
};

}  // namespace rigsound
