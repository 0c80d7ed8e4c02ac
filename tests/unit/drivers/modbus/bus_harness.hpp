// Runs a bus on its own thread and keeps what it told.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "rigsound/modbus/modbus_bus.hpp"

namespace rigsound::modbus {

class Told : public BusListener, public ModbusTap {
 public:
  void readings(const Reading* first, std::size_t count) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Reading* r = first; r != first + count; ++r) latest_[r->id.signal] = *r;
    total_ += count;
  }
  void traffic(const Exchange* first, std::size_t count) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    exchanges_.insert(exchanges_.end(), first, first + count);
  }
  void up() override { add(ups_); }
  void down(const std::string& why) override { add(downs_, why); }
  void notice(const std::string& text) override { add(notices_, text); }

  std::size_t total() const { return get(total_); }
  std::vector<Exchange> exchanges() const { return get(exchanges_); }
  int ups() const { return get(ups_); }
  int downs() const { return get(downs_); }
  int notices() const { return get(notices_); }
  std::string last_text() const { return get(text_); }
  /// The latest reading; validity kNeverSeen when there was none.
  Reading of(Signal s) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = latest_.find(s);
    return found == latest_.end() ? Reading{{s}, 0, Validity::kNeverSeen} : found->second;
  }

 private:
  void add(int& counter, const std::string& text = {}) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counter;
    if (!text.empty()) text_ = text;
  }
  template <typename T>
  T get(const T& what) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return what;
  }

  mutable std::mutex mutex_;
  std::map<Signal, Reading> latest_;
  std::size_t total_ = 0;
  std::vector<Exchange> exchanges_;
  int ups_ = 0, downs_ = 0, notices_ = 0;
  std::string text_;
};

/// Polls until `done`; fails the test after a minute, which only a hang can need.
inline void await(const std::function<bool()>& done) {
  for (int i = 0; i < 60000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  REQUIRE(done());
}

class Running {
 public:
  explicit Running(Bus& bus) : bus_(bus), thread_([&bus] { bus.run(); }) {}
  ~Running() {
    bus_.stop();
    thread_.join();
  }

 private:
  Bus& bus_;
  std::thread thread_;
};

/// Fails the test when the bus has no counter of that name.
inline std::uint64_t count(const Bus& bus, std::string_view name) {
  for (const BusCounter& counter : bus.counters())
    if (counter.name == name) return counter.count;
  FAIL("no counter of that name");
  return 0;
}

inline RegisterRoute route(Signal s, Table table, std::uint16_t address, WordType type = WordType::kUint16,
                           WordOrder order = WordOrder::kAbcd, double scale = 1) {
  RegisterRoute r;
  r.target = {s, 0};
  r.table = table;
  r.address = address;
  r.type = type;
  r.order = order;
  r.scale = scale;
  return r;
}

}  // namespace rigsound::modbus
