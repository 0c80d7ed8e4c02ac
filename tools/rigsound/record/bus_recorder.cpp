#include "record/bus_recorder.hpp"

#include <chrono>
#include <mutex>
#include <optional>
#include <vector>

#include "record/recorded_bus.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/log/candump.hpp"
#include "rigsound/log/modbus_capture_writer.hpp"
#include "rigsound/log/udp_capture_writer.hpp"
#include "rigsound/modbus/modbus_bus.hpp"
#include "rigsound/udp/udp_bus.hpp"

namespace rigsound::tools {
namespace {

std::int64_t realtime_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

void write(log::CandumpWriter& out, const can::CanOptions& bus, const can::Arrival& arrival) {
  out.write({static_cast<std::int64_t>(arrival.realtime_s * 1e9), bus.interface, arrival.frame});
}

void write(log::ModbusCaptureWriter& out, const modbus::Line& line, const modbus::Exchange& exchange) {
  out.write(realtime_ns(), {line.front().host, line.front().port}, exchange);
}

void write(log::UdpCaptureWriter& out, const udp::UdpOptions& input, const udp::Datagram& datagram) {
  out.write(static_cast<std::int64_t>(datagram.realtime_s * 1e9), input.port, datagram.text);
}

/// Several buses of one kind, one file. Each bus writes to it from its own thread.
template <typename Options, typename Message, typename Writer>
class FileRecorder : public BusRecorder {
 public:
  /// The file is opened once all buses are up; what comes meanwhile waits.
  FileRecorder(const std::vector<Options>& buses, const std::filesystem::path& file) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Options& bus : buses) {
      taps_.push_back(std::make_unique<Tap>(bus, *this));
      buses_.push_back(std::make_unique<RecordedBus>(
          [&](BusListener& listener) { return make_bus(bus, listener, taps_.back().get()); }));
    }
    for (const auto& bus : buses_) bus->require_up();
    writer_.emplace(file);
  }

  void flush() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    writer_->flush();
  }
  std::uint64_t entries() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return entries_;
  }

 private:
  class Tap : public BusTap<Message> {
   public:
    Tap(const Options& options, FileRecorder& recorder) : options_(options), recorder_(recorder) {}
    void traffic(const Message* first, std::size_t count) override {
      const std::lock_guard<std::mutex> lock(recorder_.mutex_);
      if (!recorder_.writer_) return;
      for (const Message* message = first; message != first + count; ++message)
        write(*recorder_.writer_, options_, *message);
      recorder_.entries_ += count;
    }

   private:
    const Options options_;
    FileRecorder& recorder_;
  };

  mutable std::mutex mutex_;
  std::optional<Writer> writer_;  // none before all buses are up
  std::uint64_t entries_ = 0;
  std::vector<std::unique_ptr<Tap>> taps_;
  std::vector<std::unique_ptr<RecordedBus>> buses_;  // after all that they use
};

}  // namespace

std::unique_ptr<BusRecorder> record_can(const config::Rig& rig, const std::filesystem::path& file) {
  return std::make_unique<FileRecorder<can::CanOptions, can::Arrival, log::CandumpWriter>>(rig.can, file);
}

std::unique_ptr<BusRecorder> record_modbus(const config::Rig& rig, const std::filesystem::path& file) {
  return std::make_unique<FileRecorder<modbus::Line, modbus::Exchange, log::ModbusCaptureWriter>>(
      modbus::lines(rig.modbus), file);
}

std::unique_ptr<BusRecorder> record_udp(const config::Rig& rig, const std::filesystem::path& file) {
  return std::make_unique<FileRecorder<udp::UdpOptions, udp::Datagram, log::UdpCaptureWriter>>(rig.udp, file);
}

}  // namespace rigsound::tools
