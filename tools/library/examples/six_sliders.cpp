// six_sliders RIG.toml [DEVICE]: plays a rig through ALSA and moves its live controls by the keyboard.
//
//   c++ -std=c++17 six_sliders.cpp $(pkg-config --cflags --libs rigsound alsa) -o six_sliders
//
// One thread plays, the other reads keys; rigsound hands what was set from one to the other.
#include <alsa/asoundlib.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <rigsound.hpp>
#include <string>
#include <thread>

namespace {

struct Slider {
  const char* name;
  char down, up;
  double value, step, lowest, highest;
};

// The six controls of the paper, and what the machine does.
Slider sliders[] = {
    {"feed_pressure_bar", 'f', 'F', 90, 5, 0, 300}, {"engine_rpm", 'r', 'R', 1500, 50, 0, 4000},
    {"mean_frequency_hz", 'q', 'Q', 35, 1, 1, 120}, {"mean_amplitude_db", 'w', 'W', 0, 1, -60, 24},
    {"deviation_time", 'e', 'E', 1, 0.1, 0, 4},     {"deviation_amplitude", 't', 'T', 1, 0.1, 0, 4},
    {"attack_factor", 'a', 'A', 1, 0.1, 0.1, 10},   {"decay_factor", 'd', 'D', 1, 0.1, 0.25, 10},
};

void apply(rigsound::Sound& sound, const Slider& slider) {
  if (&slider < sliders + 2)
    sound.set(slider.name, slider.value);
  else
    sound.control(slider.name, slider.value);
}

/// Keys come one by one, unechoed, until this goes.
class RawKeyboard {
 public:
  RawKeyboard() {
    given_ = tcgetattr(STDIN_FILENO, &before_) == 0;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    if (given_) tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  ~RawKeyboard() {
    if (given_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }

 private:
  termios before_{};
  bool given_;
};

snd_pcm_t* open_card(const char* device, const rigsound::Sound& sound) {
  snd_pcm_t* card = nullptr;
  int error = snd_pcm_open(&card, device, SND_PCM_STREAM_PLAYBACK, 0);
  if (error == 0)
    error = snd_pcm_set_params(card, SND_PCM_FORMAT_FLOAT, SND_PCM_ACCESS_RW_INTERLEAVED,
                               static_cast<unsigned>(sound.channels()), static_cast<unsigned>(sound.rate()),
                               1, 20000);
  if (error < 0) throw std::runtime_error(std::string(device) + ": " + snd_strerror(error));
  return card;
}

void play(rigsound::Sound& sound, snd_pcm_t* card, const std::atomic<bool>& stop) {
  std::vector<float> block = sound.make_block();
  while (!stop) {
    sound.process(block.data());
    const snd_pcm_sframes_t written =
        snd_pcm_writei(card, block.data(), static_cast<snd_pcm_uframes_t>(sound.block()));
    if (written < 0 && snd_pcm_recover(card, static_cast<int>(written), 1) < 0) return;
  }
}

void show(const rigsound::Sound& sound) {
  std::printf("\r");
  for (const Slider& slider : sliders)
    std::printf("%c/%c %s %g  ", slider.down, slider.up, slider.name, slider.value);
  std::printf("peak %.2f ", static_cast<double>(sound.meters().peak));
  std::fflush(stdout);
}

/// Moves the slider whose key it is. False: the key ends the program.
bool handle(rigsound::Sound& sound, char key) {
  for (Slider& slider : sliders) {
    if (key != slider.up && key != slider.down) continue;
    const double wanted = slider.value + (key == slider.up ? slider.step : -slider.step);
    slider.value = wanted < slider.lowest ? slider.lowest : wanted > slider.highest ? slider.highest : wanted;
    apply(sound, slider);
  }
  return key != 'x';
}

void listen(rigsound::Sound& sound) {
  const RawKeyboard keyboard;
  for (const Slider& slider : sliders) apply(sound, slider);
  char key = 0;
  do {
    show(sound);
  } while (::read(STDIN_FILENO, &key, 1) == 1 && handle(sound, key));
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2)
    throw std::runtime_error(
        "usage: six_sliders RIG.toml [DEVICE]; a key lowers, with Shift it raises, x ends");
  rigsound::Sound sound(arguments[1]);
  snd_pcm_t* const card = open_card(count > 2 ? arguments[2] : "default", sound);
  std::atomic<bool> stop{false};
  std::thread player([&] { play(sound, card, stop); });
  listen(sound);
  stop = true;
  player.join();
  snd_pcm_close(card);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
