// start_bench: what a rig of 200 banks costs before its first sample, as a folder and packed, recorded at the
// rig's rate and at another one. With --make FOLDER it writes those rigs into a folder; with --open RIG it is
// one start, in a process of its own, and prints s of CPU, MB resident, MB at most and page faults.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "bench/formula_sounds.hpp"
#include "bench/tool/row.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "unit/temporary_folder.hpp"

using namespace rigsound;

namespace {

constexpr int kBanks = 200;
constexpr double kRate = 48000, kMegabyte = 1e6;
constexpr double kWantedCpu_s = 0.2, kWantedMegabytes = 40;

/// Banks of the five situations at eight rod counts and five feed pressures, ten clicks of 80 ms each.
config::SoundSetParts many_banks(double sample_rate) {
  config::SoundSetParts parts;
  const SoundSet sounds = tools::formula_sounds(sample_rate);
  for (int i = 0; i < kBanks; ++i) {
    const BankUse& use = sounds.uses[static_cast<std::size_t>(i % kSituationCount)];
    config::StoredBank stored{sounds.banks[static_cast<std::size_t>(use.bank)],
                              {"start_bench", "", "", "bench"}};
    stored.bank.name = "bank" + std::to_string(i);
    config::BankEntry entry;
    entry.name = stored.bank.name, entry.situation = use.situation, entry.rods = 1 + i / kSituationCount % 8;
    const int series = i / (8 * kSituationCount);
    entry.feed_bar = 20 + 30.0 * (i % kSituationCount) + series;
    parts.index.banks.push_back(entry);
    parts.banks.push_back(std::move(stored));
  }
  return parts;
}

double click_megabytes(double sample_rate) {
  const double samples = static_cast<double>(tools::formula_sounds(sample_rate).banks[0].clicks[0].size());
  return samples * 10 * kBanks * sizeof(float) / kMegabyte;
}

struct Cost {
  double cpu_s = 0, resident_mb = 0, peak_mb = 0, faults = 0;
};

Cost cost_now() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  long pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / kMegabyte,
          static_cast<double>(usage.ru_maxrss) * 1024 / kMegabyte, static_cast<double>(usage.ru_minflt)};
}

/// Not inlined: structure_start_cost counts the instructions inside.
[[gnu::noinline]] void counted_start(const char* file) {
  config::Rig rig = config::load_rig(file);
  SoundSet sounds = config::load_sounds(rig);
  const Engine engine = config::build_engine(rig, std::move(sounds));
  const Cost cost = cost_now();
  std::printf("%.4f %.2f %.2f %.0f\n", cost.cpu_s, cost.resident_mb, cost.peak_mb, cost.faults);
}

/// The least of five starts: what others do on the machine only adds to it.
Cost cost_of(const std::string& program, const std::filesystem::path& rig) {
  Cost least{1e9, 1e9, 1e9, 1e9};
  for (int i = 0; i < 5; ++i) {
    FILE* const child = popen((program + " --open " + rig.string()).c_str(), "r");
    Cost cost;
    const bool read = child != nullptr && std::fscanf(child, "%lf %lf %lf %lf", &cost.cpu_s,
                                                      &cost.resident_mb, &cost.peak_mb, &cost.faults) == 4;
    if (child == nullptr || pclose(child) != 0 || !read) throw std::runtime_error("a start failed");
    least = {std::min(least.cpu_s, cost.cpu_s), std::min(least.resident_mb, cost.resident_mb),
             std::min(least.peak_mb, cost.peak_mb), std::min(least.faults, cost.faults)};
  }
  return least;
}

void rows(const std::string& program, const std::filesystem::path& rig, const std::string& what) {
  const Cost cost = cost_of(program, rig);
  const double clicks = click_megabytes(kRate);
  bench::print({what + ": load and build", bench::Bound::kAtMost, kWantedCpu_s, cost.cpu_s, "s CPU"});
  bench::print({what + ": resident beyond the clicks", bench::Bound::kAtMost, kWantedMegabytes,
                cost.resident_mb - clicks, "MB"});
  bench::print({what + ": at most resident beyond them", bench::Bound::kAtMost, kWantedMegabytes,
                cost.peak_mb - clicks, "MB"});
}

constexpr int kRates[] = {48000, 44100};

/// FOLDER/folder48000.toml, FOLDER/packed48000.toml, and of the other rate.
void make_rigs(const std::filesystem::path& folder) {
  for (const int rate : kRates) {
    const std::string of_rate = std::to_string(rate), packed = of_rate + ".rigset";
    config::PackedSet set;
    set.parts = many_banks(rate);
    config::save_parts(folder / of_rate, set.parts);
    write_file(folder / packed, config::packed(set));
    write_file(folder / ("folder" + of_rate + ".toml"), "[sound]\nset = \"" + of_rate + "\"\n");
    write_file(folder / ("packed" + of_rate + ".toml"), "[sound]\nset = \"" + packed + "\"\n");
  }
}

void measure(const std::string& program) {
  const test::TemporaryFolder folder;
  make_rigs(folder.path);
  for (const int rate : kRates)
    for (const std::string kind : {"folder", "packed"})
      rows(program, folder.path / (kind + std::to_string(rate) + ".toml"),
           std::to_string(rate) + " Hz, " + kind);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc == 3 && std::strcmp(argv[1], "--open") == 0) return counted_start(argv[2]), 0;
  if (argc == 3 && std::strcmp(argv[1], "--make") == 0) return make_rigs(argv[2]), 0;
  std::printf("%d banks, %.1f MB of clicks in a rig of %g Hz\n", kBanks, click_megabytes(kRate), kRate);
  measure(argv[0]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
