#include "rigsound/file/scratch_file.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "rigsound/device_error.hpp"

using namespace rigsound;

TEST_CASE("What several threads append to a temporary file is read back whole") {
  ScratchFile file;
  std::vector<std::uint64_t> at(40);
  const auto text = [](std::size_t i) { return std::string(1000 + i, static_cast<char>('a' + i % 26)); };
  std::vector<std::thread> writers;
  for (std::size_t t = 0; t < 4; ++t)
    writers.emplace_back([&, t] {
      for (std::size_t i = t; i < at.size(); i += 4) at[i] = file.append(text(i).data(), text(i).size());
    });
  for (std::thread& writer : writers) writer.join();
  for (std::size_t i = 0; i < at.size(); ++i) {
    std::string back(1000 + i, ' ');
    file.read(at[i], back.data(), back.size());
    CHECK(back == text(i));
  }
}

TEST_CASE("No room for a temporary file, or less in it than is asked for, is an error of the device") {
  ScratchFile file;
  char byte = 0;
  CHECK_THROWS_AS(file.read(0, &byte, 1), DeviceError);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full{1000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &full);
  const std::string much(2000, 'x');
  CHECK_THROWS_WITH_AS(file.append(much.data(), much.size()),
                       doctest::Contains("no room for a temporary file"), DeviceError);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);
}
