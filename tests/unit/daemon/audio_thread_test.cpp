// The real-time thread, its recorder and sessions: what was played is what is rendered again.
#include "audio_thread.hpp"

#include <doctest/doctest.h>
#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "bench/formula_sounds.hpp"
#include "recorder.hpp"
#include "rigsound/session/session_folder.hpp"
#include "rigsound/session/session_states.hpp"
#include "state_exchange.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
namespace fs = std::filesystem;

namespace {

/// Keeps every block and skip; as fast as it can, but for a breath that lets other threads run.
class KeepingSink : public audio::Sink {
 public:
  explicit KeepingSink(std::size_t samples) : samples_(samples) {}
  void write(const float* block, std::uint64_t number) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (number == 0) runs_.emplace_back();
    runs_.back().insert(runs_.back().end(), block, block + samples_);
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    if (runs_.size() == 1 && number == stall_at) std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  }
  void skip(std::uint64_t blocks) override { runs_.back().resize(runs_.back().size() + samples_ * blocks); }
  std::vector<std::vector<float>> runs() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return runs_;
  }

  std::uint64_t stall_at = UINT64_MAX;  ///< a block that takes 1.5 s, as if the machine stood still

 private:
  std::size_t samples_;
  mutable std::mutex mutex_;
  std::vector<std::vector<float>> runs_;
};

