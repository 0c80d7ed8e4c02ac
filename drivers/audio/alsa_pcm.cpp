// The real stream: libasound, asked in the order channels, rate, format, period, buffer.
#include <alsa/asoundlib.h>

#include <string>

#include "audio/pcm.hpp"
#include "rigsound/audio/sample_format.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::audio {
namespace {

constexpr SampleFormat kPreferred[] = {SampleFormat::kFloat, SampleFormat::kS32, SampleFormat::kS24_3,
                                       SampleFormat::kS16};

snd_pcm_format_t alsa_format(SampleFormat format) {
  switch (format) {
    case SampleFormat::kS32:
      return SND_PCM_FORMAT_S32_LE;
    case SampleFormat::kS24_3:
      return SND_PCM_FORMAT_S24_3LE;
    case SampleFormat::kS16:
      return SND_PCM_FORMAT_S16_LE;
    default:
      return SND_PCM_FORMAT_FLOAT_LE;
  }
}

// libasound prints to stderr on its own; a reopening daemon must not repeat that every few seconds.
void stay_quiet(const char*, int, const char*, int, const char*, ...) {}

struct CloseHandle {
  void operator()(snd_pcm_t* handle) const { snd_pcm_close(handle); }
};
using Handle = std::unique_ptr<snd_pcm_t, CloseHandle>;

template <typename T, int (*Allocate)(T**), void (*Free)(T*)>
struct Params {
  Params() {
    if (Allocate(&get) < 0) throw std::bad_alloc();
  }
  ~Params() { Free(get); }
  Params(const Params&) = delete;
  Params& operator=(const Params&) = delete;
  T* get = nullptr;
};
using HardwareParams = Params<snd_pcm_hw_params_t, snd_pcm_hw_params_malloc, snd_pcm_hw_params_free>;
using SoftwareParams = Params<snd_pcm_sw_params_t, snd_pcm_sw_params_malloc, snd_pcm_sw_params_free>;

std::string abilities(snd_pcm_t* handle) {
  HardwareParams hw;
  if (snd_pcm_hw_params_any(handle, hw.get) < 0) return "it offers no configuration";
  unsigned channels[2] = {}, rate[2] = {};
  snd_pcm_uframes_t period[2] = {}, buffer[2] = {};
  int direction = 0;
  snd_pcm_hw_params_get_channels_min(hw.get, &channels[0]);
  snd_pcm_hw_params_get_channels_max(hw.get, &channels[1]);
  snd_pcm_hw_params_get_rate_min(hw.get, &rate[0], &direction);
  snd_pcm_hw_params_get_rate_max(hw.get, &rate[1], &direction);
  snd_pcm_hw_params_get_period_size_min(hw.get, &period[0], &direction);
  snd_pcm_hw_params_get_period_size_max(hw.get, &period[1], &direction);
  snd_pcm_hw_params_get_buffer_size_min(hw.get, &buffer[0]);
  snd_pcm_hw_params_get_buffer_size_max(hw.get, &buffer[1]);
  const auto range = [](auto low, auto high) { return std::to_string(low) + "..." + std::to_string(high); };
  std::string formats;
  for (const SampleFormat format : kPreferred)
    if (snd_pcm_hw_params_test_format(handle, hw.get, alsa_format(format)) == 0)
      formats.append(" ").append(name(format));
  return "it can do " + range(channels[0], channels[1]) + " channels, " + range(rate[0], rate[1]) +
         " Hz, formats" + formats + ", period " + range(period[0], period[1]) + " frames, buffer " +
         range(buffer[0], buffer[1]) + " frames";
}

class AlsaPcm : public Pcm {
 public:
  explicit AlsaPcm(const AudioOptions& options) : options_(options) {
    snd_lib_error_set_handler(stay_quiet);
    snd_pcm_t* raw = nullptr;
    const int error = snd_pcm_open(&raw, device_name().c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
    if (error < 0)
      throw DeviceError("sound card " + options.device + ": cannot be opened: " + snd_strerror(error));
    handle_.reset(raw);
    set_hardware();
    set_software();
    require(snd_pcm_prepare(raw), "prepare");
  }

  const Granted& granted() const noexcept override { return granted_; }
  long write(const void* frames, unsigned long count) noexcept override {
    return snd_pcm_writei(handle_.get(), frames, count);
  }
  int wait(int timeout_ms) noexcept override { return snd_pcm_wait(handle_.get(), timeout_ms); }
  int prepare() noexcept override { return snd_pcm_prepare(handle_.get()); }
  int resume() noexcept override { return snd_pcm_resume(handle_.get()); }

 private:
  bool raw() const { return options_.device.rfind("hw:", 0) == 0; }

  // Only ALSA's own converter changes rates, and a raw card has none in front of it.
  std::string device_name() const {
    return options_.resample && raw() ? "plug" + options_.device : options_.device;
  }

  void require(int error, const std::string& what) const {
    if (error < 0)
      throw DeviceError("sound card " + options_.device + ": " + what + ": " + snd_strerror(error) + "; " +
                        abilities(handle_.get()));
  }

  void set_format(snd_pcm_hw_params_t* hw) {
    for (const SampleFormat format : kPreferred) {
      if (options_.format != SampleFormat::kAuto && options_.format != format) continue;
      if (snd_pcm_hw_params_set_format(handle_.get(), hw, alsa_format(format)) < 0) continue;
      granted_.format = format;
      return;
    }
    require(-EINVAL, "format " + std::string(name(options_.format)));
  }

  // A raw card does what the rig asks, or says what it can. Behind a mixer (`default`) the period is somebody
  // else's: the nearest is taken, and the description says so.
  void set_buffer(snd_pcm_hw_params_t* hw) {
    snd_pcm_t* h = handle_.get();
    auto period = static_cast<snd_pcm_uframes_t>(options_.block);
    const auto periods = static_cast<snd_pcm_uframes_t>(options_.periods);
    int error = snd_pcm_hw_params_set_period_size(h, hw, period, 0);
    if (error == 0) error = snd_pcm_hw_params_set_buffer_size(h, hw, periods * period);
    if (error < 0 && !raw()) {
      error = snd_pcm_hw_params_set_period_size_near(h, hw, &period, nullptr);
      snd_pcm_uframes_t buffer = periods * period;
      if (error == 0) error = snd_pcm_hw_params_set_buffer_size_near(h, hw, &buffer);
    }
    require(error,
            std::to_string(options_.periods) + " periods of " + std::to_string(options_.block) + " frames");
  }

  void set_hardware() {
    snd_pcm_t* h = handle_.get();
    HardwareParams hw;
    const auto rate = static_cast<unsigned>(options_.rate);
    require(snd_pcm_hw_params_any(h, hw.get), "no configuration");
    require(snd_pcm_hw_params_set_rate_resample(h, hw.get, options_.resample ? 1 : 0), "resampling");
    require(snd_pcm_hw_params_set_access(h, hw.get, SND_PCM_ACCESS_RW_INTERLEAVED), "interleaved access");
    require(snd_pcm_hw_params_set_channels(h, hw.get, static_cast<unsigned>(options_.channels)),
            std::to_string(options_.channels) + " channels");
    require(snd_pcm_hw_params_set_rate(h, hw.get, rate, 0), std::to_string(rate) + " Hz");
    set_format(hw.get);
    set_buffer(hw.get);
    require(snd_pcm_hw_params(h, hw.get), "configuration");
    granted_.rate = options_.rate;
    granted_.channels = options_.channels;
    require(snd_pcm_get_params(h, &granted_.buffer, &granted_.period), "configuration");
  }

  void set_software() {
    snd_pcm_t* h = handle_.get();
    SoftwareParams sw;
    require(snd_pcm_sw_params_current(h, sw.get), "stream settings");
    const auto block = static_cast<snd_pcm_uframes_t>(options_.block);
    require(snd_pcm_sw_params_set_avail_min(h, sw.get, block), "wake-up");
    require(snd_pcm_sw_params_set_start_threshold(h, sw.get, granted_.buffer / block * block), "start");
    require(snd_pcm_sw_params_set_tstamp_mode(h, sw.get, SND_PCM_TSTAMP_ENABLE), "time stamps");
    require(snd_pcm_sw_params_set_tstamp_type(h, sw.get, SND_PCM_TSTAMP_TYPE_MONOTONIC), "time stamps");
    require(snd_pcm_sw_params(h, sw.get), "stream settings");
  }

  AudioOptions options_;
  Handle handle_;
  Granted granted_;
};

}  // namespace

std::unique_ptr<Pcm> open_alsa(const AudioOptions& options) { return std::make_unique<AlsaPcm>(options); }

}  // namespace rigsound::audio
