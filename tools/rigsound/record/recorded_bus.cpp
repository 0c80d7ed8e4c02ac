#include "record/recorded_bus.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "rigsound/device_error.hpp"

namespace rigsound::tools {

RecordedBus::RecordedBus(const std::function<std::unique_ptr<Bus>(BusListener&)>& make)
    : bus_(make(*this)), thread_([this] { bus_->run(); }) {}

RecordedBus::~RecordedBus() {
  bus_->stop();
  thread_.join();
  std::string counters;
  for (const BusCounter& counter : bus_->counters())
    if (counter.count > 0) counters += fmt::format(" {} {}", counter.name, counter.count);
  if (!counters.empty()) fmt::print(stderr, "{}:{}\n", bus_->name(), counters);
}

void RecordedBus::require_up() {
  const std::string problem = first_problem_.get_future().get();
  if (!problem.empty()) throw DeviceError(problem);
}

void RecordedBus::up() {
  fmt::print(stderr, "{}: recording\n", bus_->name());
  if (!told_.exchange(true)) first_problem_.set_value({});
}

void RecordedBus::down(const std::string& why) { fmt::print(stderr, "{}: down: {}\n", bus_->name(), why); }

void RecordedBus::notice(const std::string& text) {
  const std::string named = bus_->name() + ": " + text;
  if (told_.exchange(true)) return fmt::print(stderr, "{}\n", named);
  first_problem_.set_value(named);
}

}  // namespace rigsound::tools
