// The real-time thread, its recorder and sessions: what was played is what is rendered again.
#include "audio_thread.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include "bench/formula_sounds.hpp"
#include "recorder.hpp"
#include "rigsound/session/session_folder.hpp"
#include "rigsound/session/session_states.hpp"
#include "state_exchange.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
namespace fs = std::filesystem;

namespace {

/// Keeps every block; as fast as it can, but for a breath that lets other threads run.
class KeepingSink : public audio::Sink {
 public:
  explicit KeepingSink(std::size_t samples) : samples_(samples) {}
  void write(const float* block, std::uint64_t number) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (number == 0) runs_.emplace_back();
    runs_.back().insert(runs_.back().end(), block, block + samples_);
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  std::vector<std::vector<float>> runs() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return runs_;
  }

 private:
  std::size_t samples_;
  mutable std::mutex mutex_;
  std::vector<std::vector<float>> runs_;
};

struct Setup {
  Setup() : sink(static_cast<std::size_t>(options.block * options.channels)) {
    fs::create_directories(folder);
    recorder.expect_run({"test", "0", options.seed, options.sample_rate, options.block, options.channels,
                         audio::SampleFormat::kFloat});
  }
  ~Setup() { fs::remove_all(folder); }

  std::unique_ptr<Engine> engine() const {
    return std::make_unique<Engine>(options, tools::formula_sounds());
  }

  /// Drills for `blocks` blocks of changing state, polling the recorder meanwhile.
  void drill(std::uint64_t blocks) {
    const std::uint64_t end = audio.figures().blocks + blocks;
    for (int i = 0; audio.figures().blocks < end; ++i) {
      exchange.change([&](SignalBoard& board) {
        board.take({{Signal::kEngineRpm}, 800.0 + i % 1000, Validity::kValid, 0.001 * i});
        board.take({{Signal::kFeedPressureBar}, static_cast<double>(i % 150), Validity::kValid, 0.001 * i});
        if (i % 50 == 20) board.hold({Signal::kFeedPressureBar}, 200);  // a user steps in
        if (i % 50 == 40) board.release({Signal::kFeedPressureBar});
      });
      recorder.poll(0.01 * i);
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
  }

  std::vector<float> rendered(const fs::path& session) const {
    session::SessionStates states(session);
    Engine again(options, tools::formula_sounds());
    KeepingSink kept(static_cast<std::size_t>(options.block * options.channels));
    std::vector<float> block = audio::make_block(options);
    audio::run_blocks(again, states, kept, block);
    return kept.runs().front();
  }

  EngineOptions options = tools::full_options();
  fs::path folder = fs::temp_directory_path() / ("rigsound_daemon_" + std::to_string(::getpid()));
  fs::path sessions = folder / "sessions";
  StateExchange exchange{SafetyOptions{}};
  KeepingSink sink;
  AudioThread audio{engine(), sink, exchange.handoff()};
  Recorder recorder{session::SessionFolder(sessions, 1 << 20), audio.records(), audio.figures()};
};

}  // namespace

TEST_CASE("A session renders the very samples that were played, over a change of engine too") {
  Setup s;
  s.audio.start();
  CHECK_FALSE(s.audio.scheduling().empty());
  s.drill(300);
  s.audio.offer_engine(s.engine());
  while (!s.audio.engine_taken()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  s.drill(300);
  s.audio.stop();
  s.recorder.finish();
  const auto runs = s.sink.runs();
  REQUIRE(runs.size() == 2);
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(s.sessions)) files.insert(entry.path());
  REQUIRE(files.size() == 2);
  CHECK(s.rendered(*files.begin()) == runs[0]);
  CHECK(s.rendered(*files.rbegin()) == runs[1]);
  CHECK(s.audio.figures().lost_records == 0);
}

TEST_CASE("A recorder that is not polled loses records, says so, and writes nothing false") {
  Setup s;
  s.audio.start();
  for (int i = 0; s.audio.figures().lost_records == 0; ++i)
    s.exchange.change([&](SignalBoard& board) {
      board.take({{Signal::kFeedPressureBar}, static_cast<double>(i % 290), Validity::kValid, 0});
    });
  s.recorder.poll(1);
  CHECK(s.recorder.wants_new_run(0));
  s.audio.stop();
  s.recorder.finish();
  CHECK_THROWS(
      session::SessionStates(session::newest_session(s.sessions)));  // not one chunk: it cannot be whole
}

TEST_CASE("A folder that cannot be written stops the recording, not the sound") {
  Setup s;
  std::ofstream(s.folder / "file") << "mine";
  Recorder recorder(session::SessionFolder(s.folder / "file" / "sessions", 1 << 20), s.audio.records(),
                    s.audio.figures());
  s.audio.start();
  while (s.audio.figures().blocks < 20) recorder.poll(0);
  recorder.poll(1);
  CHECK_FALSE(recorder.recording());
  CHECK(recorder.problem().find("/file/sessions: ") != std::string::npos);
  const std::uint64_t before = s.audio.figures().blocks;
  while (s.audio.figures().blocks < before + 20) recorder.poll(2);
  s.audio.stop();
}
