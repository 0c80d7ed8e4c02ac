// What the audio thread reports to the recorder: every change of a field, and nothing else.
#include "run_record.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstring>
#include <new>
#include <type_traits>
#include <vector>

#include "engine/machine/other_fields.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

/// The fields of `state` over memory filled with `fill`: what is between them stays.
struct PaddedState {
  PaddedState(const MachineState& state, int fill) {
    std::memset(bytes, fill, sizeof bytes);
    auto* const fields = reinterpret_cast<MachineState*>(bytes);
    std::array<double, 256> values{};
    std::size_t count = 0, i = 0;
    for_each_field(state, [&](const auto& field) { values[count++] = static_cast<double>(field); });
    for_each_field(*fields, [&](auto& field) {
      using Field = std::decay_t<decltype(field)>;
      const auto value = static_cast<Field>(values[i++]);
      std::memcpy(&field, &value, sizeof value);
    });
  }
  const MachineState& get() const { return *std::launder(reinterpret_cast<const MachineState*>(bytes)); }

  alignas(MachineState) unsigned char bytes[sizeof(MachineState)];
};

MachineState drilling() {
  MachineState state;
  state.engine_rpm = 1800;
  state.boom[1].feed_pressure_bar = 85.5F;
  state.boom[1].rattling = Rattling::kOpen;
  state.boom[3].controls.decay_factor = 2;
  return state;
}

struct Reported {
  RunQueue records{16};
  std::atomic<std::uint64_t> lost{0};
  RunReporter reporter{records, lost};

  std::size_t count() const { return records.size_approx(); }
};

}  // namespace

TEST_CASE("A state of other padding but equal fields makes no record") {
  const PaddedState zeros(drilling(), 0x00), ones(drilling(), 0xff);
  REQUIRE(std::memcmp(zeros.bytes, ones.bytes, sizeof zeros.bytes) != 0);  // there is padding, and it differs
  Reported r;
  CHECK(r.reporter.report(0, 0, zeros.get()));
  CHECK_FALSE(r.reporter.report(0, 1, ones.get()));
  CHECK_FALSE(r.reporter.report(0, 2, zeros.get()));
  CHECK(r.count() == 1);
}

TEST_CASE("A change of any one field makes a record, with the state and its block") {
  const MachineState start = drilling();
  const std::vector<MachineState> others = tests::with_one_field_other(start);
  for (std::size_t changed = 0; changed < others.size(); ++changed) {
    CAPTURE(changed);
    const MachineState& next = others[changed];
    Reported r;
    r.reporter.report(7, 0, start);
    CHECK(r.reporter.report(7, 41, next));
    RunRecord record;
    REQUIRE(r.records.try_dequeue(record));
    REQUIRE(r.records.try_dequeue(record));
    CHECK(record.run == 7);
    CHECK(record.block == 41);
    CHECK(record.state == next);
    CHECK(record.state != start);
  }
}

TEST_CASE("The first state of each run makes a record, changed or not, and so does its end") {
  Reported r;
  CHECK(r.reporter.report(0, 0, drilling()));
  CHECK(r.reporter.report(1, 0, drilling()));
  r.reporter.report_end(1, 5);
  RunRecord record;
  while (r.records.try_dequeue(record)) {
  }
  CHECK(record.kind == RunRecord::Kind::kEnd);
  CHECK(record.block == 5);
}

TEST_CASE("A full queue counts what it drops") {
  RunQueue records(2);
  std::atomic<std::uint64_t> lost{0};
  RunReporter reporter(records, lost);
  MachineState state = drilling();
  for (int i = 0; i < 100; ++i) {
    state.engine_rpm += 1;
    reporter.report(0, i, state);
  }
  CHECK(lost == 100 - records.size_approx());
}
