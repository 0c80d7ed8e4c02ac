// period_clock PERIOD [RATE]: keeps snd-dummy playing silence, so that its periods can be the clock of
// snd-aloop (timer_source = hw:Dummy,0), which by itself ticks every 4 ms only. Says `running`, then stays.
#include <alsa/asoundlib.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr unsigned kPeriods = 4;

void require(int result, const char* what) {
  if (result >= 0) return;
  std::fprintf(stderr, "period_clock: %s: %s\n", what, snd_strerror(result));
  std::exit(3);
}

// Never stops for want of samples: the stop threshold is out of reach.
void run_free(snd_pcm_t* pcm) {
  snd_pcm_sw_params_t* settings = nullptr;
  snd_pcm_sw_params_alloca(&settings);
  snd_pcm_uframes_t boundary = 0;
  require(snd_pcm_sw_params_current(pcm, settings), "stream settings");
  require(snd_pcm_sw_params_get_boundary(settings, &boundary), "boundary");
  require(snd_pcm_sw_params_set_stop_threshold(pcm, settings, boundary), "stop threshold");
  require(snd_pcm_sw_params_set_start_threshold(pcm, settings, 1), "start threshold");
  require(snd_pcm_sw_params(pcm, settings), "stream settings");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: period_clock PERIOD [RATE]\n"), 2;
  const auto period = static_cast<snd_pcm_uframes_t>(std::atoi(argv[1]));
  const auto rate = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 48000);
  snd_pcm_t* pcm = nullptr;
  require(snd_pcm_open(&pcm, "hw:Dummy,0", SND_PCM_STREAM_PLAYBACK, 0), "hw:Dummy,0");
  snd_pcm_hw_params_t* hardware = nullptr;
  snd_pcm_hw_params_alloca(&hardware);
  require(snd_pcm_hw_params_any(pcm, hardware), "configuration");
  require(snd_pcm_hw_params_set_access(pcm, hardware, SND_PCM_ACCESS_RW_INTERLEAVED), "access");
  require(snd_pcm_hw_params_set_format(pcm, hardware, SND_PCM_FORMAT_S16), "format");
  require(snd_pcm_hw_params_set_channels(pcm, hardware, 2), "channels");
  require(snd_pcm_hw_params_set_rate(pcm, hardware, rate, 0), "rate");
  require(snd_pcm_hw_params_set_period_size(pcm, hardware, period, 0), "period");
  require(snd_pcm_hw_params_set_periods(pcm, hardware, kPeriods, 0), "periods");
  require(snd_pcm_hw_params(pcm, hardware), "configuration");
  run_free(pcm);
  const std::vector<short> silence(2 * period);
  require(static_cast<int>(snd_pcm_writei(pcm, silence.data(), period)), "first period");
  std::puts("running");
  std::fflush(stdout);
  ::pause();
}
