#include <thread>

#include "bus_log.hpp"
#include "feed.hpp"
#include "rigsound/modbus/modbus_link.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {
namespace {

class ModbusFeed : public Feed, private modbus::ModbusListener {
 public:
  ModbusFeed(const modbus::ModbusOptions& options, StateExchange& exchange)
      : exchange_(exchange),
        routes_(options.routes),
        log_("modbus " + options.address),
        link_(modbus::make_modbus_link(options, *this)),
        thread_([this] { link_->run(stop_); }) {}

  ~ModbusFeed() override {
    stop_ = true;
    thread_.join();
  }

  FeedStatus status() const override {
    const modbus::ModbusCounters c = link_->counters();
    return {log_.name(),
            log_.is_up(),
            log_.last_problem(),
            {{"frames_seen", c.requests + c.refused + c.bad_frames},
             {"frames_used", c.requests},
             {"frames_bad", c.bad_frames},
             {"requests_refused", c.refused},
             {"connections_refused", c.turned_away},
             {"losses", c.lost}}};
  }

 private:
  void readings(const std::vector<Reading>& readings) override {
    exchange_.change([&](SignalBoard& board) {
      for (const Reading& reading : readings) board.take(reading);
    });
  }
  void up() override { log_.up(); }
  void down(const std::string& why) override {
    log_.down(why);
    exchange_.change([this](SignalBoard& board) {
      for (const modbus::RegisterRoute& route : routes_) board.take({route.target, 0, Validity::kBusDown, 0});
    });
  }
  void notice(const std::string& text) override { log_.notice(text); }

  StateExchange& exchange_;
  std::vector<modbus::RegisterRoute> routes_;
  BusLog log_;
  std::unique_ptr<modbus::ModbusLink> link_;
  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace

std::unique_ptr<Feed> make_feed(const modbus::ModbusOptions& options, StateExchange& exchange) {
  return std::make_unique<ModbusFeed>(options, exchange);
}

}  // namespace rigsound::daemon
