// Every error a card can answer with: each block reaches the card once and in order, whatever happened.
#include "audio/alsa_sink.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cerrno>
#include <numeric>
#include <thread>

#include "drivers/audio/fake_card.hpp"
#include "rigsound/device_error.hpp"

using namespace rigsound;
using namespace rigsound::audio;

namespace {

constexpr int kBlock = 64, kPeriods = 3;

struct Rig {
  explicit Rig(bool present = true, int periods = kPeriods) {
    card.present = present;
    options.block = kBlock;
    options.periods = periods;
    options.channels = 1;
    const auto open = [this](const AudioOptions& o) -> std::unique_ptr<Pcm> {
      const std::lock_guard<std::mutex> answered(card.answers);
      ++opens;
      if (!card.present) throw DeviceError("sound card: no such device");
      return std::make_unique<FakePcm>(card, o);
    };
    sink = std::make_unique<AlsaSink>(options, open, clock);
  }

  /// Until nothing is being opened or closed any more.
  void poll() {
    for (sink->poll(); sink->busy(); sink->poll()) std::this_thread::yield();
  }

  /// Plays `count` blocks of a ramp 1, 2, 3, ... that never is silent.
  void play(int count) {
    for (int i = 0; i < count; ++i, ++number) {
      std::vector<float> block(kBlock);
      std::iota(block.begin(), block.end(), static_cast<float>(number * kBlock + 1));
      sink->write(block.data(), number);
    }
  }

  /// What was heard without the silence of starts, and that silence.
  std::vector<float> ramp() const {
    std::vector<float> kept;
    for (const float x : card.heard)
      if (x != 0) kept.push_back(x);
    return kept;
  }
  std::size_t silence() const { return card.heard.size() - ramp().size(); }
  std::uint64_t events(CardEvent e) const { return sink->status().events[static_cast<std::size_t>(e)]; }

  FakeCard card;
  FakeClock clock;
  AudioOptions options;
  std::unique_ptr<AlsaSink> sink;
  std::uint64_t number = 0;
  int opens = 0;
};

std::vector<float> ramp(int blocks) {
  std::vector<float> wanted(static_cast<std::size_t>(blocks * kBlock));
  std::iota(wanted.begin(), wanted.end(), 1.0F);
  return wanted;
}

constexpr std::size_t kPrefill = (kPeriods - 1) * kBlock;
constexpr int kFirstBlockWrite = kPeriods - 1;  // index of the write call that carries block 0

}  // namespace

TEST_CASE("A start fills all but one period with silence, then plays every block") {
  Rig rig;
  rig.play(10);
  CHECK(rig.ramp() == ramp(10));
  CHECK(rig.silence() == kPrefill);
  CHECK(rig.clock.sleeps == 0);
}

TEST_CASE("Errors the stream recovers from keep every sample and its order") {
  struct Case {
    long error;
    CardEvent event;
    int prepares;
    std::size_t silence;
  };
  for (const Case& c :
       {Case{-EPIPE, CardEvent::kXrun, 2, 2 * kPrefill}, Case{-EBADFD, CardEvent::kBadState, 2, 2 * kPrefill},
        Case{-ESTRPIPE, CardEvent::kSuspend, 1, kPrefill}, Case{-EINTR, CardEvent::kInterrupted, 1, kPrefill},
        Case{17, CardEvent::kShortWrite, 1, kPrefill}}) {
    CAPTURE(c.error);
    Rig rig;
    rig.card.at[kFirstBlockWrite + 3] = c.error;
    rig.play(10);
    CHECK(rig.ramp() == ramp(10));
    CHECK(rig.silence() == c.silence);
    CHECK(rig.events(c.event) == 1);
    CHECK(rig.card.prepares == c.prepares);
    CHECK(rig.events(CardEvent::kLost) == 0);
    CHECK(rig.sink->status().playing);
  }
}

TEST_CASE("An xrun in the middle of a block plays the rest of it") {
  Rig rig;
  rig.card.at[kFirstBlockWrite + 3] = 20;
  rig.card.at[kFirstBlockWrite + 4] = -EPIPE;
  rig.play(10);
  CHECK(rig.ramp() == ramp(10));
  CHECK(rig.events(CardEvent::kXrun) == 1);
}

TEST_CASE("A suspended card is resumed once; when it cannot, the stream is prepared") {
  Rig rig;
  rig.card.resume_answer = -ENOSYS;
  rig.card.at[kFirstBlockWrite + 3] = -ESTRPIPE;
  rig.play(10);
  CHECK(rig.card.resumes == 1);
  CHECK(rig.card.prepares == 2);
  CHECK(rig.ramp() == ramp(10));
}