struct Setup {
  Setup() : sink(static_cast<std::size_t>(options.block * options.channels)) {
    fs::create_directories(folder);
    recorder.expect_run({"test", "0", "", options.seed, options.sample_rate, options.block, options.channels,
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

  /// From the first recorded to the last.
  std::set<fs::path> session_files() const {
    std::set<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(sessions)) files.insert(entry.path());
    return files;
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
  const std::set<fs::path> files = s.session_files();
  REQUIRE(files.size() == 2);
  CHECK(s.rendered(*files.begin()) == runs[0]);
  CHECK(s.rendered(*files.rbegin()) == runs[1]);
  CHECK(s.audio.figures().lost_records == 0);
}

TEST_CASE("The audio thread asks for real time, and says whether it has it") {
  std::string expected = "SCHED_FIFO 70";
  std::thread([&] {  // what any thread of this process is granted
    const sched_param wanted{70};
    if (const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wanted); error != 0)
      expected = std::string("normal priority, SCHED_FIFO refused: ") + std::strerror(error);
  })
      .join();
  Setup s;
  s.audio.start();
  CHECK(s.audio.scheduling() == expected);
}

TEST_CASE("A stall of over a second is counted, and silence in what the session renders") {
  Setup s;
  s.sink.stall_at = 100;
  s.audio.start();
  s.drill(300);
  s.audio.stop();
  s.recorder.finish();
  REQUIRE(s.audio.figures().clock_jumps >= 1);
  const std::uint64_t skipped = s.audio.figures().skipped_blocks;
  CHECK(skipped >= 1124);  // of 1.5 s at 750 a second
  const std::size_t samples = static_cast<std::size_t>(s.options.block * s.options.channels);
  std::vector<float> played = s.sink.runs()[0];
  const std::vector<float> rendered = s.rendered(session::newest_session(s.sessions));
  CHECK(rendered.size() == played.size() + samples * skipped);
  if (s.audio.figures().clock_jumps == 1) {  // the machine itself may stall
    played.insert(played.begin() + static_cast<std::ptrdiff_t>(101 * samples), samples * skipped, 0.0F);
    CHECK(rendered == played);
  }
  CHECK(session::SessionStates(session::newest_session(s.sessions)).ended_in_order());
}

TEST_CASE("A stall between two engines is counted, and is no part of either's session") {
  Setup s;
  s.sink.stall_at = 100;
  std::unique_ptr<Engine> next = s.engine();
  s.audio.start();
  s.drill(90);
  while (s.audio.figures().blocks < 100) std::this_thread::yield();
  s.audio.offer_engine(std::move(next));  // block 100 takes its time
  while (!s.audio.engine_taken()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  s.drill(50);
  s.audio.stop();
  s.recorder.finish();
  const auto runs = s.sink.runs();
  REQUIRE(runs.size() == 2);
  const std::set<fs::path> files = s.session_files();
  REQUIRE(files.size() == 2);
  if (s.audio.figures().clock_jumps != 1) return;  // the machine itself has stalled
  CHECK(session::SessionStates(*files.rbegin()).skipped() == 0);
  CHECK(s.rendered(*files.rbegin()) == runs[1]);
}

namespace {

RunRecord record(RunRecord::Kind kind, std::uint64_t block, std::uint64_t skipped = 0) {
  RunRecord made;
  made.kind = kind;
  made.block = block;
  made.skipped = skipped;
  return made;
}

}  // namespace

TEST_CASE("After a skip of over an hour the session has ended in order, and the next is due") {
  using Kind = RunRecord::Kind;
  for (const std::uint64_t hours : {1, 2}) {
    Setup s;
    RunQueue queue(16);
    AudioFigures figures;
    Recorder recorder(session::SessionFolder(s.folder / "r", 1 << 20), queue, figures);
    recorder.expect_run({"test", "0", "", 1, 48000, 64, 2, audio::SampleFormat::kFloat});
    queue.enqueue(record(Kind::kChange, 0));
    queue.enqueue(record(Kind::kSkip, 40, hours * 3600 * 750));
    recorder.poll(0);
    CHECK(recorder.recording() == (hours == 1));
    CHECK(recorder.wants_new_run(0) == (hours == 1 ? "" : "was interrupted for over an hour"));
    if (hours == 1) {
      queue.enqueue(record(Kind::kEnd, 50));
      recorder.finish();
    }
    const session::SessionStates session(session::newest_session(s.folder / "r"));
    CHECK(session.ended_in_order());
    CHECK(session.blocks() == (hours == 1 ? 50 : 40));
    CHECK(session.skipped() == (hours == 1 ? 3600 * 750 : 0));
    recorder.give_up("the sound set is gone");
    CHECK(recorder.wants_new_run(0).empty());  // not asked for again and again
  }
}

TEST_CASE("A session is full at its share of the limit, or at half of it where a new run disturbs nobody") {
  using Kind = RunRecord::Kind;
  Setup s;
  RunQueue queue(16);
  AudioFigures figures;
  Recorder recorder(session::SessionFolder(s.folder / "r", 40000), queue, figures);  // a share: 10 000
  recorder.expect_run({"test", "0", "", 1, 48000, 64, 2, audio::SampleFormat::kFloat});
  CHECK(recorder.wants_new_run(0).empty());
  RunRecord change = record(Kind::kChange, 0);
  for (std::uint64_t block = 0; recorder.bytes() <= 10000; ++block) {
    if (block > 0) {
      CHECK(recorder.wants_new_run(0).empty());
      CHECK(recorder.wants_new_run(2).empty());
      CHECK(recorder.wants_new_run(2.1) == (recorder.bytes() > 5000 ? "is full" : ""));
    }
    change.block = block;
    change.state.engine_rpm = static_cast<float>(block);
    queue.enqueue(change);
    figures.run_blocks = block + 1;
    recorder.poll(static_cast<double>(block));
  }
  CHECK(recorder.wants_new_run(0) == "is full");
  figures.lost_records = 1;
  CHECK(recorder.wants_new_run(0) == "has lost a record");
}

TEST_CASE("A block that takes longer to compute than to play is a deadline missed; any other is none") {
  Setup s;
  s.audio.start();
  s.drill(300);
  s.audio.stop();
  const AudioFigures& f = s.audio.figures();
  const double worst_s = static_cast<double>(f.worst_ns) * 1e-9;
  const double block_s = s.options.block / s.options.sample_rate;
  CHECK((f.deadline_misses > 0) == (worst_s > block_s));
  CHECK(f.busy_ns >= f.worst_ns);
  CHECK(static_cast<double>(f.busy_ns) < static_cast<double>(f.worst_ns) * static_cast<double>(f.blocks));
}

TEST_CASE("A recorder that is not polled loses records, says so, and writes nothing false") {
  Setup s;
  s.audio.start();
  for (int i = 0; s.audio.figures().lost_records == 0; ++i)
    s.exchange.change([&](SignalBoard& board) {
      board.take({{Signal::kFeedPressureBar}, static_cast<double>(i % 290), Validity::kValid, 0});
    });
  s.recorder.poll(1);
  CHECK(s.recorder.wants_new_run(0) == "has lost a record");
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
