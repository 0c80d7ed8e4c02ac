// frame_to_sound PCM INTERFACE|HOST:PORT PERIOD TRIES: time from a CAN frame, or a datagram, to the first
// sample it changes. The diesel runs, the master gain goes from -60 dB to 0 dB. Prints one line a try,
// `latency_ms X`: from the moment before send() to the moment the first louder sample is captured.
#include <alsa/asoundlib.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rigsound/can/can_sender.hpp"
#include "rigsound/udp/udp_sender.hpp"

using namespace rigsound;

namespace {

constexpr unsigned kRate = 48000, kChannels = 2;

double now_s() {
  timespec t{};
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

can::Frame message(std::uint32_t id, std::array<std::uint8_t, 8> bytes) {
  can::Frame f;
  f.id = id;
  f.extended = true;
  f.size = 8;
  std::copy(bytes.begin(), bytes.end(), f.data.begin());
  return f;
}

// config/dbc/rig.dbc: EEC1 with 2000 r/min, and CABIN1 with the gain.
can::Frame diesel_on() { return message(0x0CF004FE, {0xFF, 0xFF, 0xFF, 0x80, 0x3E, 0xFF, 0xFF, 0xFF}); }
can::Frame master_gain(double db) {
  const auto raw = static_cast<std::uint8_t>((db + 60) / 0.5);
  return message(0x18FF11FE, {raw, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF});
}

/// The simulator's end of a bus.
class Sender {
 public:
  virtual ~Sender() = default;
  virtual void diesel_on() = 0;
  virtual void master_gain(double db) = 0;
};

class CanEnd : public Sender {
 public:
  explicit CanEnd(const std::string& interface) : bus_(interface) {}
  void diesel_on() override { bus_.send(::diesel_on()); }
  void master_gain(double db) override { bus_.send(::master_gain(db)); }

 private:
  can::CanSender bus_;
};

class UdpEnd : public Sender {
 public:
  explicit UdpEnd(const std::string& address) : socket_(address) {}
  void diesel_on() override { socket_.send(R"({"engine_rpm": 2000})"); }
  void master_gain(double db) override { socket_.send(R"({"master_gain_db": )" + std::to_string(db) + "}"); }

 private:
  udp::UdpSender socket_;
};

std::unique_ptr<Sender> sender_to(const std::string& where) {
  if (where.find(':') != std::string::npos) return std::make_unique<UdpEnd>(where);
  return std::make_unique<CanEnd>(where);
}

class Capture {
 public:
  Capture(const std::string& name, unsigned period) : samples_(period * kChannels) {
    require(snd_pcm_open(&pcm_, name.c_str(), SND_PCM_STREAM_CAPTURE, 0));
    snd_pcm_hw_params_t* hw = nullptr;
    snd_pcm_hw_params_alloca(&hw);
    require(snd_pcm_hw_params_any(pcm_, hw));
    require(snd_pcm_hw_params_set_access(pcm_, hw, SND_PCM_ACCESS_RW_INTERLEAVED));
    require(snd_pcm_hw_params_set_format(pcm_, hw, SND_PCM_FORMAT_FLOAT));
    require(snd_pcm_hw_params_set_channels(pcm_, hw, kChannels));
    require(snd_pcm_hw_params_set_rate(pcm_, hw, kRate, 0));
    require(snd_pcm_hw_params_set_period_size(pcm_, hw, period, 0));
    require(snd_pcm_hw_params(pcm_, hw));
    require(snd_pcm_start(pcm_));
  }
  ~Capture() { snd_pcm_close(pcm_); }

  /// Reads one period; returns when its last sample was captured.
  double read() {
    const auto frames = samples_.size() / kChannels;
    const snd_pcm_sframes_t got = snd_pcm_readi(pcm_, samples_.data(), frames);
    if (got == -EPIPE) {
      require(snd_pcm_prepare(pcm_));
      require(snd_pcm_start(pcm_));
      return read();
    }
    require(static_cast<int>(got));
    return now_s();
  }

  float peak() const {
    float most = 0;
    for (const float x : samples_) most = std::max(most, std::fabs(x));
    return most;
  }
  /// First frame of the period louder than `level`, or -1.
  int first_above(float level) const {
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (std::fabs(samples_[i]) > level) return static_cast<int>(i / kChannels);
    return -1;
  }
  int frames() const { return static_cast<int>(samples_.size() / kChannels); }

 private:
  static void require(int result) {
    if (result < 0) throw std::runtime_error(std::string("capture: ") + snd_strerror(result));
  }
  snd_pcm_t* pcm_ = nullptr;
  std::vector<float> samples_;
};

// The engine's own smoothing of the gain rings out long before that.
float peak_when_quiet(Capture& capture) {
  float peak = 0;
  for (double t = 0; t < 0.6; t += capture.frames() / static_cast<double>(kRate)) {
    capture.read();
    if (t > 0.4) peak = std::max(peak, capture.peak());
  }
  return peak;
}

double measure(Capture& capture, Sender& bus) {
  bus.master_gain(-60);
  const float quiet = peak_when_quiet(capture);
  if (quiet == 0) throw std::runtime_error("no sound at all");
  const double sent_s = now_s();
  bus.master_gain(0);
  for (;;) {
    const double end_s = capture.read();
    const int first = capture.first_above(4 * quiet);
    if (first >= 0) return end_s - (capture.frames() - first) / static_cast<double>(kRate) - sent_s;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5)
    return std::fprintf(stderr, "usage: frame_to_sound PCM INTERFACE|HOST:PORT PERIOD TRIES\n"), 2;
  ::mlockall(MCL_CURRENT | MCL_FUTURE);
  try {
    Capture capture(argv[1], static_cast<unsigned>(std::atoi(argv[3])));
    const std::unique_ptr<Sender> bus = sender_to(argv[2]);
    bus->diesel_on();
    for (int i = 0; i < std::atoi(argv[4]); ++i)
      std::printf("latency_ms %.3f\n", 1e3 * measure(capture, *bus));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