TEST_CASE("Every block ends with the wait for room, so that the next one begins with the newest state") {
  Rig rig;
  rig.play(5);
  CHECK(rig.card.waits == 5);
  rig.card.at[rig.card.writes] = -EAGAIN;
  rig.play(1);
  CHECK(rig.card.waits == 7);
  CHECK(rig.ramp() == ramp(6));
}

TEST_CASE("An error of the wait is handled like one of the write") {
  for (const int error : {-EPIPE, -EBADFD, -ESTRPIPE, -EINTR}) {
    CAPTURE(error);
    Rig rig;
    rig.card.waits_at[2] = error;
    rig.play(5);
    CHECK(rig.ramp() == ramp(5));
    CHECK(rig.card.prepares == (error == -EPIPE || error == -EBADFD ? 2 : 1));
    CHECK(rig.sink->status().playing);
  }
  Rig gone;
  gone.card.waits_at[2] = -ENODEV;
  gone.play(5);
  CHECK(gone.events(CardEvent::kLost) == 1);
}

TEST_CASE("A card that is gone is given up; blocks keep their pace; the card is found again") {
  for (const long error : {-ENODEV, -ENOTTY, -EIO}) {
    CAPTURE(error);
    Rig rig;
    rig.card.at[kFirstBlockWrite + 3] = error;
    rig.card.present = true;
    rig.play(4);
    CHECK(rig.events(CardEvent::kLost) == 1);
    CHECK_FALSE(rig.sink->status().playing);

    rig.card.present = false;
    const std::int64_t before = rig.clock.now;
    rig.clock.now += 200'000'000;
    rig.poll();
    CHECK(rig.card.open_streams == 0);
    rig.play(750);
    CHECK(rig.clock.now - before == doctest::Approx(750.0 * kBlock / 48000 * 1e9).epsilon(0.01));

    rig.card.present = true;
    rig.clock.now += 6'000'000'000;
    rig.poll();
    rig.card.heard.clear();
    const std::uint64_t first = rig.number;
    rig.play(5);
    CHECK(rig.ramp().size() == 5 * kBlock);
    CHECK(rig.ramp().front() == static_cast<float>(first * kBlock + 1));
    CHECK(rig.silence() == kPrefill);
  }
}

TEST_CASE("A card whose clock has stopped is given up instead of stopping the engine's") {
  Rig rig;
  rig.card.at[kFirstBlockWrite + 3] = -EAGAIN;
  rig.card.wait_answer = 0;
  rig.play(4);
  CHECK(rig.events(CardEvent::kLost) == 1);
}

TEST_CASE("An error that never ends does not hold the audio thread") {
  Rig rig;
  for (int k = kFirstBlockWrite + 1; k < 10000; ++k) rig.card.at[k] = -EPIPE;
  rig.play(2);
  CHECK(rig.events(CardEvent::kLost) == 1);
  CHECK(rig.card.writes < 100);
}

TEST_CASE("A block has eight attempts, and eight more behind each part that was taken") {
  for (const int errors : {8, 9}) {
    CAPTURE(errors);
    Rig rig;
    for (int k = 0; k < errors; ++k) rig.card.at[kFirstBlockWrite + 3 + k] = -EINTR;
    rig.play(10);
    CHECK(rig.events(CardEvent::kLost) == (errors == 8 ? 0 : 1));
    if (errors == 8) CHECK(rig.ramp() == ramp(10));
  }
  Rig in_parts;
  for (int k = 0; k < 17; ++k) in_parts.card.at[kFirstBlockWrite + 3 + k] = k == 8 ? 20 : -EINTR;
  in_parts.play(10);
  CHECK(in_parts.ramp() == ramp(10));
}

TEST_CASE("A long buffer may be filled at once, and a tenth of a second more") {
  Rig rig(true, 300);
  rig.play(370);
  CHECK(rig.sink->status().playing);
  rig.play(10);
  CHECK_FALSE(rig.sink->status().playing);
  CHECK(rig.events(CardEvent::kLost) == 1);
}

TEST_CASE("A card that cannot be prepared is given up and closed before it is opened again") {
  Rig rig;
  rig.card.prepare_answer = -ENODEV;
  rig.play(1);
  CHECK(rig.events(CardEvent::kLost) == 1);
  CHECK(rig.card.open_streams == 1);
  rig.card.present = false;
  rig.clock.now += 200'000'000;
  rig.poll();
  CHECK(rig.card.open_streams == 0);
}

TEST_CASE("A device that never blocks is given up within a second, and the block clock pays back its lead") {
  Rig rig;
  const std::int64_t begin_ns = rig.clock.now;
  rig.play(750);  // a second
  CHECK(rig.events(CardEvent::kLost) == 1);
  CHECK_FALSE(rig.sink->status().playing);
  CHECK(rig.ramp().size() <= 110 * kBlock);  // the buffer and 0.1 s
  CHECK(static_cast<double>(rig.clock.now - begin_ns) == doctest::Approx(1e9).epsilon(0.01));
  rig.poll();
  CHECK(rig.card.open_streams == 0);
  CHECK(rig.sink->status().description.find("it has no clock") != std::string::npos);
  rig.clock.now += 59'000'000'000;
  rig.poll();
  CHECK(rig.opens == 1);  // not over and over
  rig.clock.now += 2'000'000'000;
  rig.poll();
  CHECK(rig.opens == 2);
  CHECK(rig.sink->status().playing);
}

TEST_CASE("A card that plays in time is no such device, however it drifts or bursts within its buffer") {
  const double block_ns = kBlock * 1e9 / 48000;
  for (const double speed : {0.5, 0.999, 1.0, 1.001, 1.02}) {
    CAPTURE(speed);
    PaceWatch watch;
    watch.start(0, block_ns, kPeriods * block_ns);
    bool in_time = true;
    for (int i = 1; i <= 750 * 60; ++i) {
      const int played = i / 64 * 64;  // takes 64 blocks at once, every 85 ms
      in_time = watch.taken(static_cast<std::int64_t>(played * block_ns / speed)) && in_time;
    }
    CHECK(in_time);
  }
  PaceWatch twice;
  twice.start(0, block_ns, kPeriods * block_ns);
  int taken = 1;
  while (taken < 10000 && twice.taken(static_cast<std::int64_t>(taken * block_ns / 2))) ++taken;
  CHECK(taken < 750);  // at double speed within a second
  CHECK(taken > 100);
}

TEST_CASE("A card that is lost soon after each opening is opened less and less often") {
  Rig rig;
  rig.card.wait_answer = -ENODEV;
  std::vector<std::int64_t> opened_ms;
  for (int ms = 0; ms < 30'000; ms += 10, rig.clock.now += 10'000'000) {
    const int before = rig.opens;
    rig.poll();
    if (rig.opens != before) opened_ms.push_back(ms);
    if (rig.sink->status().playing) rig.play(1);
  }
  CHECK(rig.opens < 13);
  CHECK(opened_ms.back() - opened_ms[opened_ms.size() - 2] >= 5000);
}

TEST_CASE("A missing card is looked for with pauses from 0.1 s doubling to 5 s") {
  Rig rig(false);
  CHECK(rig.opens == 1);
  for (const std::int64_t pause_ms : {100, 200, 400, 800, 1600, 3200, 5000, 5000}) {
    const int before = rig.opens;
    rig.clock.now += (pause_ms - 1) * 1'000'000;
    rig.poll();
    CHECK(rig.opens == before);
    rig.clock.now += 1'000'000;
    rig.poll();
    CHECK(rig.opens == before + 1);
  }
  CHECK(rig.sink->status().description == "sound card: no such device");
}

TEST_CASE("A device that hangs holds nobody up, is told, and plays once it answers") {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const auto told = [](const Rig& rig) { return rig.sink->status().description; };
  const auto hangs = [](Rig& rig) {
    const std::lock_guard<std::mutex> held(rig.card.answers);
    rig.sink->poll();
    rig.clock.now += 2 * kSecond;
    rig.sink->poll();
    CHECK(rig.sink->busy());
    CHECK_FALSE(rig.sink->status().playing);
    const std::int64_t before = rig.clock.now;
    rig.play(750);
    CHECK(rig.clock.now - before == doctest::Approx(kSecond).epsilon(0.01));
  };
  Rig opened(false);
  opened.card.present = true;
  opened.clock.now += kSecond;
  hangs(opened);
  CHECK(told(opened) == "sound card default: does not answer, it is being opened");
  opened.poll();
  CHECK(opened.sink->status().playing);

  Rig closed;
  closed.card.at[kFirstBlockWrite] = -ENODEV;
  closed.play(1);
  hangs(closed);
  CHECK(told(closed) == "sound card default: does not answer, it is being closed");
  closed.poll();
  CHECK(closed.sink->status().playing);
}
